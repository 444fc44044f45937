#include "campaign/case_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"
#include "shapes/moorings.hpp"
#include "theory/plate.hpp"

namespace floes {

namespace {

double area_of(const FloeShape& shape) {
    return shape.length * shape.breadth;
}

double diameter_of(const FloeShape& shape) {
    return std::sqrt(area_of(shape));
}

Words between(double low, double high) {
    return high - low < 1e-9 * high ? Words::of("{:.4g}", low) : Words::of("{:.4g} to {:.4g}", low, high);
}

/// "the field is 5.76 m long", or of one without end each part.
Words field_words(const Scenario& scenario) {
    return Words::of("{} {:.4g} m long", scenario.field.endless() ? "each part is" : "the field is",
                     scenario.field_length());
}

/// "0.6 m x 0.6 m: 40 % of the floes, 31 % of the area" for each entry of a list.
Words list_words(const Scenario& scenario, const std::vector<FloeShape>& shapes, double area) {
    Words words;
    std::size_t first = 0;
    for (const int count : listed_counts(scenario)) {
        if (count == 0) continue;
        const FloeShape& shape = shapes[first];
        first += static_cast<std::size_t>(count);
        words +=
            Words::of("; {:.4g} m x {:.4g} m: {:.3g} % of the floes, {:.3g} % of the area", shape.length, shape.breadth,
                      100.0 * count / static_cast<double>(shapes.size()), 100 * count * area_of(shape) / area);
    }
    return words;
}

Words size_words(const Scenario& scenario) {
    std::vector<FloeShape> shapes = floe_sizes(scenario);
    double area = 0;
    double diameters = 0;
    for (const FloeShape& shape : shapes) {
        area += area_of(shape);
        diameters += diameter_of(shape);
    }
    const Words list = scenario.sizes.law == SizeLaw::list ? list_words(scenario, shapes, area) : Words();
    std::ranges::sort(shapes, {}, diameter_of);
    double below = 0;
    auto half = shapes.begin();
    while (below + area_of(*half) < 0.5 * area) below += area_of(*half++);
    const auto [least, most] = std::ranges::minmax(shapes, {}, &FloeShape::element);
    return Words::of(
        "{}, sides of their squares {} m, mean {:.4g} m, half of the area in floes of {:.4g} m and more{}; {:.0f} "
        "elements of {} m; {}",
        Words::counted(std::ssize(shapes), "floe"), between(diameter_of(shapes.front()), diameter_of(shapes.back())),
        diameters / static_cast<double>(shapes.size()), diameter_of(*half), list, element_count(floes_of(scenario)),
        between(least.element, most.element), field_words(scenario));
}

/// What was traced, what became of it, and how many floes have each outline.
Words traced_words(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    std::vector<double> areas;
    double sum = 0;
    for (const Outline& one : traced.outlines) {
        areas.push_back(std::pow(traced.scale, 2) * std::abs(floes::area_of(one)));
        sum += areas.back();
    }
    const auto [least, most] = std::ranges::minmax(areas);
    Words words = Words::of("{} of {} m², {:.4g} m² together", Words::counted(std::ssize(areas), "outline"),
                            between(least, most), sum);
    if (!traced.areas.empty()) {
        const double in_file =
            std::pow(traced.scale, 2) * std::accumulate(traced.areas.begin(), traced.areas.end(), 0.0);
        const std::vector<double> added = traced_added(traced);
        const auto worst = std::ranges::max_element(added);
        // To a thousandth of a percent: what is less is rounding of the coordinates.
        const auto percent = [](double share) { return 1e-3 * std::round(1e5 * std::max(0.0, share)); };
        words += Words::of(
            "; with their holes filled they cover {:.2g} % more than as they were traced, at most {:.2g} % ({})",
            percent(sum / in_file - 1), percent(*worst),
            outline_name(traced, static_cast<std::size_t>(worst - added.begin())));
    }
    if (scenario.arrangement.given()) return words + "; they lie as they were traced, so every arrangement is the same";
    const std::size_t floes = static_cast<std::size_t>(scenario.field.floes);
    const std::size_t fewest = floes / areas.size();
    if (fewest == 0) return words + Words::of("; {} of them are taken, spread over their areas", floes);
    return words +
           Words::of("; each is that of {}{}", floes % areas.size() == 0 ? Words() : Words::of("{} or ", fewest),
                     Words::counted(static_cast<std::ptrdiff_t>((floes + areas.size() - 1) / areas.size()), "floe"));
}

/// What the polygons of the first arrangement are.
Words shape_words(const Scenario& scenario, std::uint64_t seed) {
    const FloeSet floes = floes_of(scenario, {seed, 0});
    std::vector<double> diameters;
    double corners = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        diameters.push_back(std::sqrt(floes.shape(i).area()));
        corners += static_cast<double>(floes.shape(i).outline.size()) / static_cast<double>(floes.size());
    }
    const auto [least, most] = std::ranges::minmax(diameters);
    const std::string_view kind = scenario.shapes.kind == ShapeKind::voronoi ? "Voronoi cell"
                                  : scenario.shapes.from_file()              ? "traced floe"
                                                                             : "polygon";
    return Words::of(
        "{}in arrangement 0 {} of {:.3g} corners on average, sides of their squares {} m, {:.0f} elements of about "
        "{:g} m; {}",
        scenario.shapes.from_file() ? traced_words(scenario) + "; " : Words(),
        Words::counted(std::ssize(diameters), kind), corners, between(least, most), element_count(floes),
        floes.shape(0).element, field_words(scenario));
}

using Of = double (*)(const FloeShape&, const Material&);

/// "thickness 0.0331 m (SD 0.006)", with what is the same for all floes left out.
Words property_words(const FloeSet& floes, const char* name, const char* unit, double scale, Of of) {
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) sum += of(floes.shape(i), floes.material(i)) / scale;
    const double mean = sum / static_cast<double>(floes.size());
    for (std::size_t i = 0; i < floes.size(); ++i)
        squares += std::pow(of(floes.shape(i), floes.material(i)) / scale - mean, 2);
    const double sd = std::sqrt(squares / static_cast<double>(floes.size()));
    return sd < 1e-9 * mean ? Words() : Words::of("{} {:.4g} {} (SD {:.2g})", name, mean, unit, sd);
}

Words ice_words(const Scenario& scenario, std::uint64_t seed) {
    if (scenario.spread.length > 0)
        return Words::of("the ice varies within the sheet, over a correlation length of {:.4g} m",
                         scenario.spread.length);
    const FloeSet floes = floes_of(scenario, {seed, 0});
    std::vector<Words> words{
        property_words(floes, "thickness", "m", unit::one, [](auto& shape, auto&) { return shape.thickness; }),
        property_words(floes, "bending strength", "kPa", unit::kilopascal,
                       [](auto&, auto& of) { return of.ice.bending_strength; }),
        property_words(floes, "modulus", "MPa", unit::megapascal,
                       [](auto&, auto& of) { return of.ice.elastic_modulus; }),
        property_words(floes, "density", "kg/m³", unit::one, [](auto&, auto& of) { return of.ice.density; })};
    std::erase_if(words, [](const Words& one) { return one.empty(); });
    if (words.empty()) {
        const Ice& ice = floes.material(0).ice;
        return Words::of("all floes have {:.4g} kPa in bending and {:.4g} MPa", ice.bending_strength / unit::kilopascal,
                         ice.elastic_modulus / unit::megapascal);
    }
    return Words("in arrangement 0 the floes have on average ") + Words::joined(words, ", ");
}

Words endless_words(const Scenario& scenario) {
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    const double reach = scenario.reach();
    if (scenario.arrangement.level())
        return Words::of(
            "the sheet has no end: rows of cells are joined to it ahead of a way of {:.4g} m in {:.4g} s; computed is "
            "ice up to {:.4g} m ahead of the structure's axis and {:.4g} m behind it, at most {:.0f} elements at a "
            "time",
            reach, duration, scenario.window_ahead(), scenario.window_behind(), sheet_shape(scenario).elements());
    return Words::of(
        "the field has no end: it is laid in parts of {} floes, {:.4g} m long each, ahead of a tow of {:.4g} m in "
        "{:.4g} s; computed are floes up to {:.4g} m ahead of the structure's axis and {:.4g} m behind it, about "
        "{:.0f} at a time",
        scenario.field.floes, scenario.field_length(), reach, duration, scenario.window_ahead(),
        scenario.window_behind(), computed_floes(scenario));
}

/// What the hull is, as its solids have it.
Words hull_words(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const Hydrostatics at_rest = hydrostatics(shape);
    const Vec2 size = waterline_size(shape);
    return Words::of(
        "the hull is {:.4g} m long and {:.4g} m wide at the waterline with a draught of {:.4g} m; it displaces {:.5g} "
        "m³, {:.5g} t, with the centre of buoyancy {:.4g} m below the water, and its waterplane of {:.4g} m² puts the "
        "metacentre {:.4g} m above that in roll and {:.4g} m in pitch",
        size.x(), size.y(), shape.draught(), at_rest.volume, scenario.water.density * at_rest.volume / unit::tonne,
        -at_rest.buoyancy.y(), at_rest.waterplane, at_rest.metacentric_radius(),
        at_rest.longitudinal_metacentric_radius());
}

/// How a moored hull swings, of one that floats with the height of its metacentres over its centre.
Words swing_words(const Scenario& scenario) {
    const Moorings& moorings = scenario.moorings;
    const Mat6 water = scenario.water_stiffness();
    std::vector<Words> periods;
    bool turns = false;
    for (const NaturalMode& mode : natural_modes(moorings, water)) {
        if (weathervanes(moorings, mode))
            turns = true;
        else
            periods.push_back(Words::of("{:.4g} s in {}", mode.period, motion_names.at(at(mode.motion))));
    }
    Words words =
        Words::of("without damping the moored hull swings with natural periods of {}", Words::joined(periods, ", "));
    if (turns)
        words = words + Words::of("; it turns about its turret {:.4g} m ahead until it lies with the load",
                                  moorings.turret.ahead);
    if (!moorings.floats()) return words;
    const double weight = moorings.mass * scenario.general.gravity;
    const auto metacentre = [&](Motion motion) {
        const auto k = static_cast<int>(motion);
        return water(k, k) / weight;
    };
    return words + Words::of("; its metacentre is {:.3g} m above its centre in roll and {:.3g} m in pitch",
                             metacentre(Motion::roll), metacentre(Motion::pitch));
}

}  // namespace

std::vector<std::string> case_words(const Campaign& campaign) {
    std::vector<std::string> sentences;
    std::vector<Words> of_points;
    std::set<std::string> said;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases[k].scenario;
        const std::uint64_t seed = arrangement_seed(campaign, static_cast<int>(k));
        std::vector<Words> parts;
        if (scenario.sizes.law != SizeLaw::one) parts.push_back(size_words(scenario));
        if (scenario.shapes.any()) parts.push_back(shape_words(scenario, seed));
        if (scenario.spread.any() || scenario.brine.salinity > 0) parts.push_back(ice_words(scenario, seed));
        if (scenario.field.endless()) parts.push_back(endless_words(scenario));
        if (scenario.moorings.give_way() || scenario.structure.shape.kind() != HullKind::profile)
            parts.push_back(hull_words(scenario));
        if (scenario.moorings.give_way()) parts.push_back(swing_words(scenario));
        std::erase_if(parts, [&](const Words& part) { return !said.insert(part.text()).second; });
        if (parts.empty()) continue;
        const Words words = Words::joined(parts, "; ");
        if (campaign.design.active()) of_points.push_back(words);
        sentences.push_back(fmt::format("case {}: {}.", campaign.cases[k].name, words.text()));
    }
    if (of_points.size() > 1)
        if (const std::optional<Words> all = Words::with_ranges(of_points))
            return {fmt::format("points of the design: {}.", all->text())};
    return sentences;
}

std::string hull_remark(const Campaign& campaign) {
    const auto unstated = std::ranges::find(campaign.cases, false, &Case::hull_stated);
    if (unstated == campaign.cases.end()) return {};
    return fmt::format(
        "No hull is stated: the paper's inverted cone, {:.4g} m wide at the waterline, is towed; hull.shape or "
        "structure.profile_m names another.",
        2 * unstated->scenario.structure.shape.waterline_radius());
}

namespace {

/// How floes lie, by ArrangementMethod.
constexpr std::array placing_words{"in equilibrium",     "on a jittered lattice",
                                   "as given in a file", "scattered at random",
                                   "as traced",          "as one sheet"};

/// "with sides of 10.4 to 37.4 m, mean 20 m (squares of their area)"
Words side_words(const Scenario& scenario) {
    std::vector<double> sides;
    double sum = 0;
    if (scenario.shapes.from_file()) {
        for (const Outline& one : scenario.shapes.traced.outlines)
            sides.push_back(scenario.shapes.traced.scale * std::sqrt(std::abs(floes::area_of(one))));
    } else {
        for (const FloeShape& shape : floe_sizes(scenario)) sides.push_back(diameter_of(shape));
    }
    for (const double side : sides) sum += side / static_cast<double>(sides.size());
    const auto [least, most] = std::ranges::minmax(sides);
    return Words::of("with sides of {} m, mean {:.4g} m (squares of their area)", between(least, most), sum);
}

Words kind_words(const Scenario& scenario) {
    const Shapes& shapes = scenario.shapes;
    if (shapes.kind == ShapeKind::polygon) return Words::of("polygons of {} corners", shapes.corners);
    if (shapes.kind == ShapeKind::voronoi) return "Voronoi cells";
    if (shapes.from_file())
        return Words::of("floes of {}", Words::counted(std::ssize(shapes.traced.outlines), "outline"));
    if (sizes_may_differ(scenario)) return "rectangles";
    return scenario.field.floes == 1 ? "floe" : "floes";
}

}  // namespace

Words floe_words(const Scenario& scenario) {
    const FloeShape& floe = scenario.floe;
    const bool sized = sizes_may_differ(scenario);
    const bool without_end = scenario.arrangement.level() && scenario.field.endless();
    const Words size = sized                   ? side_words(scenario)
                       : scenario.shapes.any() ? Words::of("of {:.4g} m² each on average", floe.length * floe.breadth)
                       : without_end           ? Words::of("{:.4g} m wide", floe.breadth)
                                               : Words::of("of {:.4g} m x {:.4g} m", floe.length, floe.breadth);
    const bool own_elements = sized && scenario.sizes.element != ElementSide::given;
    return Words::of("{}{} {} {}, {:.4g} m thick{}, in {} of {}, at {:.4g} %, {}",
                     scenario.field.endless() && !without_end ? "parts of " : "", scenario.field.floes,
                     without_end ? Words("sheet without end,") : kind_words(scenario), size, floe.thickness,
                     scenario.spread.thickness.any() ? " on average" : "", scenario.has_cells() ? "cells" : "squares",
                     own_elements ? "a size that follows the floe" : Words::of("{:.4g} m", floe.element),
                     scenario.field.concentration / unit::percent,
                     placing_words.at(static_cast<std::size_t>(scenario.arrangement.method)));
}

namespace {

std::string enumerated(const std::vector<std::string>& words) {
    if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
    return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

}  // namespace

Words turn_words(const Path& path) {
    if (path.legs.empty()) return {};
    double least = path.legs.front().heading;
    double most = least;
    for (const PathLeg& leg : path.legs)
        for (const double heading : {leg.heading, leg.heading + leg.turn * leg.time}) {
            least = std::min(least, heading);
            most = std::max(most, heading);
        }
    if (most - least < 1e-9) return {};
    return Words::of("{} by {:.3g}°", path.of == PathOf::ice ? "the drift turns" : "its path turns",
                     (most - least) / unit::degree);
}

Vec2 waterline_size(const Shape& shape) {
    Box2 box;
    for (const std::vector<Vec2>& outline : shape.waterlines()) box.extend(box_round(outline));
    return box.sizes();
}

Words motion_words(const Scenario& scenario) {
    const Moorings& moorings = scenario.moorings;
    const Words turns = turn_words(scenario.path);
    if (!moorings.give_way()) {
        if (scenario.path.any()) return turns.empty() ? "led along a path" : Words("led along a path; ") + turns;
        if (scenario.field.level_pushed)
            return Words::of("at rest; the sheet is pushed on it at {:.4g} m/s", scenario.structure.speed);
        return Words::of("towed at {:.4g} m/s", scenario.structure.speed);
    }
    std::vector<std::string> free;
    for (const int k : moorings.directions()) free.emplace_back(motion_names.at(static_cast<std::size_t>(k)));
    std::vector<Words> holds;
    if (moorings.surge + moorings.sway + moorings.yaw > 0)
        holds.push_back(Words::of("springs of {:.4g} kN/m in surge and {:.4g} in sway",
                                  moorings.surge / unit::kilonewton, moorings.sway / unit::kilonewton));
    if (moorings.line_count() > 0) {
        const Words lines = Words::counted(static_cast<std::ptrdiff_t>(moorings.line_count()), "line");
        holds.push_back(moorings.turret.lines ? lines + Words(" of a turret") : lines);
    }
    if (!moorings.turret.curve.empty()) holds.emplace_back("a turret");
    if (moorings.thrusters.any()) holds.emplace_back("thrusters");
    const Words held =
        Words::of("{:.6g} t, free in {}, held by {}; the ice comes at {:.4g} m/s", moorings.mass / unit::tonne,
                  enumerated(free), Words::joined(holds, ", "), scenario.drift());
    return turns.empty() ? held : held + "; " + turns;
}

namespace {

/// What is odd about a case, as a sentence without its end; empty where nothing is.
struct Odd {
    std::string told = {};
    double grade = 0;  ///< how odd, beside other cases: the oddest one is quoted
};
using Oddity = Odd (*)(const Case& one);

/// The least and the largest side of the elements of any floe, m.
std::pair<double, double> element_sides(const Scenario& scenario) {
    if (scenario.sizes.law == SizeLaw::one) return {scenario.floe.element, scenario.floe.element};
    const auto [least, largest] = std::ranges::minmax(floe_sizes(scenario), {}, &FloeShape::element);
    return {least.element, largest.element};
}

std::string element_words(const Scenario& scenario, double element) {
    const bool own = scenario.sizes.law != SizeLaw::one && scenario.sizes.element != ElementSide::given;
    return own ? fmt::format("an element of {:.4g} m", element) : given(scenario, "floe.element_m");
}

Odd large_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const double length = scenario.characteristic_length();
    const double element = element_sides(scenario).second;
    if (one.pairing == Pairing::find_modulus || element < length) return {};
    return {
        fmt::format("{} is not below {:.3g} m, the characteristic length of ice of {:g} MPa; such elements are too "
                    "large to show where the ice would bend and break",
                    element_words(scenario, element), length, scenario.mean_ice().elastic_modulus / unit::megapascal),
        element / length};
}

Odd thick_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const double element = element_sides(scenario).first;
    if (scenario.floe.thickness <= element) return {};
    return {fmt::format("{} is more than {}; elements that are thicker than wide do not bend as a plate does",
                        given(scenario, "ice.thickness_m"), element_words(scenario, element)),
            scenario.floe.thickness / element};
}

Odd little_ice(const Case& one) {
    constexpr double little = 0.05;
    const Scenario& scenario = one.scenario;
    if (scenario.field.concentration >= little || scenario.arrangement.given()) return {};
    return {fmt::format("{} leaves the field of {:.4g} m almost without ice; 75 is three quarters",
                        given(scenario, "field.concentration_percent"), scenario.field_length()),
            -scenario.field.concentration};
}

Odd odd_strength(const Case& one) {
    constexpr double weakest = 1 * unit::kilopascal;
    constexpr double strongest = 5000 * unit::kilopascal;
    const double strength = one.scenario.ice.bending_strength;
    if (strength >= weakest && strength <= strongest) return {};
    return {fmt::format("{} is unlike any ice; sea ice has some 500, model ice some 40",
                        given(one.scenario, "ice.bending_strength_kPa")),
            std::abs(std::log(strength / (500 * unit::kilopascal)))};
}

Odd soft_in_compression(const Case& one) {
    const Ice& ice = one.scenario.ice;
    if (ice.compressive_strength >= ice.bending_strength) return {};
    return {fmt::format("{} is below {}; ice is several times stronger in compression than in bending",
                        given(one.scenario, "ice.compressive_strength_kPa"),
                        given(one.scenario, "ice.bending_strength_kPa")),
            -ice.compressive_strength / ice.bending_strength};
}

Odd few_sweeps(const Case& one) {
    constexpr int few = 10;
    if (one.scenario.general.iterations >= few) return {};
    return {fmt::format("{} leaves contacts unsolved, and the load depends on it; with solver direct steps end by "
                        "themselves, and the default is only the most that one may take",
                        given(one.scenario, "general.iterations")),
            static_cast<double>(-one.scenario.general.iterations)};
}

Odd long_steps(const Case& one) {
    constexpr double most_of_thickness = 0.1;  // in the tank it is 0.04
    const Scenario& scenario = one.scenario;
    const Path& path = scenario.path;
    double speed = path.any() ? 0 : scenario.structure.speed;
    for (const PathPlace& place : scenario.places()) speed = std::max(speed, place.velocity.norm());
    const double way = speed * scenario.general.time_step;
    if (way <= most_of_thickness * scenario.floe.thickness) return {};
    const std::string goes = !path.any()         ? given(scenario, "structure.speed_m_s")
                             : path.legs.empty() ? "path.places"
                                                 : "path.legs";
    return {fmt::format("{} and {} take the structure {:.3g} m on in {} step, more than a tenth of the ice's "
                        "thickness; a shorter step resolves how it meets the ice",
                        given(scenario, "general.time_step_s"), goes, way, path.any() ? "its longest" : "each"),
            way / scenario.floe.thickness};
}

Odd narrow_gap(const Case& one) {
    constexpr double few = 2;
    const std::optional<BankGap> gap = one.scenario.gap();
    if (!gap || gap->floes >= few) return {};
    return {fmt::format("{} leaves {:.3g} m between the structure and the bank, {:.3g} sides of a floe; below two the "
                        "load depends on the gap (docs/sea_ice.md), and floes vary has a wider channel",
                        given(one.scenario, "field.half_width_m"), gap->breadth, gap->floes),
            -gap->floes};
}

Odd light_structure(const Case& one) {
    constexpr double many = 100;
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const double struck = struck_over_floe(scenario);
    if (struck >= many) return {};
    const double ratio = structure_over_floe(scenario);
    const std::string worst =
        struck < 0.99 * ratio ? fmt::format(", or {:.2g} % where it turns it most", 100 / struck) : "";
    return {
        fmt::format(
            "{} and the water that moves with it are {:.3g} times the heaviest floe: a floe that strikes it pushes it "
            "{:.2g} % too hard{}, as docs/moorings.md says",
            given(scenario, "moorings.mass_t"), ratio, 100 / ratio, worst),
        -struck};
}

Odd other_mass(const Case& one) {
    constexpr double much = 0.1;
    constexpr double in_kilograms = 300;  // and more, and less than 3000 times as much, where 1000 times were meant
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const double water = scenario.water.density * hydrostatics(scenario.structure.shape).volume;
    const double share = scenario.moorings.mass / water;
    if (std::abs(share - 1) <= much) return {};
    const bool kilograms = share > in_kilograms && share < 10 * in_kilograms;
    return {
        fmt::format("{} is {} the {:.4g} t of water that the hull displaces, and a hull that floats weighs as "
                    "much; {}",
                    given(scenario, "moorings.mass_t"),
                    share < 10 ? fmt::format("{:.3g} % of", share / unit::percent) : fmt::format("{:.4g} times", share),
                    water / unit::tonne,
                    kilograms ? "moorings.mass_t is in tonnes, and this looks like kilograms"
                              : "look at its draught and its size"),
        std::abs(std::log(share))};
}

/// Of a straight way, past ice that does not come by itself.
Odd early_window(const Case& one) {
    const Scenario& scenario = one.scenario;
    if (scenario.path.any()) return {};
    const double way = scenario.field.begin - scenario.structure.start - scenario.structure.shape.waterline_ahead();
    const double meets = way / scenario.structure.speed;
    const double early = meets - scenario.analysis.steady_start;
    if (early <= scenario.general.time_step) return {};
    return {fmt::format("{} begins to measure before the hull meets the ice, after {:.4g} s: {:.3g} % of the window "
                        "is open water; begin later, or start the hull nearer (structure.start_m)",
                        given(scenario, "analysis.steady_start_s"), meets,
                        100 * std::min(1.0, early / scenario.analysis.window)),
            early / scenario.analysis.window};
}

/// A structure that stands because nobody said how it goes on.
Odd short_path(const Case& one) {
    const Scenario& scenario = one.scenario;
    const double end = duration_of(scenario.path);
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    const double stands = duration - std::max(end, scenario.analysis.steady_start);
    if (!scenario.path.any() || !ends_moving(scenario.path) || duration - end <= scenario.general.time_step) return {};
    const bool legs = !scenario.path.legs.empty();
    return {
        fmt::format("{} ends after {:.6g} s of {:.6g} s, and then the structure stands, for {:.3g} % of the window; "
                    "let it go on, or say that it stands by {}",
                    legs ? "path.legs" : "path.places", end, duration, 100 * stands / scenario.analysis.window,
                    legs ? "a leg of speed 0" : "a last row at the same place"),
        stands / scenario.analysis.window};
}

/// Sizes that are so rare that none of the floes has them.
Odd size_without_floe(const Case& one) {
    const Scenario& scenario = one.scenario;
    if (scenario.sizes.law != SizeLaw::list || scenario.shapes.from_file()) return {};
    const std::vector<int> counts = listed_counts(scenario);
    const auto none = std::ranges::count(counts, 0);
    if (none == 0) return {};
    const auto first = static_cast<std::size_t>(std::ranges::find(counts, 0) - counts.begin());
    return {fmt::format("sizes.list_m[{}]{} so rare that none of {} has {}; take more floes, or leave {} out", first,
                        none == 1 ? " is" : fmt::format(" and {} more of its sizes are", none - 1),
                        counted(scenario.field.floes, "floe"), none == 1 ? "it" : "them", none == 1 ? "it" : "them"),
            static_cast<double>(none)};
}

/// As floes design refuses them after the run.
Odd long_period(const Case& one) {
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const std::optional<NaturalMode> mode = longest_mode(scenario.moorings, scenario.water_stiffness());
    if (!mode || mode->period <= scenario.analysis.window / fewest_periods) return {};
    return {fmt::format("{} is shorter than three natural periods of {:.4g} s in {}, so floes design would give no "
                        "design value of it; take a window of {:.4g} s or more",
                        given(scenario, "analysis.window_s"), mode->period, motion_names.at(at(mode->motion)),
                        fewest_periods * mode->period),
            mode->period / scenario.analysis.window};
}

/// Added mass by a number and by the matrix of a radiation program, which are often the same water.
Odd water_twice(const Case& one) {
    constexpr std::array<std::string_view, 6> numbers{
        "moorings.added_surge_t", "moorings.added_sway_t",     "moorings.added_yaw_t_m2",
        "moorings.added_heave_t", "moorings.added_pitch_t_m2", "moorings.added_roll_t_m2"};  // by Motion
    const Moorings& moorings = one.scenario.moorings;
    if (!moorings.give_way()) return {};
    const Mat6 matrix = from_hydrodynamic_axes(moorings.added_mass);
    std::vector<std::string> both;
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (moorings.added.at(k) > 0 && matrix.diagonal()[static_cast<int>(k)] != 0)
            both.push_back(given(one.scenario, std::string(numbers.at(k))));
    if (both.empty()) return {};
    return {fmt::format("moorings.added_mass is in addition to {}; leave that out if both are of the same water",
                        fmt::join(both, ", ")),
            static_cast<double>(both.size())};
}

constexpr std::array<Oddity, 15> oddities{large_elements,      thick_elements, little_ice,       odd_strength,
                                          soft_in_compression, few_sweeps,     long_steps,       narrow_gap,
                                          light_structure,     other_mass,     water_twice,      early_window,
                                          long_period,         short_path,     size_without_floe};

double least_grade(const std::vector<std::pair<const Case*, Odd>>& found) {
    return std::ranges::min(found, {}, [](const auto& one) { return one.second.grade; }).second.grade;
}

}  // namespace

std::vector<std::string> advice(const Campaign& campaign) {
    std::vector<std::string> sentences;
    for (const Oddity oddity : oddities) {
        std::vector<std::pair<const Case*, Odd>> found;
        for (const Case& one : campaign.cases)
            if (Odd odd = oddity(one); !odd.told.empty()) found.emplace_back(&one, std::move(odd));
        if (found.empty()) continue;
        const auto oddest = std::ranges::max_element(found, {}, [](const auto& one) { return one.second.grade; });
        std::vector<std::string> others;
        for (const auto& one : found)
            if (one.first != oddest->first) others.push_back(one.first->name);
        constexpr std::size_t few = 3;  // names that are read; of more, if it is all of them, that says it
        const bool all = others.size() + 1 == campaign.cases.size() && others.size() > few;
        const std::string told = fmt::format("case {}: {}.", oddest->first->name, oddest->second.told);
        sentences.push_back(others.empty()
                                ? told
                                : fmt::format("{} {} {}.", told,
                                              oddest->second.grade > least_grade(found) ? "Less so, the same holds for"
                                                                                        : "The same holds for",
                                              all ? fmt::format("all {} others", others.size()) : name_list(others)));
    }
    return sentences;
}

}  // namespace floes
