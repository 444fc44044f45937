#include "scenario/validate.hpp"

#include <algorithm>
#include <cstddef>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

using Check = void (*)(const Scenario&, Contradictions&);

Contradictions contradictions_of(const Scenario& scenario) {
    // Each takes for granted what those before found nothing wrong with.
    static const std::vector<std::vector<Check>> stages{
        {check_traced, check_level},  // outlines of floes
        {check_sizes, check_spread},  // laws of floes
        {check_shapes},
        {check_elements, check_floating, check_stress_averaging, check_proportions, check_friction, check_solver,
         check_time, check_levels, check_averaging, check_shape, check_given_floes},
        {check_tow, check_path, check_moorings, check_boundaries, check_wake, check_bed, check_endless, check_lattice,
         check_poses}};
    Contradictions found;
    for (auto stage = stages.begin(); stage != stages.end() && found.empty(); ++stage)
        for (const Check check : *stage) check(scenario, found);
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
