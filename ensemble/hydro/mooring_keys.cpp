#include "hydro/mooring_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "hydro/hydrostatic_file.hpp"
#include "hydro/mooring_file.hpp"
#include "hydro/mooring_sections.hpp"
#include "hydro/radiation.hpp"
#include "keys/document.hpp"
#include "keys/read.hpp"
#include "scenario/tables.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"

namespace floes {

namespace {

/// What the file does not say, by the request and its hull.
struct Surroundings {
    WamitUnits units{};
    double gravity = 9.80665;
    double depth = std::numeric_limits<double>::infinity();
    std::optional<double> waterplane{};
};

Surroundings surroundings(const MooringKeysRequest& request) {
    Surroundings found;
    found.units.length = request.length;
    if (request.hull) {
        found.units.density = request.hull->water.density;
        found.gravity = request.hull->general.gravity;
        found.waterplane = hydrostatics(request.hull->structure.shape).waterplane;
    }
    found.units.density = request.density.value_or(found.units.density);
    found.gravity = request.gravity.value_or(found.gravity);
    found.depth = request.depth.value_or(found.depth);
    if (request.waterplane) found.waterplane = request.waterplane;
    return found;
}

/// The mean of its halves, which rounding makes unlike, without what couples two motions by less than a thousandth of
/// what they have themselves: that changes no frequency by more than a millionth. Of a motion that has next to nothing
/// itself, as yaw of a round hull, by a hundredth of what the others of its kind have.
Mat6 without_rounding(const Mat6& matrix) {
    constexpr double least = 1e-3;
    Mat6 found = 0.5 * (matrix + matrix.transpose());
    const Vec6 own = no_less_than(found.diagonal().cwiseAbs().cwiseSqrt(), 1e-2);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            if (std::abs(found(i, j)) < least * own[i] * own[j]) found(i, j) = 0;
    return found;
}

std::string matrix_text(const char* key, const Mat6& matrix) {
    std::string text = fmt::format("{} = [\n", key);
    const Mat6 printed = without_rounding(matrix);
    for (const auto& row : printed.rowwise()) {
        std::vector<std::string> numbers;
        for (const double value : row) numbers.push_back(fmt::format("{:.6g}", value / unit::tonne));
        text += fmt::format("  [{}],\n", fmt::join(numbers, ", "));
    }
    return text + "]\n";
}

/// A first column that is no period, a length or a density that are others give another waterplane. Only waves that are
/// long against the hull know it.
std::string guard(const MooringKeysRequest& request, const Surroundings& here, const RadiationFile& radiation) {
    const RadiationWater water =
        radiation.water.value_or(RadiationWater{here.units.density, here.gravity, here.depth, 0});
    const std::optional<double> implied = waterplane_by_waves(radiation, water.density, water.gravity, water.depth);
    if (!implied) return "# its longest waves say nothing of the waterplane: no damping in heave\n";
    std::string text =
        fmt::format("# the damping in heave of its longest waves is that of a waterplane of {:.4g} m²", *implied);
    const double known = here.waterplane.value_or(water.waterplane);
    if (!(known > 0)) return text + "; compare it with your hull's, or give --hull or --waterplane-m2\n";
    constexpr double most = 1.5;
    if (std::abs(std::log(*implied / known)) <= std::log(most)) return text + "\n";
    const double wave = longest_wave(radiation, water.gravity, water.depth);
    const std::string whose = request.waterplane ? "--waterplane-m2"
                              : here.waterplane  ? request.hull_name
                                                 : "its own stiffness";
    // Below a hull of the draught d waves of the number k are weaker by e^(-kd), which alone makes S too small.
    const double radius = std::sqrt(known / std::numbers::pi);
    const double draught = request.hull ? request.hull->structure.shape.draught() : 6 * radius;
    if (*implied < known && wave < 2 * std::numbers::pi / std::log(most) * std::max(radius, draught))
        return text + fmt::format(
                          ", not of the {:.4g} m² of {}; they are {:.4g} m long, too short to know it, if its "
                          "first column is a period in s\n",
                          known, whose, wave);
    throw InputError(
        "{}: the damping in heave of its longest waves is that of a waterplane of {:.4g} m², not of the {:.4g} m² of "
        "{}; is its first column a period in s, --length-m its length, --density its water, --depth-m its depth?",
        request.file, *implied, known, whose);
}

/// Of the hull's natural modes, each of the motion of which it has most, in the order of radiation programs, with the
/// file's added mass at the frequencies themselves. Another motion has that of the file's longest waves.
std::array<double, 6> natural_frequencies(const RadiationFile& radiation, const Vec3& reference, const Scenario& hull) {
    constexpr std::array<Motion, 6> order{Motion::surge, Motion::sway,  Motion::heave,
                                          Motion::roll,  Motion::pitch, Motion::yaw};
    Moorings moorings = hull.moorings;
    moorings.added = {};
    moorings.added_mass.assign(6, std::vector<double>(6, 0));
    std::array<double, 6> found{};
    found.fill(radiation.points.front().frequency);
    constexpr int enough = 30;  // each round changes it by the share that added mass varies by
    for (int round = 0; round < enough; ++round) {
        const Mat6 added = without_rounding(about_origin(radiation_at(radiation, found).added, reference));
        for (int k = 0; k < 36; ++k)
            moorings.added_mass[static_cast<std::size_t>(k / 6)][static_cast<std::size_t>(k % 6)] = added(k / 6, k % 6);
        for (const NaturalMode& mode : natural_modes(moorings, hull.water_stiffness()))
            if (std::isfinite(mode.period))
                found.at(static_cast<std::size_t>(std::ranges::find(order, mode.motion) - order.begin())) =
                    2 * std::numbers::pi / mode.period;
    }
    return found;
}

/// What the hull's configuration says of its own of what the matrices are.
std::string stated_already(const MooringKeysRequest& request) {
    if (!request.hull) return "";
    Moorings moorings = request.hull->moorings;
    Keys keys;
    add_moorings(keys, moorings);
    std::vector<std::string_view> added;
    for (const Key& key : keys)
        if (const auto* number = std::get_if<NumberField>(&key.field);
            number != nullptr && key.path.starts_with("moorings.added_") && number->get() > 0)
            added.push_back(key.path);
    std::string text;
    if (!added.empty())
        text += fmt::format("# leave out {} of {}: added_mass is in their place, and would be in addition to them\n",
                            fmt::join(added, ", "), request.hull_name);
    if (moorings.damping > 0)
        text += fmt::format(
            "# moorings.damping_percent of {} is in addition to radiation_damping: let it be what lines and friction "
            "damp\n",
            request.hull_name);
    return text;
}

std::string radiation_text(const MooringKeysRequest& request, const Surroundings& here, const std::string& bytes) {
    const RadiationFile radiation = read_radiation(bytes, request.file, here.units);
    Vec3 reference = radiation.reference.value_or(Vec3::Zero());
    if (!request.reference.empty()) reference = {request.reference[0], request.reference[1], request.reference[2]};
    std::array<double, 6> frequencies{};
    std::string when;
    if (request.period) {
        const double shortest = period_of(radiation.points.back().frequency);
        const double longest = period_of(radiation.points.front().frequency);
        constexpr double rounding = 1e-9;
        if (*request.period < shortest * (1 - rounding) || *request.period > longest * (1 + rounding))
            throw InputError("{}: has periods from {:.4g} to {:.4g} s, and --period-s {:g} is outside", request.file,
                             shortest, longest, *request.period);
        frequencies.fill(2 * std::numbers::pi / *request.period);
        when = fmt::format("at {:g} s", *request.period);
    } else if (request.hull && request.hull->moorings.give_way()) {
        frequencies = natural_frequencies(radiation, reference, *request.hull);
        std::vector<std::string> periods;
        for (std::size_t k = 0; k < frequencies.size(); ++k)
            periods.push_back(fmt::format("{} {:.4g} s", hydrodynamic_motions.at(k), period_of(frequencies.at(k))));
        when =
            fmt::format("at the natural period of each motion of {}: {}", request.hull_name, fmt::join(periods, ", "));
    } else {
        throw InputError(
            "{}: give the period at which its values are to hold, --period-s, or the configuration of a hull on "
            "moorings, --hull, for those of its natural periods; the file has {:.4g} to {:.4g} s",
            request.file, period_of(radiation.points.back().frequency), period_of(radiation.points.front().frequency));
    }
    const RadiationPoint at = radiation_at(radiation, frequencies);
    std::string out =
        fmt::format("# {}, {}\n# about {}\n", request.file, when,
                    reference.isZero() ? "its own reference point, taken as the axis at the calm water"
                                       : fmt::format("the axis at the calm water, from ({:g}, {:g}, {:g}) m",
                                                     reference.x(), reference.y(), reference.z()));
    out += fmt::format("# read: {}\n", extent_of(radiation));
    for (const std::string& remark : radiation.remarks) out += "# " + remark + "\n";
    if (const std::string doubt = doubts(radiation, request.file, frequencies); !doubt.empty())
        out += "# " + doubt + "\n";
    return out + guard(request, here, radiation) + stated_already(request) +
           matrix_text("added_mass", about_origin(at.added, reference)) +
           matrix_text("radiation_damping", about_origin(at.damping, reference));
}

/// No keys: floes has the water's stiffness from the hull. It says whether both mean the same hull.
std::string hydrostatic_text(const MooringKeysRequest& request, const Surroundings& here, const std::string& text) {
    const Mat6 theirs = read_hydrostatics(text, request.file, here.units, here.gravity);
    if (request.weight.empty())
        throw InputError(
            "{}: say with --weight inside or --weight outside whether its stiffness in roll and pitch holds the hull's "
            "weight; WAMIT has what its own file of forces says, NEMOH and Capytaine have it inside, HydroDyn wants it "
            "outside",
            request.file);
    std::string out = fmt::format(
        "# {}, weight {}, is no key: floes has the water's stiffness from the hull\n"
        "# waterplane {:.5g} m²\n",
        request.file, request.weight, theirs(2, 2) / (here.units.density * here.gravity));
    if (!request.hull) return out + "# give --hull to compare it with that hull\n";
    const bool inside = request.weight == "inside";
    const Moorings& moorings = request.hull->moorings;
    const Mat6 ours = water_stiffness(hydrostatics(request.hull->structure.shape), here.units.density, here.gravity,
                                      inside ? moorings.mass : 0, inside ? moorings.height : 0);
    constexpr std::array<Motion, 3> compared{Motion::heave, Motion::roll, Motion::pitch};
    constexpr double most = 0.05;
    double worst = 0;
    for (std::size_t k = 0; k < compared.size(); ++k) {
        const auto own = static_cast<int>(compared.at(k));
        const double their = theirs(static_cast<int>(k) + 2, static_cast<int>(k) + 2);
        const double our = ours(own, own);
        const double share = (their - our) / std::max(std::abs(our), std::numeric_limits<double>::min());
        worst = std::max(worst, std::abs(share));
        out +=
            fmt::format("# {}: {:.5g} {}, of the hull of {} {:.5g}: {:+.1f} %\n", motion_names.at(at(compared.at(k))),
                        their, k == 0 ? "N/m" : "N m/rad", request.hull_name, our, 100 * share);
    }
    return out + (worst <= most ? "# they are the same hull\n"
                                : "# THEY DIFFER: is it the same hull, --weight right, --length-m its length, its "
                                  "reference point at the calm water, mass_t and centre_m those of the hull?\n");
}

std::string moorings_text(const MooringKeysRequest& request, const Surroundings& here, const std::string& text) {
    const MooringFile moorings = read_moorings(text, request.file, here.units.density, here.gravity);
    std::string out = fmt::format("# {}, read: {}\n", request.file, moorings.extent);
    for (const std::string& remark : moorings.remarks) out += "# " + remark + "\n";
    out +=
        "# x, height and z of the fairlead, azimuth, distance, depth, length, weight, stiffness, friction, break load\n"
        "hanging_lines = [\n";
    for (const HangingLine& line : moorings.lines)
        out += fmt::format("  [{:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {:g}, {:g}],\n",
                           line.fairlead.x(), line.fairlead.y(), line.fairlead.z(), line.azimuth / unit::degree,
                           line.distance, line.depth, line.cable.length, line.cable.weight,
                           line.cable.stiffness / unit::kilonewton, line.cable.friction,
                           line.break_load / unit::kilonewton);
    return out + "]\n";
}

/// What a configuration would say of these keys: hydro prints none that it refuses.
void refuse_as_configuration(const std::string& keys, const std::string& file) {
    const std::string whose = "what " + file + " gives";
    Moorings moorings;
    Keys known;
    add_moorings(known, moorings);
    for (const Entry& entry : parse_document("[moorings]\n" + keys, whose).entries) assign_known(known, entry);
    Contradictions found;
    check_matrices(moorings, found);
    if (!found.empty()) throw InputError("{}: {}", whose, found.front().sentence);
}

}  // namespace

std::string mooring_keys(const MooringKeysRequest& request, const std::string& bytes) {
    const Surroundings here = surroundings(request);
    const bool radiation = is_radiation(bytes);
    const bool has_lines = !radiation && is_mooring_file(bytes);
    const bool is_stiffness = !radiation && !has_lines && is_hydrostatic(bytes);
    if ((has_lines || is_stiffness) && !request.reference.empty())
        throw InputError(
            "--reference-m moves matrices of added mass and damping, and {} has none; give points and stiffness from "
            "the axis at the calm water",
            request.file);
    if (is_stiffness) return hydrostatic_text(request, here, bytes);
    std::string keys = has_lines ? moorings_text(request, here, bytes) : radiation_text(request, here, bytes);
    refuse_as_configuration(keys, request.file);
    return keys;
}

}  // namespace floes
