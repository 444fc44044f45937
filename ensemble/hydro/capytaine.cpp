#include "hydro/capytaine.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/trial.hpp"
#include "hydro/rows.hpp"

namespace floes {

namespace {

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

    template <class... Values>
    InputError wrong(fmt::format_string<Values...> what, Values&&... values) const {
        return InputError(
            "{}: {}; Capytaine's files have added_mass and radiation_damping over radiating_dof, influenced_dof and a "
            "frequency",
            file_, fmt::format(what, std::forward<Values>(values)...));
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
        if (found.size() > most) throw wrong("{} has {} numbers", name, found.size());
        return found;
    }

    Variable need(const char* name) const {
        const std::optional<Variable> found = find(name);
        if (!found) throw wrong("has no variable {}", name);
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
            throw wrong("has {} values of {}, and a file of one is read", variable->size(), name);
        return numbers(*variable).front();
    }

    /// The unit that a variable says it has; empty: none.
    std::string unit_of(const Variable& variable) const {
        std::size_t length = 0;
        if (nc_inq_attlen(id_, variable.id, "units", &length) != NC_NOERR || length > NC_MAX_NAME) return {};
        std::string text(length, ' ');
        if (nc_get_att_text(id_, variable.id, "units", text.data()) != NC_NOERR) return {};
        return text.substr(0, text.find('\0'));
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
            throw wrong("{} has no names", name);
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
        if (status != NC_NOERR) throw wrong("cannot be read as NetCDF ({})", nc_strerror(status));
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
        word = lower(word);
        const auto motion = std::ranges::find(hydrodynamic_motions, word);
        if (motion == hydrodynamic_motions.end())
            throw data.wrong("has a motion \"{}\", and surge, sway, heave, roll, pitch and yaw are read", word);
        const auto number = static_cast<int>(motion - hydrodynamic_motions.begin());
        if (std::ranges::find(found, number) != found.end()) throw data.wrong("has {} twice", word);
        found.push_back(number);
    }
    if (bodies.size() > 1)
        throw data.wrong("is of the bodies {}, and a file of one body is read", fmt::join(bodies, ", "));
    return found;
}

/// rad/s, of each row.
std::vector<double> frequencies_of(const Dataset& data, std::size_t rows) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto numbers = [&](const char* name, const char* unit) {
        const Variable variable = data.need(name);
        const std::string said = data.unit_of(variable);
        if (!said.empty() && said != unit) throw data.wrong("has {} in {}, and Capytaine's is in {}", name, said, unit);
        return data.numbers(variable);
    };
    std::vector<double> found;
    if (data.find("omega")) {
        found = numbers("omega", "rad/s");
    } else if (data.find("freq")) {
        for (const double value : numbers("freq", "Hz")) found.push_back(turn * value);
    } else {
        for (const double value : numbers("period", "s")) found.push_back(turn / value);
    }
    if (found.size() != rows) throw data.wrong("has {} frequencies for {} rows of added mass", found.size(), rows);
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
            throw data.wrong("has {} along {} of {}, and a file of one is read", dimension->length, dimension->name,
                             name);
    }
    if (by_radiating.length != radiating.size() || by_influenced.length != influenced.size())
        throw data.wrong("{} has {} by {} motions for {} and {} names", name, by_influenced.length, by_radiating.length,
                         influenced.size(), radiating.size());
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

RadiationFile read(std::string_view bytes, const std::string& file) {
    const Dataset data(bytes, file);
    if (const double speed = data.number("forward_speed").value_or(0); speed != 0)
        throw data.wrong("is of a hull at a forward speed of {:g} m/s, and one at rest is read", speed);
    const std::vector<int> radiating = motions_of(data, "radiating_dof");
    const std::vector<int> influenced = motions_of(data, "influenced_dof");
    const std::vector<Mat6> added = matrices_of(data, "added_mass", radiating, influenced);
    const std::vector<Mat6> damping = matrices_of(data, "radiation_damping", radiating, influenced);
    if (damping.size() != added.size()) throw data.wrong("has not as many rows of damping as of added mass");
    const std::vector<double> frequencies = frequencies_of(data, added.size());

    RadiationFile found;
    std::vector<double> left_out;
    std::set<double> seen;
    GivenOnce<double, std::pair<Mat6, Mat6>> given;
    for (std::size_t row = 0; row < frequencies.size(); ++row) {
        const double frequency = frequencies[row];
        const bool limit = frequency == 0 || std::isinf(frequency);
        if (added[row].hasNaN() || std::isnan(frequency) || (!limit && damping[row].hasNaN())) {
            left_out.push_back(frequency);
            continue;
        }
        if (frequency < 0) throw data.wrong("has a frequency of {:g} rad/s", frequency);
        if (const auto other = given.other_line(frequency, {added[row], limit ? Mat6::Zero() : damping[row]}, row + 1))
            throw data.wrong(
                "has a frequency of {:.6g} rad/s, a period of {:.6g} s, twice with other values, rows {} and {}",
                frequency, 2 * std::numbers::pi / frequency, *other, row + 1);
        if (!seen.insert(frequency).second) continue;
        if (frequency == 0)
            found.at_zero = added[row];
        else if (limit)
            found.at_infinity = added[row];
        else
            found.points.push_back({frequency, added[row], damping[row]});
    }
    std::ranges::sort(found.points, {}, &RadiationPoint::frequency);
    if (!left_out.empty())
        found.remarks.push_back(fmt::format(
            "{}: {} of its {} frequencies have numbers that are none, at {:.4g} to {:.4g} rad/s, and are "
            "left out; in shallow water Capytaine has them where waves are longest",
            file, left_out.size(), frequencies.size(), std::ranges::min(left_out), std::ranges::max(left_out)));
    if (const std::string missing = missing_motions(radiating); !missing.empty())
        found.remarks.push_back(fmt::format("{}: has nothing about {}, which is taken as 0", file, missing));
    found.elements = static_cast<int>(radiating.size() * influenced.size());
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

bool is_classic(std::string_view bytes) {
    return bytes.starts_with("CDF\x01") || bytes.starts_with("CDF\x02") || bytes.starts_with("CDF\x05");
}

}  // namespace

bool is_netcdf(std::string_view bytes) {
    return is_classic(bytes) || bytes.starts_with("\x89HDF\r\n\x1a\n");
}

RadiationFile read_capytaine(std::string_view bytes, const std::string& file) {
    // NetCDF takes what lies behind the end of a NetCDF-3 file for zeros.
    std::string longer;
    if (is_classic(bytes)) longer.append(bytes).append(bytes.size() + (1 << 16), '\x3f');
    const int signal = signal_of_trial([&] {
        read(bytes, file);
        if (!longer.empty()) read(longer, file);
    });
    if (signal != 0) throw InputError("{}: is damaged: NetCDF ends with signal {} over it", file, signal);
    RadiationFile found = read(bytes, file);
    if (!longer.empty() && read(longer, file) != found)
        throw InputError("{}: ends before its last numbers; was the file cut off?", file);
    return found;
}

}  // namespace floes
