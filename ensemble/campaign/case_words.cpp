#include "campaign/case_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/hydrostatics.hpp"

namespace floes {

namespace {

double area_of(const FloeShape& shape) {
    return shape.length * shape.breadth;
}

double diameter_of(const FloeShape& shape) {
    return std::sqrt(area_of(shape));
}

std::string between(double low, double high) {
    return high - low < 1e-9 * high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
}

/// "the field is 5.76 m long", or of one without end each part.
std::string field_words(const Scenario& scenario) {
    return fmt::format("{} {:.4g} m long", scenario.field.endless() ? "each part is" : "the field is",
                       scenario.field_length());
}

/// "0.6 m x 0.6 m: 40 % of the floes, 31 % of the area" for each entry of a list.
std::string list_words(const Scenario& scenario, const std::vector<FloeShape>& shapes, double area) {
    std::string words;
    std::size_t first = 0;
    for (const int count : listed_counts(scenario)) {
        if (count == 0) continue;
        const FloeShape& shape = shapes[first];
        first += static_cast<std::size_t>(count);
        words += fmt::format("; {:.4g} m x {:.4g} m: {:.3g} % of the floes, {:.3g} % of the area", shape.length,
                             shape.breadth, 100.0 * count / static_cast<double>(shapes.size()),
                             100 * count * area_of(shape) / area);
    }
    return words;
}

std::string size_words(const Scenario& scenario) {
    std::vector<FloeShape> shapes = floe_sizes(scenario);
    double area = 0;
    double diameters = 0;
    for (const FloeShape& shape : shapes) {
        area += area_of(shape);
        diameters += diameter_of(shape);
    }
    const std::string list = scenario.sizes.law == SizeLaw::list ? list_words(scenario, shapes, area) : "";
    std::ranges::sort(shapes, {}, diameter_of);
    double below = 0;
    auto half = shapes.begin();
    while (below + area_of(*half) < 0.5 * area) below += area_of(*half++);
    const auto [least, most] = std::ranges::minmax(shapes, {}, &FloeShape::element);
    return fmt::format(
        "{}, sides of their squares {} m, mean {:.4g} m, half of the area in floes of {:.4g} m and more{}; {:.0f} "
        "elements of {} m; {}",
        counted(std::ssize(shapes), "floe"), between(diameter_of(shapes.front()), diameter_of(shapes.back())),
        diameters / static_cast<double>(shapes.size()), diameter_of(*half), list, element_count(floes_of(scenario)),
        between(least.element, most.element), field_words(scenario));
}

/// What was traced, what became of it, and how many floes have each outline.
std::string traced_words(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    std::vector<double> areas;
    double sum = 0;
    for (const Outline& one : traced.outlines) {
        areas.push_back(std::pow(traced.scale, 2) * std::abs(floes::area_of(one)));
        sum += areas.back();
    }
    const auto [least, most] = std::ranges::minmax(areas);
    std::string words = fmt::format("{} of {} m², {:.4g} m² together", counted(std::ssize(areas), "outline"),
                                    between(least, most), sum);
    if (!traced.areas.empty()) {
        const double in_file =
            std::pow(traced.scale, 2) * std::accumulate(traced.areas.begin(), traced.areas.end(), 0.0);
        const std::vector<double> added = traced_added(traced);
        const auto worst = std::ranges::max_element(added);
        // To a thousandth of a percent: what is less is rounding of the coordinates.
        const auto percent = [](double share) { return 1e-3 * std::round(1e5 * std::max(0.0, share)); };
        words += fmt::format(
            "; with their holes filled they cover {:.2g} % more than as they were traced, at most {:.2g} % ({})",
            percent(sum / in_file - 1), percent(*worst),
            outline_name(traced, static_cast<std::size_t>(worst - added.begin())));
    }
    if (scenario.arrangement.given()) return words + "; they lie as they were traced, so every arrangement is the same";
    const std::size_t floes = static_cast<std::size_t>(scenario.field.floes);
    const std::size_t fewest = floes / areas.size();
    if (fewest == 0) return words + fmt::format("; {} of them are taken, spread over their areas", floes);
    return words + fmt::format("; each is that of {}{}", floes % areas.size() == 0 ? "" : fmt::format("{} or ", fewest),
                               counted(static_cast<std::ptrdiff_t>((floes + areas.size() - 1) / areas.size()), "floe"));
}

/// What the polygons of the first arrangement are.
std::string shape_words(const Scenario& scenario, std::uint64_t seed) {
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
    return fmt::format(
        "{}in arrangement 0 {} of {:.3g} corners on average, sides of their squares {} m, {:.0f} elements of about "
        "{:g} m; {}",
        scenario.shapes.from_file() ? traced_words(scenario) + "; " : "", counted(std::ssize(diameters), kind), corners,
        between(least, most), element_count(floes), floes.shape(0).element, field_words(scenario));
}

using Of = double (*)(const FloeShape&, const Material&);

/// "thickness 0.0331 m (SD 0.006)", with what is the same for all floes left out.
std::string property_words(const FloeSet& floes, const char* name, const char* unit, double scale, Of of) {
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) sum += of(floes.shape(i), floes.material(i)) / scale;
    const double mean = sum / static_cast<double>(floes.size());
    for (std::size_t i = 0; i < floes.size(); ++i)
        squares += std::pow(of(floes.shape(i), floes.material(i)) / scale - mean, 2);
    const double sd = std::sqrt(squares / static_cast<double>(floes.size()));
    return sd < 1e-9 * mean ? "" : fmt::format(", {} {:.4g} {} (SD {:.2g})", name, mean, unit, sd);
}

std::string ice_words(const Scenario& scenario, std::uint64_t seed) {
    const FloeSet floes = floes_of(scenario, {seed, 0});
    std::string words =
        property_words(floes, "thickness", "m", unit::one, [](auto& shape, auto&) { return shape.thickness; }) +
        property_words(floes, "bending strength", "kPa", unit::kilopascal,
                       [](auto&, auto& of) { return of.ice.bending_strength; }) +
        property_words(floes, "modulus", "MPa", unit::megapascal,
                       [](auto&, auto& of) { return of.ice.elastic_modulus; }) +
        property_words(floes, "density", "kg/m³", unit::one, [](auto&, auto& of) { return of.ice.density; });
    if (words.empty()) {
        const Ice& ice = floes.material(0).ice;
        return fmt::format("all floes have {:.4g} kPa in bending and {:.4g} MPa",
                           ice.bending_strength / unit::kilopascal, ice.elastic_modulus / unit::megapascal);
    }
    return "in arrangement 0 the floes have on average" + words.substr(1);
}

std::string endless_words(const Scenario& scenario) {
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    const double reach = scenario.reach();
    return fmt::format(
        "the field has no end: it is laid in parts of {} floes, {:.4g} m long each, ahead of a tow of {:.4g} m in "
        "{:.4g} s; computed are floes up to {:.4g} m ahead of the structure's axis and {:.4g} m behind it, about "
        "{:.0f} at a time",
        scenario.field.floes, scenario.field_length(), reach, duration, scenario.window_ahead(),
        scenario.window_behind(), computed_floes(scenario));
}

/// What the hull is, as its solids have it.
std::string hull_words(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const Hydrostatics at_rest = hydrostatics(shape);
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const std::vector<Vec2>& outline : shape.waterlines()) {
        for (const Vec2& point : outline) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    }
    return fmt::format(
        "the hull is {:.4g} m long and {:.4g} m wide at the waterline with a draught of {:.4g} m; it displaces {:.5g} "
        "m³, {:.5g} t, with the centre of buoyancy {:.4g} m below the water, and its waterplane of {:.4g} m² puts the "
        "metacentre {:.4g} m above that in roll and {:.4g} m in pitch",
        high.x() - low.x(), high.y() - low.y(), shape.draught(), at_rest.volume,
        scenario.water.density * at_rest.volume / unit::tonne, -at_rest.buoyancy.y(), at_rest.waterplane,
        at_rest.metacentric_radius(), at_rest.longitudinal_metacentric_radius());
}

/// How a moored hull swings, of one that floats with the height of its metacentres over its centre.
std::string swing_words(const Scenario& scenario) {
    const Moorings& moorings = scenario.moorings;
    const Mat6 water = scenario.water_stiffness();
    std::vector<std::string> periods;
    for (const NaturalMode& mode : natural_modes(moorings, water))
        periods.push_back(fmt::format("{:.4g} s in {}", mode.period, motion_names.at(at(mode.motion))));
    std::string words =
        fmt::format("without damping the moored hull swings with natural periods of {}", fmt::join(periods, ", "));
    if (!moorings.floats()) return words;
    const double weight = moorings.mass * scenario.general.gravity;
    const auto metacentre = [&](Motion motion) {
        const auto k = static_cast<int>(motion);
        return water(k, k) / weight;
    };
    return words + fmt::format("; its metacentre is {:.3g} m above its centre in roll and {:.3g} m in pitch",
                               metacentre(Motion::roll), metacentre(Motion::pitch));
}

}  // namespace

namespace {

/// Texts and the numbers between them: one text more than numbers. A digit in a word or behind a sign is no number.
struct NumberedText {
    std::vector<std::string> texts{""};
    std::vector<std::string> numbers;
};

NumberedText taken_apart(const std::string& sentence) {
    const auto digit = [&](std::size_t k) { return k < sentence.size() && sentence[k] >= '0' && sentence[k] <= '9'; };
    NumberedText made;
    for (std::size_t k = 0; k < sentence.size();) {
        const bool alone = k == 0 || sentence[k - 1] == ' ' || sentence[k - 1] == '(';
        if (!digit(k) || !alone) {
            made.texts.back() += sentence[k++];
            continue;
        }
        std::size_t end = k;
        while (digit(end) || (end < sentence.size() && sentence[end] == '.' && digit(end + 1))) ++end;
        made.numbers.push_back(sentence.substr(k, end - k));
        made.texts.emplace_back();
        k = end;
    }
    return made;
}

}  // namespace

std::optional<std::string> with_ranges(const std::vector<std::string>& sentences) {
    if (sentences.empty()) return {};
    const NumberedText first = taken_apart(sentences.front());
    std::vector<std::string> least = first.numbers;
    std::vector<std::string> most = first.numbers;
    const auto value = [](const std::string& number) { return std::stod(number); };
    for (const std::string& sentence : sentences) {
        const NumberedText other = taken_apart(sentence);
        if (other.texts != first.texts) return {};
        for (std::size_t k = 0; k < least.size(); ++k) {
            least[k] = std::ranges::min(least[k], other.numbers[k], {}, value);
            most[k] = std::ranges::max(most[k], other.numbers[k], {}, value);
        }
    }
    std::string made = first.texts.front();
    for (std::size_t k = 0; k < least.size(); ++k)
        made += (least[k] == most[k] ? least[k] : least[k] + " to " + most[k]) + first.texts[k + 1];
    return made;
}

std::vector<std::string> case_words(const Campaign& campaign) {
    std::vector<std::string> sentences;
    std::vector<std::string> of_points;
    std::set<std::string> said;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases[k].scenario;
        const std::uint64_t seed = arrangement_seed(campaign, static_cast<int>(k));
        std::vector<std::string> parts;
        if (scenario.sizes.law != SizeLaw::one) parts.push_back(size_words(scenario));
        if (scenario.shapes.any()) parts.push_back(shape_words(scenario, seed));
        if (scenario.spread.any() || scenario.brine.salinity > 0) parts.push_back(ice_words(scenario, seed));
        if (scenario.field.endless()) parts.push_back(endless_words(scenario));
        if (scenario.moorings.give_way() || scenario.structure.shape.kind() != HullKind::profile)
            parts.push_back(hull_words(scenario));
        if (scenario.moorings.give_way()) parts.push_back(swing_words(scenario));
        std::erase_if(parts, [&](const std::string& part) { return !said.insert(part).second; });
        if (parts.empty()) continue;
        const std::string words = fmt::format("{}", fmt::join(parts, "; "));
        if (campaign.design.active()) of_points.push_back(words);
        sentences.push_back(fmt::format("case {}: {}.", campaign.cases[k].name, words));
    }
    if (of_points.size() > 1)
        if (const std::optional<std::string> all = with_ranges(of_points))
            return {fmt::format("points of the design: {}.", *all)};
    return sentences;
}

namespace {

const char* placing_words(ArrangementMethod method) {
    switch (method) {
        case ArrangementMethod::monte_carlo:
            return "in equilibrium";
        case ArrangementMethod::lattice:
            return "on a jittered lattice";
        case ArrangementMethod::file:
            return "as given in a file";
        case ArrangementMethod::traced:
            return "as traced";
        case ArrangementMethod::scattered:
            break;
    }
    return "scattered at random";
}

/// "with sides of 10.4 to 37.4 m, mean 20 m (squares of their area)"
std::string side_words(const Scenario& scenario) {
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
    return fmt::format("with sides of {} m, mean {:.4g} m (squares of their area)", between(least, most), sum);
}

std::string kind_words(const Scenario& scenario) {
    const Shapes& shapes = scenario.shapes;
    if (shapes.kind == ShapeKind::polygon) return fmt::format("polygons of {} corners", shapes.corners);
    if (shapes.kind == ShapeKind::voronoi) return "Voronoi cells";
    if (shapes.from_file()) return fmt::format("floes of {}", counted(std::ssize(shapes.traced.outlines), "outline"));
    if (sizes_may_differ(scenario)) return "rectangles";
    return scenario.field.floes == 1 ? "floe" : "floes";
}

}  // namespace

std::string floe_words(const Scenario& scenario) {
    const FloeShape& floe = scenario.floe;
    const bool sized = sizes_may_differ(scenario);
    const std::string size = sized ? side_words(scenario)
                             : scenario.shapes.any()
                                 ? fmt::format("of {:.4g} m² each on average", floe.length * floe.breadth)
                                 : fmt::format("of {:.4g} m x {:.4g} m", floe.length, floe.breadth);
    const bool own_elements = sized && scenario.sizes.element != ElementSide::given;
    return fmt::format("{}{} {} {}, {:.4g} m thick{}, in {} of {}, at {:.4g} %, {}",
                       scenario.field.endless() ? "parts of " : "", scenario.field.floes, kind_words(scenario), size,
                       floe.thickness, scenario.spread.thickness.any() ? " on average" : "",
                       scenario.has_cells() ? "cells" : "squares",
                       own_elements ? "a size that follows the floe" : fmt::format("{:.4g} m", floe.element),
                       scenario.field.concentration / unit::percent, placing_words(scenario.arrangement.method));
}

namespace {

std::string enumerated(const std::vector<std::string>& words) {
    if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
    return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

}  // namespace

std::string motion_words(const Scenario& scenario) {
    const Moorings& moorings = scenario.moorings;
    if (!moorings.give_way()) {
        if (scenario.path.any()) return "led along a path";
        return fmt::format("towed at {:.4g} m/s", scenario.structure.speed);
    }
    std::vector<std::string> free;
    for (const int k : moorings.directions()) free.emplace_back(motion_names.at(static_cast<std::size_t>(k)));
    std::vector<std::string> holds;
    if (moorings.surge + moorings.sway + moorings.yaw > 0)
        holds.push_back(fmt::format("springs of {:.4g} kN/m in surge and {:.4g} in sway",
                                    moorings.surge / unit::kilonewton, moorings.sway / unit::kilonewton));
    if (moorings.line_count() > 0) holds.push_back(counted(static_cast<std::ptrdiff_t>(moorings.line_count()), "line"));
    if (!moorings.turret_curve.empty()) holds.emplace_back("a turret");
    if (moorings.thrusters.any()) holds.emplace_back("thrusters");
    return fmt::format("{:.4g} t, free in {}, held by {}; the ice comes at {:.4g} m/s", moorings.mass / unit::tonne,
                       enumerated(free), fmt::join(holds, ", "), scenario.closing_speed());
}

}  // namespace floes
