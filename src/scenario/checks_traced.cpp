// Contradictions within outlines that were traced, and between them and the rest.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "outline/elements.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/shaped_floes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

const std::vector<std::string> outline_keys{"shapes.file", "shapes.outlines", "shapes.kind"};

/// ", and 3 more" for others of which the same is true.
std::string and_more(std::ptrdiff_t others) {
    return others > 0 ? fmt::format(" (and {} more)", others) : "";
}

std::optional<std::string> fault_of(const TracedOutlines& traced) {
    for (std::size_t i = 0; i < traced.outlines.size(); ++i) {
        const Outline& one = traced.outlines[i];
        if (const auto fault = floes::fault_of(one))
            return fmt::format("{} is no floe: {}", outline_name(traced, i), *fault);
        if (one.size() > most_outline_corners)
            return fmt::format(
                "{} has {} corners, more than the {} of a floe; give it by shapes.file, which takes "
                "fewer",
                outline_name(traced, i), one.size(), most_outline_corners);
    }
    if (!traced.areas.empty() && traced.areas.size() != traced.outlines.size())
        return fmt::format("shapes.traced_areas_m2 has {} areas for {} outlines; leave it out, or give one for each",
                           traced.areas.size(), traced.outlines.size());
    return std::nullopt;
}

/// What became convex and covers too much more than what was traced.
void check_added(const TracedOutlines& traced, Contradictions& found) {
    if (traced.areas.empty()) return;
    const std::vector<double> added = traced_added(traced);
    const auto worst = std::ranges::max_element(added);
    const auto above = std::ranges::count_if(added, [&](double one) { return one > traced.most_added; });
    if (above == 0) return;
    found.push_back(
        {{"shapes.most_added_percent", "shapes.file"},
         fmt::format("{} is not convex: without its bays and holes it would cover {:.3g} % more, above "
                     "shapes.most_added_percent = {:g}{}; trace it as several floes, allow more, or leave it out",
                     outline_name(traced, static_cast<std::size_t>(worst - added.begin())), 100 * *worst,
                     100 * traced.most_added, and_more(above - 1))});
}

/// Each has to be a sheet of at least one element.
void check_sheets(const Scenario& scenario, Contradictions& found) {
    const TracedOutlines& traced = scenario.shapes.traced;
    double elements = 0;
    for (const Outline& one : traced.outlines)
        elements += std::abs(area_of(one)) * std::pow(traced.scale / scenario.floe.element, 2);
    const double each = static_cast<double>(scenario.field.floes) / static_cast<double>(traced.outlines.size());
    check_element_count(scenario, elements * std::max(1.0, each), found);
    if (!found.empty()) return;
    const std::vector<SingleFloe> floes = floes_as_traced(scenario);
    const auto refuse = [&](const auto& breadth_of, double least, const std::string& key, const std::string& what) {
        const auto narrowest = std::ranges::min_element(floes, {}, breadth_of);
        const auto below = std::ranges::count_if(floes, [&](const auto& one) { return breadth_of(one) < least; });
        if (below == 0) return;
        found.push_back(
            {{key, "shapes.scale", "shapes.file", "shapes.outlines"},
             fmt::format("{}{} {} {:.4g} m, less than {}; leave such floes out of the file, or change shapes.scale or "
                         "shapes.unit",
                         outline_name(traced, static_cast<std::size_t>(narrowest - floes.begin())), and_more(below - 1),
                         what, breadth_of(*narrowest), given(scenario, key))});
    };
    refuse([](const SingleFloe& one) { return 2 * inner_radius(one.shape.outline); }, scenario.floe.thickness,
           "ice.thickness_m", "is thinner than the ice: the widest circle within has a diameter of");
    if (!found.empty()) return;
    refuse([](const SingleFloe& one) { return one.shape.breadth; }, scenario.floe.element * (1 - 1e-9),
           "floe.element_m", "is smaller than an element: its breadth is");
}

}  // namespace

void check_traced(const Scenario& scenario, Contradictions& found) {
    const Shapes& shapes = scenario.shapes;
    const bool as_they_lie = scenario.arrangement.method == ArrangementMethod::traced;
    if (as_they_lie && !shapes.from_file())
        found.push_back({{"arrangement.method", "shapes.kind"},
                         fmt::format("{} needs shapes.kind = \"file\", whose outlines have places",
                                     given(scenario, "arrangement.method"))});
    if (!shapes.from_file()) return;
    const TracedOutlines& traced = shapes.traced;
    if (traced.outlines.empty()) {
        found.push_back({outline_keys, fmt::format("{} needs outlines; give shapes.file or shapes.outlines",
                                                   given(scenario, "shapes.kind"))});
        return;
    }
    if (scenario.sizes.law != SizeLaw::one)
        found.push_back({{"sizes.law", "shapes.kind"},
                         fmt::format("{} is not possible with {}: the outlines have their own sizes; take sizes.law = "
                                     "\"one\", and shapes.scale for larger or smaller ones",
                                     given(scenario, "shapes.kind"), given(scenario, "sizes.law"))});
    if (as_they_lie && traced.outlines.size() != static_cast<std::size_t>(scenario.field.floes))
        found.push_back({{"field.floes", "shapes.file", "shapes.outlines"},
                         fmt::format("{} is not the number of outlines, {}, which all lie where they were traced; "
                                     "make them agree, or take arrangement.method = \"scattered\"",
                                     given(scenario, "field.floes"), traced.outlines.size())});
    if (const auto fault = fault_of(traced)) found.push_back({outline_keys, *fault});
    if (!found.empty()) return;
    check_added(traced, found);
    if (found.empty()) check_sheets(scenario, found);
}

}  // namespace floes
