#include "hydro/radiation.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/trial.hpp"

namespace floes {

namespace {

// Lines of numbers as Fortran writes them, and what WAMIT has in common in its files.

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

/// How many of two motions (0 to 5) are turns: the powers of the length that WAMIT's units have more.
int turns_of(int i, int j) {
    return (i >= 3 ? 1 : 0) + (j >= 3 ? 1 : 0);
}

/// The two motions (0 to 5) of a row of WAMIT, which stand in its columns `where`; `wrong` makes the error of the row.
template <class Wrong>
std::pair<int, int> motions_in(double i, double j, const char* where, const Wrong& wrong) {
    if (i != std::floor(i) || j != std::floor(j) || i < 1 || j < 1)
        throw wrong(fmt::format("has something other than numbers of motions in its {}", where));
    if (i > 6 || j > 6) throw wrong("is of a second body, and one body of six motions is read");
    return {static_cast<int>(i) - 1, static_cast<int>(j) - 1};
}

// The one door to NetCDF: what Capytaine wrote of a body, in either of its two containers.

struct Dimension {
    std::string name;
    std::size_t length = 0;
};

struct Variable {
    int id = 0;
    int type = 0;
    std::vector<Dimension> dimensions{};  // the last one runs fastest

    std::size_t size() const {
        std::size_t all = 1;
        for (const Dimension& one : dimensions) all *= one.length;
        return all;
    }
};

/// A file in memory, open as long as it lives.
class Dataset {
  public:
    /// `bytes` outlive it.
    Dataset(std::string_view bytes, std::string file) : file_(std::move(file)) {
        // It is opened for reading, so that nothing is written there.
        void* const memory = const_cast<char*>(bytes.data());
        check(nc_open_mem(file_.c_str(), NC_NOWRITE, bytes.size(), memory, &id_));
    }
    ~Dataset() { nc_close(id_); }
    Dataset(const Dataset&) = delete;
    Dataset& operator=(const Dataset&) = delete;

    InputError wrong(const std::string& what) const {
        return InputError(
            fmt::format("{}: {}; Capytaine's files have added_mass and radiation_damping over radiating_dof, "
                        "influenced_dof and a frequency",
                        file_, what));
    }

    std::optional<Variable> find(const char* name) const {
        Variable found;
        if (nc_inq_varid(id_, name, &found.id) != NC_NOERR) return {};
        int dimensions = 0;
        check(nc_inq_var(id_, found.id, nullptr, &found.type, &dimensions, nullptr, nullptr));
        std::vector<int> ids(static_cast<std::size_t>(dimensions));
        check(nc_inq_vardimid(id_, found.id, ids.data()));
        for (const int id : ids) {
            std::array<char, NC_MAX_NAME + 1> text{};
            Dimension& dimension = found.dimensions.emplace_back();
            check(nc_inq_dim(id_, id, text.data(), &dimension.length));
            dimension.name = text.data();
        }
        constexpr std::size_t most = 1 << 24;  // far more than a body has
        if (found.size() > most) throw wrong(fmt::format("{} has {} numbers", name, found.size()));
        return found;
    }

    Variable need(const char* name) const {
        const std::optional<Variable> found = find(name);
        if (!found) throw wrong(fmt::format("has no variable {}", name));
        return *found;
    }

    std::vector<double> numbers(const Variable& variable) const {
        std::vector<double> found(variable.size());
        check(nc_get_var_double(id_, variable.id, found.data()));
        return found;
    }

    std::optional<double> number(const char* name) const {
        const std::optional<Variable> variable = find(name);
        if (!variable) return {};
        if (variable->size() != 1)
            throw wrong(fmt::format("has {} values of {}, and a file of one is read", variable->size(), name));
        return numbers(*variable).front();
    }

    /// Letters along a last dimension in NetCDF-3, strings of any length in NetCDF-4.
    std::vector<std::string> words(const char* name) const {
        const Variable variable = need(name);
        std::vector<std::string> found;
        if (variable.type == NC_STRING) {
            std::vector<char*> texts(variable.size(), nullptr);
            check(nc_get_var_string(id_, variable.id, texts.data()));
            for (const char* text : texts) found.emplace_back(text == nullptr ? "" : text);
            nc_free_string(texts.size(), texts.data());
            return found;
        }
        if (variable.type != NC_CHAR || variable.dimensions.empty() || variable.dimensions.back().length == 0)
            throw wrong(fmt::format("{} has no names", name));
        std::vector<char> letters(variable.size());
        check(nc_get_var_text(id_, variable.id, letters.data()));
        const std::size_t length = variable.dimensions.back().length;
        for (std::size_t at = 0; at < letters.size(); at += length) {
            const auto from = letters.begin() + static_cast<std::ptrdiff_t>(at);
            found.emplace_back(from, std::find(from, from + static_cast<std::ptrdiff_t>(length), '\0'));
        }
        return found;
    }

  private:
    void check(int status) const {
        if (status != NC_NOERR) throw wrong(fmt::format("cannot be read as NetCDF ({})", nc_strerror(status)));
    }

    std::string file_;
    int id_ = 0;
};

constexpr std::array<const char*, 5> frequency_names{"omega", "freq", "period", "wavenumber", "wavelength"};

bool is_frequency(const std::string& name) {
    return std::ranges::find(frequency_names, name) != frequency_names.end();
}

/// The place of each motion in a dimension of six or fewer.
std::vector<int> motions_of(const Dataset& data, const char* name) {
    std::vector<int> found;
    std::set<std::string> bodies;
    for (std::string word : data.words(name)) {
        if (const std::size_t end = word.rfind("__"); end != std::string::npos) {
            bodies.insert(word.substr(0, end));
            word.erase(0, end + 2);
        }
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        const auto motion = std::ranges::find(hydrodynamic_motions, std::string_view(word));
        if (motion == hydrodynamic_motions.end())
            throw data.wrong(
                fmt::format("has a motion \"{}\", and surge, sway, heave, roll, pitch and yaw are read", word));
        const auto number = static_cast<int>(motion - hydrodynamic_motions.begin());
        if (std::ranges::find(found, number) != found.end()) throw data.wrong(fmt::format("has {} twice", word));
        found.push_back(number);
    }
    if (bodies.size() > 1)
        throw data.wrong(fmt::format("is of the bodies {}, and a file of one body is read", fmt::join(bodies, ", ")));
    return found;
}

/// rad/s, of each row.
std::vector<double> frequencies_of(const Dataset& data, std::size_t rows) {
    constexpr double turn = 2 * std::numbers::pi;
    std::vector<double> found;
    if (const std::optional<Variable> omega = data.find("omega")) {
        found = data.numbers(*omega);
    } else if (const std::optional<Variable> hertz = data.find("freq")) {
        for (const double value : data.numbers(*hertz)) found.push_back(turn * value);
    } else {
        for (const double value : data.numbers(data.need("period"))) found.push_back(turn / value);
    }
    if (found.size() != rows)
        throw data.wrong(fmt::format("has {} frequencies for {} rows of added mass", found.size(), rows));
    return found;
}

/// A matrix for each frequency; what no motion of the file touches is zero.
std::vector<Mat6> matrices_of(const Dataset& data, const char* name, const std::vector<int>& radiating,
                              const std::vector<int>& influenced) {
    const Variable variable = data.need(name);
    struct Axis {
        std::size_t length = 1;
        std::size_t stride = 0;
    };
    Axis by_frequency;
    Axis by_radiating;
    Axis by_influenced;
    std::size_t stride = 1;
    for (auto dimension = variable.dimensions.rbegin(); dimension != variable.dimensions.rend(); ++dimension) {
        const Axis axis{dimension->length, stride};
        stride *= dimension->length;
        if (dimension->name == "radiating_dof")
            by_radiating = axis;
        else if (dimension->name == "influenced_dof")
            by_influenced = axis;
        else if (is_frequency(dimension->name))
            by_frequency = axis;
        else if (dimension->length != 1)
            throw data.wrong(fmt::format("has {} along {} of {}, and a file of one is read", dimension->length,
                                         dimension->name, name));
    }
    if (by_radiating.length != radiating.size() || by_influenced.length != influenced.size())
        throw data.wrong(fmt::format("{} has {} by {} motions for {} and {} names", name, by_influenced.length,
                                     by_radiating.length, influenced.size(), radiating.size()));
    const std::vector<double> numbers = data.numbers(variable);
    std::vector<Mat6> found;
    for (std::size_t row = 0; row < by_frequency.length; ++row) {
        Mat6& matrix = found.emplace_back(Mat6::Zero());
        for (std::size_t i = 0; i < influenced.size(); ++i)
            for (std::size_t j = 0; j < radiating.size(); ++j)
                matrix(influenced[i], radiating[j]) =
                    numbers.at(row * by_frequency.stride + i * by_influenced.stride + j * by_radiating.stride);
    }
    return found;
}

/// Of the hull's own stiffness in heave, m²; 0 without it.
double waterplane_of(const Dataset& data, const std::vector<int>& radiating, const std::vector<int>& influenced,
                     double weight_of_water) {
    if (!data.find("hydrostatic_stiffness")) return 0;
    const double heave = matrices_of(data, "hydrostatic_stiffness", radiating, influenced).front()(2, 2);
    return std::isfinite(heave) ? std::max(0.0, heave / weight_of_water) : 0;
}

std::string missing_motions(const std::vector<int>& radiating) {
    std::vector<std::string_view> missing;
    for (int k = 0; k < 6; ++k)
        if (std::ranges::find(radiating, k) == radiating.end())
            missing.push_back(hydrodynamic_motions.at(static_cast<std::size_t>(k)));
    return fmt::format("{}", fmt::join(missing, ", "));
}

/// Judged by the first bytes: NetCDF-3, or HDF5 as NetCDF-4 is.
bool is_netcdf(std::string_view bytes) {
    return bytes.starts_with("CDF\x01") || bytes.starts_with("CDF\x02") || bytes.starts_with("CDF\x05") ||
           bytes.starts_with("\x89HDF\r\n\x1a\n");
}

RadiationFile read(std::string_view bytes, const std::string& file) {
    const Dataset data(bytes, file);
    if (const double speed = data.number("forward_speed").value_or(0); speed != 0)
        throw data.wrong(fmt::format("is of a hull at a forward speed of {:g} m/s, and one at rest is read", speed));
    const std::vector<int> radiating = motions_of(data, "radiating_dof");
    const std::vector<int> influenced = motions_of(data, "influenced_dof");
    const std::vector<Mat6> added = matrices_of(data, "added_mass", radiating, influenced);
    const std::vector<Mat6> damping = matrices_of(data, "radiation_damping", radiating, influenced);
    if (damping.size() != added.size()) throw data.wrong("has not as many rows of damping as of added mass");
    const std::vector<double> frequencies = frequencies_of(data, added.size());

    RadiationFile found;
    std::vector<double> left_out;
    for (std::size_t row = 0; row < frequencies.size(); ++row) {
        const double frequency = frequencies[row];
        if (added[row].hasNaN() || (std::isfinite(frequency) && damping[row].hasNaN())) {
            left_out.push_back(frequency);
        } else if (frequency == 0) {
            found.at_zero = added[row];
        } else if (std::isinf(frequency)) {
            found.at_infinity = added[row];
        } else if (frequency > 0) {
            found.points.push_back({frequency, added[row], damping[row]});
        } else {
            throw data.wrong(fmt::format("has a frequency of {:g} rad/s", frequency));
        }
    }
    std::ranges::sort(found.points, {}, &RadiationPoint::frequency);
    if (!left_out.empty())
        found.remarks.push_back(fmt::format(
            "{}: {} of its {} frequencies have numbers that are none, at {:.4g} to {:.4g} rad/s, and are "
            "left out; in shallow water Capytaine has them where waves are longest",
            file, left_out.size(), frequencies.size(), std::ranges::min(left_out), std::ranges::max(left_out)));
    if (const std::string missing = missing_motions(radiating); !missing.empty())
        found.remarks.push_back(fmt::format("{}: has nothing about {}, which is taken as 0", file, missing));
    const double density = data.number("rho").value_or(0);
    const double gravity = data.number("g").value_or(0);
    if (density > 0 && gravity > 0)
        found.water = {density, gravity, data.number("water_depth").value_or(std::numeric_limits<double>::infinity()),
                       waterplane_of(data, radiating, influenced, density * gravity)};
    if (const std::optional<Variable> centre = data.find("rotation_center"); centre && centre->size() == 3) {
        const std::vector<double> place = data.numbers(*centre);
        const Vec3 point(place[0], place[1], place[2]);
        if (point.allFinite()) found.reference = point;
    }
    return found;
}

/// One body by the names of variables, dimensions and motions: their order is another from Capytaine 3.0 on. Rows with
/// a number that is none, as at low frequencies, are left out, with a remark. Throws InputError for what is no such
/// file, for several bodies, depths or speeds, and for motions other than the six.
RadiationFile read_capytaine(std::string_view bytes, const std::string& file) {
    if (const int signal = signal_of_trial([&] { read(bytes, file); }); signal != 0)
        throw InputError(fmt::format("{}: is damaged: NetCDF ends with signal {} over it", file, signal));
    return read(bytes, file);
}

// WAMIT and NEMOH.

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
        const auto [a, b] = motions_in((*row)[1], (*row)[2], "second and third column", wrong);
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

namespace {

constexpr std::size_t of_wamit = 3;
constexpr std::size_t of_nemoh = 6;

}  // namespace

bool is_hydrostatic(std::string_view text) {
    for (const std::string_view line : lines_of(text))
        if (const std::optional<std::vector<double>> row = numbers_of(line); row && !row->empty())
            return row->size() == of_wamit || row->size() == of_nemoh;
    return false;
}

Mat6 read_hydrostatics(std::string_view text, const std::string& file, const WamitUnits& units, double gravity) {
    Mat6 found = Mat6::Zero();
    int rows_of_nemoh = 0;
    int number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        const auto wrong = [&](const std::string& what) {
            return InputError(fmt::format(
                "{}:{}: {}; a row of WAMIT's .hst is i, j and the stiffness, one of NEMOH's KH.dat six of them", file,
                number, what));
        };
        const std::optional<std::vector<double>> row = numbers_of(line);
        if (row && row->empty()) continue;
        if (!row && number == 1) continue;  // a title
        if (!row) throw wrong("has a word that is no number");
        for (const double value : *row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite");
        if (row->size() == of_nemoh && rows_of_nemoh < 6) {
            for (int j = 0; j < 6; ++j) found(rows_of_nemoh, j) = (*row)[static_cast<std::size_t>(j)];
            ++rows_of_nemoh;
            continue;
        }
        if (row->size() != of_wamit || rows_of_nemoh > 0) throw wrong(fmt::format("has {} numbers", row->size()));
        const auto [a, b] = motions_in((*row)[0], (*row)[1], "first two columns", wrong);
        found(a, b) = (*row)[2] * units.density * gravity * std::pow(units.length, 2 + turns_of(a, b));  // ρgL^k
    }
    if (rows_of_nemoh > 0 && rows_of_nemoh < 6)
        throw InputError(fmt::format("{}: has {} of six rows; was the file cut off?", file, rows_of_nemoh));
    if (!(found(2, 2) > 0))
        throw InputError(fmt::format(
            "{}: has no stiffness in heave, which every hull in the waterline has; did the program write it?", file));
    return found;
}

}  // namespace floes
