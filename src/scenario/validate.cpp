#include "scenario/validate.hpp"

#include <cstddef>

#include "scenario/keys.hpp"

namespace floes {

std::vector<Contradiction> find_contradictions(const Scenario& scenario) {
    Contradictions found;
    check_traced(scenario, found);
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
    check_endless(scenario, found);
    check_lattice(scenario, found);
    check_poses(scenario, found);
    return found;
}

std::string with_values(const Scenario& scenario, std::string_view sentence) {
    std::string text;
    for (std::size_t from = 0; from < sentence.size();) {
        const std::size_t open = sentence.find('<', from);
        const std::size_t close = open == sentence.npos ? open : sentence.find('>', open);
        text += sentence.substr(from, close == sentence.npos ? close : open - from);
        if (close == sentence.npos) break;
        text += given(scenario, std::string(sentence.substr(open + 1, close - open - 1)));
        from = close + 1;
    }
    return text;
}

}  // namespace floes
