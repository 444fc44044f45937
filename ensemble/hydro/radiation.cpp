#include "hydro/radiation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "hydro/capytaine.hpp"
#include "hydro/rows.hpp"

namespace floes {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Block {
    Mat6 added = Mat6::Constant(nan);
    Mat6 damping = Mat6::Constant(nan);
};

/// What one of a pair of halves has the other gets; what neither has is zero by symmetry.
int mirror(Mat6& matrix) {
    int mirrored = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (!std::isnan(matrix(i, j)) || std::isnan(matrix(j, i))) continue;
            matrix(i, j) = matrix(j, i);
            ++mirrored;
        }
    }
    matrix = matrix.array().isNaN().select(0.0, matrix);
    return mirrored;
}

RadiationFile wamit(const std::vector<std::string_view>& lines, const std::string& file, const WamitUnits& units) {
    std::map<double, Block> by_period;
    for (std::size_t number = 0; number < lines.size(); ++number) {
        const auto wrong = [&](const std::string& what) {
            return InputError(
                fmt::format("{}:{}: {}; a row of WAMIT's .1 is period, i, j, added mass and, but for the "
                            "limits, damping",
                            file, number + 1, what));
        };
        const std::optional<std::vector<double>> row = numbers_of(lines[number]);
        if (row && row->empty()) continue;
        if (!row && number == 0) continue;  // a title
        if (!row) throw wrong("has a word that is no number");
        const bool limit = row->front() <= 0;
        if (row->size() != (limit ? 4U : 5U) && !(limit && row->size() == 5))
            throw wrong(fmt::format("has {} numbers", row->size()));
        for (const double value : *row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite, as at very low frequencies");
        const double i = (*row)[1];
        const double j = (*row)[2];
        if (i != std::floor(i) || j != std::floor(j) || i < 1 || j < 1)
            throw wrong("has something other than numbers of motions in its second and third column");
        if (i > 6 || j > 6) throw wrong("is of a second body, and one body of six motions is read");
        const auto a = static_cast<int>(i) - 1;
        const auto b = static_cast<int>(j) - 1;
        Block& block = by_period[row->front() < 0 ? -1.0 : row->front()];
        const double scale = units.density * std::pow(units.length, 3 + turns_of(a, b));  // ρL^k
        block.added(a, b) = (*row)[3] * scale;
        if (!limit) block.damping(a, b) = (*row)[4] * scale * 2 * std::numbers::pi / row->front();
    }
    RadiationFile found;
    int mirrored = 0;
    for (auto& [period, block] : by_period) {
        mirrored += mirror(block.added);
        mirror(block.damping);
        if (period < 0)
            found.at_zero = block.added;
        else if (period == 0)
            found.at_infinity = block.added;
        else
            found.points.push_back({2 * std::numbers::pi / period, block.added, block.damping});
    }
    std::ranges::reverse(found.points);  // of rising frequencies
    if (mirrored > 0)
        found.remarks.push_back(
            fmt::format("{}: {} of the matrices' elements stand in one half only and were mirrored", file, mirrored));
    return found;
}

RadiationFile nemoh(const std::vector<std::string_view>& lines, const std::string& file) {
    std::map<double, Block> by_frequency;
    int moves = 0;  // zones so far
    for (std::size_t number = 0; number < lines.size(); ++number) {
        const std::string_view line = lines[number];
        if (line.find("Zone") != std::string_view::npos || line.find("ZONE") != std::string_view::npos) {
            ++moves;
            continue;
        }
        const std::optional<std::vector<double>> row = numbers_of(line);
        if (!row || row->empty()) continue;
        const auto wrong = [&](const std::string& what) {
            return InputError(
                fmt::format("{}:{}: {}; a row of NEMOH's radiation coefficients is the frequency and an "
                            "added mass and a damping for each of six forces",
                            file, number + 1, what));
        };
        if (moves == 0 || moves > 6) throw wrong("is outside the zones of six motions");
        if (row->size() != 13) throw wrong(fmt::format("has {} numbers", row->size()));
        for (const double value : *row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite, as at very low frequencies");
        if (!(row->front() > 0)) throw wrong("has a frequency that is not above 0");
        Block& block = by_frequency[row->front()];
        for (int force = 0; force < 6; ++force) {
            block.added(force, moves - 1) = (*row)[static_cast<std::size_t>(1 + 2 * force)];
            block.damping(force, moves - 1) = (*row)[static_cast<std::size_t>(2 + 2 * force)];
        }
    }
    if (moves != 6)
        throw InputError(
            fmt::format("{}: has {} of the six zones, one for each motion; was the file cut off?", file, moves));
    RadiationFile found;
    for (auto& [frequency, block] : by_frequency) {
        mirror(block.added);
        mirror(block.damping);
        found.points.push_back({frequency, block.added, block.damping});
    }
    found.remarks.push_back(fmt::format(
        "{}: frequencies are taken in rad/s, as NEMOH writes them unless Nemoh.cal asks for Hz or s", file));
    return found;
}

void look_at_limits(RadiationFile& found, const std::string& file) {
    if (!found.at_zero && !found.at_infinity) {
        found.remarks.push_back(file + ": has neither the limit of zero nor that of infinite frequency");
        return;
    }
    if (!found.at_zero || !found.at_infinity) {
        found.remarks.push_back(
            fmt::format("{}: has no limit of {} frequency", file, found.at_zero ? "infinite" : "zero"));
        return;
    }
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
            double largest = 0;
            for (const RadiationPoint& other : found.points) largest = std::max(largest, other.damping(k, k));
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

namespace {

bool is_nemoh(std::string_view bytes) {
    return bytes.substr(0, 4096).find("VARIABLES") != std::string_view::npos;
}

}  // namespace

bool is_radiation(std::string_view bytes) {
    return is_netcdf(bytes) || is_nemoh(bytes);
}

RadiationFile read_radiation(std::string_view bytes, const std::string& file, const WamitUnits& units) {
    const bool netcdf = is_netcdf(bytes);
    const bool tec = !netcdf && is_nemoh(bytes);
    RadiationFile found = netcdf ? read_capytaine(bytes, file)
                          : tec  ? nemoh(lines_of(bytes), file)
                                 : wamit(lines_of(bytes), file, units);
    if (found.points.empty())
        throw InputError(fmt::format(
            "{}: has no periods; it is to be WAMIT's .1, NEMOH's RadiationCoefficients.tec or Capytaine's NetCDF",
            file));
    if (!netcdf && !tec) look_at_limits(found, file);
    look_at_damping(found, file);
    return found;
}

RadiationPoint radiation_at(const RadiationFile& radiation, double frequency) {
    const std::vector<RadiationPoint>& points = radiation.points;
    constexpr double rounding = 1e-9;
    if (frequency < points.front().frequency * (1 - rounding) || frequency > points.back().frequency * (1 + rounding))
        throw InputError(fmt::format("The file has periods from {:.4g} to {:.4g} s, and {:.4g} s is outside.",
                                     2 * std::numbers::pi / points.back().frequency,
                                     2 * std::numbers::pi / points.front().frequency,
                                     2 * std::numbers::pi / frequency));
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
