#include "campaign/advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "theory/plate.hpp"

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
    double elements = 0;
    for (const FloeShape& shape : shapes) {
        area += area_of(shape);
        diameters += diameter_of(shape);
        elements += shape.elements();
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
        diameters / static_cast<double>(shapes.size()), diameter_of(*half), list, elements,
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
        words += fmt::format(
            "; with their holes filled they cover {:.2g} % more than as they were traced, at most {:.2g} % ({})",
            100 * std::max(0.0, sum / in_file - 1), 100 * std::max(0.0, *worst),
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

}  // namespace

std::vector<std::string> floe_words(const Campaign& campaign) {
    std::vector<std::string> sentences;
    std::set<std::string> said;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases[k].scenario;
        std::string words;
        if (scenario.sizes.law != SizeLaw::one) words = size_words(scenario);
        if (scenario.shapes.any())
            words +=
                (words.empty() ? "" : "; ") + shape_words(scenario, arrangement_seed(campaign, static_cast<int>(k)));
        if (scenario.spread.any() || scenario.brine.salinity > 0)
            words += (words.empty() ? "" : "; ") + ice_words(scenario, arrangement_seed(campaign, static_cast<int>(k)));
        if (scenario.field.endless()) words += (words.empty() ? "" : "; ") + endless_words(scenario);
        if (words.empty() || !said.insert(words).second) continue;
        sentences.push_back(fmt::format("case {}: {}.", campaign.cases[k].name, words));
    }
    return sentences;
}

namespace {

/// What is odd about a case, as a sentence without its end; empty where nothing is.
using Oddity = std::string (*)(const Case& one);

double largest_element(const Scenario& scenario) {
    if (scenario.sizes.law == SizeLaw::one) return scenario.floe.element;
    return std::ranges::max(floe_sizes(scenario), {}, &FloeShape::element).element;
}

double least_element(const Scenario& scenario) {
    if (scenario.sizes.law == SizeLaw::one) return scenario.floe.element;
    return std::ranges::min(floe_sizes(scenario), {}, &FloeShape::element).element;
}

std::string element_words(const Scenario& scenario, double element) {
    const bool own = scenario.sizes.law != SizeLaw::one && scenario.sizes.element != ElementSide::given;
    return own ? fmt::format("an element of {:.4g} m", element) : given(scenario, "floe.element_m");
}

std::string large_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const FloatingPlate plate{.thickness = scenario.floe.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity};
    const double length = plate.characteristic_length(scenario.ice.elastic_modulus);
    const double element = largest_element(scenario);
    if (one.pairing == Pairing::find_modulus || element < length) return {};
    return fmt::format(
        "{} is not below {:.3g} m, the characteristic length of ice of {:g} MPa; such elements are too large to show "
        "where the ice would bend and break",
        element_words(scenario, element), length, scenario.ice.elastic_modulus / unit::megapascal);
}

std::string thick_elements(const Case& one) {
    const Scenario& scenario = one.scenario;
    const double element = least_element(scenario);
    if (scenario.floe.thickness <= element) return {};
    return fmt::format("{} is more than {}; elements that are thicker than wide do not bend as a plate does",
                       given(scenario, "ice.thickness_m"), element_words(scenario, element));
}

std::string little_ice(const Case& one) {
    constexpr double little = 0.05;
    const Scenario& scenario = one.scenario;
    if (scenario.field.concentration >= little || scenario.arrangement.given()) return {};
    return fmt::format("{} leaves the field of {:.4g} m almost without ice; 75 is three quarters",
                       given(scenario, "field.concentration_percent"), scenario.field_length());
}

std::string odd_strength(const Case& one) {
    constexpr double weakest = 1 * unit::kilopascal;
    constexpr double strongest = 5000 * unit::kilopascal;
    const double strength = one.scenario.ice.bending_strength;
    if (strength >= weakest && strength <= strongest) return {};
    return fmt::format("{} is unlike any ice; sea ice has some 500, model ice some 40",
                       given(one.scenario, "ice.bending_strength_kPa"));
}

std::string soft_in_compression(const Case& one) {
    const Ice& ice = one.scenario.ice;
    if (ice.compressive_strength >= ice.bending_strength) return {};
    return fmt::format("{} is below {}; ice is several times stronger in compression than in bending",
                       given(one.scenario, "ice.compressive_strength_kPa"),
                       given(one.scenario, "ice.bending_strength_kPa"));
}

std::string few_sweeps(const Case& one) {
    constexpr int few = 10;
    if (one.scenario.general.iterations >= few) return {};
    return fmt::format("{} leaves contacts unsolved, and the load depends on it; 20 are enough with solver direct",
                       given(one.scenario, "general.iterations"));
}

std::string long_steps(const Case& one) {
    constexpr double most_of_thickness = 0.1;  // in the tank it is 0.04
    const Scenario& scenario = one.scenario;
    const double way = scenario.structure.speed * scenario.general.time_step;
    if (way <= most_of_thickness * scenario.floe.thickness) return {};
    return fmt::format(
        "{} and {} take the structure {:.3g} m on in each step, more than a tenth of the ice's thickness; a shorter "
        "step resolves how it meets the ice",
        given(scenario, "general.time_step_s"), given(scenario, "structure.speed_m_s"), way);
}

std::string narrow_gap(const Case& one) {
    constexpr double few = 2;
    const std::optional<BankGap> gap = one.scenario.gap();
    if (!gap || gap->floes >= few) return {};
    return fmt::format(
        "{} leaves {:.3g} m between the structure and the bank, {:.3g} sides of a floe; below two the load depends on "
        "the gap (docs/sea_ice.md), and floes vary has a wider channel",
        given(one.scenario, "field.half_width_m"), gap->breadth, gap->floes);
}

std::string light_structure(const Case& one) {
    constexpr double many = 100;
    const Scenario& scenario = one.scenario;
    if (!scenario.moorings.give_way()) return {};
    const double ratio = structure_over_floe(scenario);
    if (ratio >= many) return {};
    return fmt::format(
        "{} and the water that moves with it are {:.3g} times the heaviest floe: a floe that strikes it pushes it "
        "{:.2g} % too hard, as docs/moored.md says",
        given(scenario, "moorings.mass_t"), ratio, 100 / ratio);
}

constexpr std::array<Oddity, 9> oddities{large_elements, thick_elements,      little_ice,
                                         odd_strength,   soft_in_compression, few_sweeps,
                                         long_steps,     narrow_gap,          light_structure};

}  // namespace

std::vector<std::string> advice(const Campaign& campaign) {
    std::vector<std::string> sentences;
    for (const Oddity oddity : oddities) {
        std::string first;
        std::vector<std::string> others;
        for (const Case& one : campaign.cases) {
            const std::string odd = oddity(one);
            if (odd.empty()) continue;
            if (first.empty())
                first = fmt::format("case {}: {}", one.name, odd);
            else
                others.push_back(one.name);
        }
        if (first.empty()) continue;
        sentences.push_back(others.empty() ? first + "."
                                           : fmt::format("{}. The same holds for {}.", first, name_list(others)));
    }
    return sentences;
}

}  // namespace floes
