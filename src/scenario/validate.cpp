#include "scenario/validate.hpp"

#include <algorithm>
#include <cstddef>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

Contradictions contradictions_of(const Scenario& scenario) {
    Contradictions found;
    check_traced(scenario, found);
    check_level(scenario, found);
    if (!found.empty()) return found;  // all below take floes from these outlines
    check_sizes(scenario, found);
    check_spread(scenario, found);
    if (!found.empty()) return found;  // the checks below take floes from these laws
    check_shapes(scenario, found);
    if (!found.empty()) return found;
    check_elements(scenario, found);
    check_floating(scenario, found);
    check_stress_averaging(scenario, found);
    check_proportions(scenario, found);
    check_friction(scenario, found);
    check_solver(scenario, found);
    check_time(scenario, found);
    check_levels(scenario, found);
    check_averaging(scenario, found);
    check_shape(scenario, found);
    check_given_floes(scenario, found);
    if (!found.empty()) return found;  // the checks below would report the same again
    check_tow(scenario, found);
    if (found.empty()) check_path(scenario, found);
    check_moorings(scenario, found);
    check_boundaries(scenario, found);
    check_wake(scenario, found);
    check_bed(scenario, found);
    check_endless(scenario, found);
    if (scenario.shapes.kind != ShapeKind::voronoi) check_lattice(scenario, found);  // cells fit at any concentration
    check_poses(scenario, found);
    return found;
}

}  // namespace

std::vector<Contradiction> find_contradictions(const Scenario& scenario) {
    if (!scenario.arrangement.level()) return contradictions_of(scenario);
    Scenario whole = scenario;
    whole.floe = sheet_shape(scenario);
    return contradictions_of(whole);
}

std::string with_values(const Scenario& scenario, std::string_view sentence) {
    Scenario copy = scenario;
    const Keys keys = describe(copy);
    std::string text;
    while (!sentence.empty()) {
        const std::size_t open = std::min(sentence.find('<'), sentence.size());
        text += sentence.substr(0, open);
        sentence.remove_prefix(open);
        const std::size_t close = sentence.find('>');
        const std::string path(close < sentence.size() ? sentence.substr(1, close - 1) : "");
        const bool is_key = find_key(keys, path) != nullptr;
        text += is_key ? given(scenario, path) : std::string(sentence.substr(0, 1));
        sentence.remove_prefix(is_key ? close + 1 : std::min<std::size_t>(1, sentence.size()));
    }
    return text;
}

}  // namespace floes
