#include "hydro/radiation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace floes {

namespace {

constexpr std::array<const char*, 6> motions{"surge", "sway", "heave", "roll", "pitch", "yaw"};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Matrix6 empty_matrix(double value) {
    return Matrix6(6, std::vector<double>(6, value));
}

/// The numbers of a line; nothing if a word is none. Fortran writes 1.0D+00 too.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
    std::vector<double> found;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(" \t\r,", at)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t\r,", at), line.size());
        std::string word(line.substr(at, end - at));
        std::ranges::replace(word, 'D', 'E');
        std::ranges::replace(word, 'd', 'e');
        if (word.front() == '+') word.erase(0, 1);
        double value = 0;
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || rest != word.data() + word.size()) return std::nullopt;
        found.push_back(value);
        at = end;
    }
    return found;
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// 3, 4 or 5: the power of the length of ρL^k.
int power_of(std::size_t i, std::size_t j) {
    return 3 + (i >= 3 ? 1 : 0) + (j >= 3 ? 1 : 0);
}

struct Block {
    Matrix6 added = empty_matrix(nan);
    Matrix6 damping = empty_matrix(nan);
};

/// What one of a pair of halves has the other gets; what neither has is zero by symmetry.
int mirror(Matrix6& matrix) {
    int mirrored = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            if (!std::isnan(matrix[i][j])) continue;
            if (!std::isnan(matrix[j][i]) && i != j) {
                matrix[i][j] = matrix[j][i];
                ++mirrored;
            }
        }
    }
    for (std::vector<double>& row : matrix)
        for (double& value : row)
            if (std::isnan(value)) value = 0;
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
        const auto a = static_cast<std::size_t>(i) - 1;
        const auto b = static_cast<std::size_t>(j) - 1;
        Block& block = by_period[row->front() < 0 ? -1.0 : row->front()];
        const double scale = units.density * std::pow(units.length, power_of(a, b));
        block.added[a][b] = (*row)[3] * scale;
        if (!limit) block.damping[a][b] = (*row)[4] * scale * 2 * std::numbers::pi / row->front();
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
    std::size_t moves = 0;  // zones so far
    std::size_t forces = 0;
    for (std::size_t number = 0; number < lines.size(); ++number) {
        const std::string_view line = lines[number];
        if (line.find("Zone") != std::string_view::npos || line.find("ZONE") != std::string_view::npos) {
            ++moves;
            continue;
        }
        const std::optional<std::vector<double>> row = numbers_of(line);
        if (!row) {
            if (moves == 0 && line.find("\"A") != std::string_view::npos) ++forces;
            continue;
        }
        if (row->empty()) continue;
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
        for (std::size_t force = 0; force < 6; ++force) {
            block.added[force][moves - 1] = (*row)[1 + 2 * force];
            block.damping[force][moves - 1] = (*row)[2 + 2 * force];
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
    const double longest = found.points.front().added[0][0];
    const double shortest = found.points.back().added[0][0];
    const double zero = (*found.at_zero)[0][0];
    const double infinite = (*found.at_infinity)[0][0];
    if (std::abs(zero - longest) + std::abs(infinite - shortest) >
        std::abs(infinite - longest) + std::abs(zero - shortest))
        found.remarks.push_back(file +
                                ": the limits of zero and infinite frequency seem exchanged, as Capytaine 2.3 writes "
                                "them: A11 of the one continues the other end. They are not used");
}

void look_at_damping(RadiationFile& found, const std::string& file) {
    for (std::size_t k = 0; k < 6; ++k) {
        int negative = 0;
        double first = 0;
        for (RadiationPoint& point : found.points) {
            double largest = 0;
            for (const RadiationPoint& other : found.points) largest = std::max(largest, other.damping[k][k]);
            if (point.damping[k][k] >= 0) continue;
            if (negative++ == 0) first = point.frequency;
            point.damping[k][k] = 0;
        }
        if (negative > 0)
            found.remarks.push_back(
                fmt::format("{}: the damping in {} is negative at {} of {} frequencies, the lowest {:.4g} rad/s, and "
                            "taken as 0 there",
                            file, motions.at(k), negative, found.points.size(), first));
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

RadiationFile read_radiation(std::string_view text, const std::string& file, const WamitUnits& units) {
    const std::vector<std::string_view> lines = lines_of(text);
    const bool tec = text.substr(0, 4096).find("VARIABLES") != std::string_view::npos;
    RadiationFile found = tec ? nemoh(lines, file) : wamit(lines, file, units);
    if (found.points.empty())
        throw InputError(
            fmt::format("{}: has no periods; it is to be WAMIT's .1 or NEMOH's RadiationCoefficients.tec", file));
    if (!tec) look_at_limits(found, file);
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
    RadiationPoint found{frequency, empty_matrix(0), empty_matrix(0)};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            found.added[i][j] = std::lerp(a.added[i][j], b.added[i][j], share);
            found.damping[i][j] = std::lerp(a.damping[i][j], b.damping[i][j], share);
        }
    }
    return found;
}

std::optional<double> waterplane_by_waves(const RadiationFile& radiation, double density, double gravity,
                                          double depth) {
    const RadiationPoint& longest = radiation.points.front();
    const double frequency = longest.frequency;
    const double k = wave_number(frequency, gravity, depth);
    const double kh = k * depth;
    const double group = 0.5 * frequency / k * (1 + (std::isfinite(depth) && kh < 50 ? 2 * kh / std::sinh(2 * kh) : 0));
    const double square = longest.damping[2][2] / (density * frequency) * 4 * group * frequency / (gravity * k);
    if (!(square > 0)) return {};
    return std::sqrt(square);
}

}  // namespace floes
