#include "hydro/radiation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "hydro/capytaine.hpp"
#include "hydro/radiation_tables.hpp"

namespace floes {

namespace {

/// The largest that each motion has in the file; of one that has next to nothing itself, as yaw of a round hull, a
/// hundredth of what the others of its kind have.
Vec6 largest_of(const RadiationFile& radiation, Mat6 RadiationPoint::*matrix) {
    Vec6 found = Vec6::Zero();
    for (const RadiationPoint& point : radiation.points) found = found.cwiseMax((point.*matrix).diagonal().cwiseAbs());
    return no_less_than(found, 1e-4);
}

/// A hull at rest has symmetric matrices; one half of a contradiction is wrong, and so is the mean of both.
void look_at_halves(RadiationFile& found, const std::string& file, const char* name, Mat6 RadiationPoint::*matrix) {
    constexpr double much = 0.1;   // of the root of what the two motions have themselves
    constexpr double gross = 0.5;  // NEMOH's cylinder (WEC-Sim) has 0.24 at its highest frequencies
    const Vec6 largest = largest_of(found, matrix);
    double worst = 0;
    for (const RadiationPoint& point : found.points) {
        const Mat6& m = point.*matrix;
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < i; ++j) {
                const double own = std::sqrt(largest[i] * largest[j]);
                const double apart = std::abs(m(i, j) - m(j, i));
                if (apart > gross * own)
                    throw InputError(
                        "{}: has {} of {:.4g} for {} {} and of {:.4g} for {} {} at {:.4g} s; such a matrix is "
                        "symmetric, so one of the two is wrong",
                        file, name, m(i, j), i + 1, j + 1, m(j, i), j + 1, i + 1, period_of(point.frequency));
                worst = std::max(worst, own > 0 ? apart / own : 0);
            }
        }
    }
    if (worst > much)
        found.remarks.push_back(fmt::format(
            "{}: the two halves of its {} differ by up to {:.0f} %; their mean is taken", file, name, 100 * worst));
}

void look_at_limits(RadiationFile& found, const std::string& file) {
    if (!found.at_zero || !found.at_infinity) return;
    const double longest = found.points.front().added(0, 0);
    const double shortest = found.points.back().added(0, 0);
    const double zero = (*found.at_zero)(0, 0);
    const double infinite = (*found.at_infinity)(0, 0);
    if (std::abs(zero - longest) + std::abs(infinite - shortest) >
        std::abs(infinite - longest) + std::abs(zero - shortest))
        found.remarks.push_back(file +
                                ": the limits of zero and infinite frequency seem exchanged, as Capytaine 2.3 writes "
                                "them: A11 of the one continues the other end. They are not used");
}

void look_at_damping(RadiationFile& found, const std::string& file) {
    for (int k = 0; k < 6; ++k) {
        int negative = 0;
        double first = 0;
        for (RadiationPoint& point : found.points) {
            if (point.damping(k, k) >= 0) continue;
            if (negative++ == 0) first = point.frequency;
            point.damping(k, k) = 0;
        }
        if (negative > 0)
            found.remarks.push_back(fmt::format(
                "{}: the damping in {} is negative at {} of {} frequencies, the lowest {:.4g} rad/s, and "
                "taken as 0 there",
                file, hydrodynamic_motions.at(static_cast<std::size_t>(k)), negative, found.points.size(), first));
    }
}

/// k of tanh(k h) g k = ω², 1/m.
double wave_number(double frequency, double gravity, double depth) {
    const double deep = frequency * frequency / gravity;
    if (!std::isfinite(depth)) return deep;
    double k = std::max(deep, frequency / std::sqrt(gravity * depth));
    for (int i = 0; i < 50; ++i) {
        const double t = std::tanh(k * depth);
        const double f = gravity * k * t - frequency * frequency;
        k -= f / (gravity * (t + k * depth * (1 - t * t)));
    }
    return k;
}

}  // namespace

Vec6 no_less_than(Vec6 own, double share) {
    own.head<3>() = own.head<3>().cwiseMax(share * own.head<3>().maxCoeff());
    own.tail<3>() = own.tail<3>().cwiseMax(share * own.tail<3>().maxCoeff());
    return own;
}

bool is_radiation(std::string_view bytes) {
    return is_netcdf(bytes) || is_nemoh(bytes);
}

RadiationFile read_radiation(std::string_view bytes, const std::string& file, const WamitUnits& units) {
    const bool netcdf = is_netcdf(bytes);
    const bool tec = !netcdf && is_nemoh(bytes);
    RadiationFile found = netcdf ? read_capytaine(bytes, file)
                          : tec  ? read_nemoh(bytes, file)
                                 : read_wamit(bytes, file, units);
    if (found.points.empty())
        throw InputError(
            "{}: has no periods; it is to be WAMIT's .1, NEMOH's RadiationCoefficients.tec or Capytaine's NetCDF",
            file);
    look_at_halves(found, file, "added mass", &RadiationPoint::added);
    look_at_halves(found, file, "damping", &RadiationPoint::damping);
    look_at_limits(found, file);
    look_at_damping(found, file);
    return found;
}

std::string extent_of(const RadiationFile& radiation) {
    const std::size_t count = radiation.points.size();
    std::string text = fmt::format("{} period{}", count, count == 1 ? "" : "s");
    const double shortest = period_of(radiation.points.back().frequency);
    text += count == 1
                ? fmt::format(", {:.4g} s", shortest)
                : fmt::format(" from {:.4g} to {:.4g} s", shortest, period_of(radiation.points.front().frequency));
    text += fmt::format("; {} of 36 elements", radiation.elements);
    if (radiation.mirrored > 0) text += fmt::format(", {} of them by symmetry from the other half", radiation.mirrored);
    text += radiation.elements < 36 ? ", the others 0 by symmetry" : "";
    const bool zero = radiation.at_zero.has_value();
    const bool infinite = radiation.at_infinity.has_value();
    return text + "; " +
           (zero && infinite ? "the limits of zero and infinite frequency"
            : zero           ? "no limit of infinite frequency"
            : infinite       ? "no limit of zero frequency"
                             : "neither the limit of zero nor that of infinite frequency");
}

RadiationPoint radiation_at(const RadiationFile& radiation, double frequency) {
    FLOES_EXPECTS(!radiation.points.empty());
    const std::vector<RadiationPoint>& points = radiation.points;
    constexpr double rounding = 1e-9;
    if (frequency < points.front().frequency * (1 - rounding) || frequency > points.back().frequency * (1 + rounding))
        throw InputError("The file has periods from {:.4g} to {:.4g} s, and {:.4g} s is outside.",
                         period_of(points.back().frequency), period_of(points.front().frequency), period_of(frequency));
    std::size_t next = 0;
    while (next + 1 < points.size() && points[next].frequency < frequency) ++next;
    const RadiationPoint& b = points[next];
    if (next == 0 || b.frequency <= frequency) return b;
    const RadiationPoint& a = points[next - 1];
    const double share = (frequency - a.frequency) / (b.frequency - a.frequency);
    return {frequency, a.added + share * (b.added - a.added), a.damping + share * (b.damping - a.damping)};
}

RadiationPoint radiation_at(const RadiationFile& radiation, const std::array<double, 6>& frequencies) {
    const double least = radiation.points.front().frequency;
    const double most = radiation.points.back().frequency;
    RadiationPoint found;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const double mean =
                0.5 * (frequencies.at(static_cast<std::size_t>(i)) + frequencies.at(static_cast<std::size_t>(j)));
            const RadiationPoint at = radiation_at(radiation, std::clamp(mean, least, most));
            found.added(i, j) = at.added(i, j);
            found.damping(i, j) = at.damping(i, j);
        }
    }
    return found;
}

namespace {

struct Doubt {
    double share = 0;  ///< of the motion's largest damping
    std::string where{};
};

/// See doubts(). Nothing where the file has the frequency itself or none below or above it.
Doubt doubt_in(const RadiationFile& radiation, int motion, double frequency, double largest) {
    const std::vector<RadiationPoint>& points = radiation.points;
    const auto next = std::ranges::lower_bound(points, frequency, {}, &RadiationPoint::frequency);
    if (next == points.begin() || next == points.end() || !(largest > 0)) return {};
    const auto b = static_cast<std::size_t>(next - points.begin());
    const std::size_t a = b - 1;
    const auto damping = [&](std::size_t k) { return points[k].damping(motion, motion); };
    const auto off_without = [&](std::size_t k) {
        if (k == 0 || k + 1 == points.size()) return 0.0;
        const double share =
            (points[k].frequency - points[k - 1].frequency) / (points[k + 1].frequency - points[k - 1].frequency);
        return std::abs(damping(k) - std::lerp(damping(k - 1), damping(k + 1), share));
    };
    const double ratio = points[b].frequency / points[a].frequency;
    const double share = (frequency - points[a].frequency) / (points[b].frequency - points[a].frequency);
    const double hidden = (ratio - 1) * (ratio - 1) / ratio * std::max(std::abs(damping(a)), std::abs(damping(b)));
    const double most = std::max({off_without(a), off_without(b), hidden});
    constexpr double little = 0.1;  // less damping than this share of ω A matters little, whatever it is
    const double scale = std::max(largest, little * frequency * std::abs(points[b].added(motion, motion)));
    return {4 * share * (1 - share) * most / scale,
            fmt::format("at {:.4g} s, between {:.4g} and {:.4g} s", period_of(frequency),
                        period_of(points[b].frequency), period_of(points[a].frequency))};
}

}  // namespace

std::string doubts(const RadiationFile& radiation, const std::string& file, const std::array<double, 6>& frequencies) {
    constexpr double said = 0.1;
    constexpr double refused = 0.5;
    const Vec6 largest = largest_of(radiation, &RadiationPoint::damping);
    std::map<std::string, std::vector<std::string>> found;
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const int motion = static_cast<int>(k);
        const auto [share, where] = doubt_in(radiation, motion, frequencies.at(k), largest[motion]);
        if (share > refused)
            throw InputError(
                "{}: has no period near enough to know the damping in {} {}; take a file with more periods there, or a "
                "period that it has",
                file, hydrodynamic_motions.at(k), where);
        if (share > said) found[where].push_back(fmt::format("{} {:.0f} %", hydrodynamic_motions.at(k), 100 * share));
    }
    if (found.empty()) return {};
    std::vector<std::string> places;
    for (const auto& [where, motions] : found) places.push_back(fmt::format("{}: {}", where, fmt::join(motions, ", ")));
    return fmt::format(
        "{}: has few periods for interpolated damping, which may be off by so much of the largest of its "
        "motion {}",
        file, fmt::join(places, "; "));
}

Mat6 about_origin(const Mat6& matrix, const Vec3& reference) {
    // The reference point moves by the origin's motion and, with turns θ, by θ × r; work is the same of either.
    Mat6 moves = Mat6::Identity();
    moves.topRightCorner<3, 3>() << 0, reference.z(), -reference.y(),  //
        -reference.z(), 0, reference.x(),                              //
        reference.y(), -reference.x(), 0;
    return moves.transpose() * matrix * moves;
}

std::optional<double> waterplane_by_waves(const RadiationFile& radiation, double density, double gravity,
                                          double depth) {
    const RadiationPoint& longest = radiation.points.front();
    const double frequency = longest.frequency;
    const double k = wave_number(frequency, gravity, depth);
    const double kh = k * depth;
    const double group = 0.5 * frequency / k * (1 + (std::isfinite(depth) && kh < 50 ? 2 * kh / std::sinh(2 * kh) : 0));
    const double square = longest.damping(2, 2) / (density * frequency) * 4 * group * frequency / (gravity * k);
    if (!(square > 0)) return {};
    return std::sqrt(square);
}

double longest_wave(const RadiationFile& radiation, double gravity, double depth) {
    return 2 * std::numbers::pi / wave_number(radiation.points.front().frequency, gravity, depth);
}

}  // namespace floes
