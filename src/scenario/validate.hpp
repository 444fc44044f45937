#pragma once
// Contradictions between keys: values that are allowed one by one but cannot be simulated together.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scenario/scenario.hpp"

namespace floes {

struct Contradiction {
    std::vector<std::string> keys;  ///< the keys involved, the likeliest to be wrong first
    std::string sentence;           ///< what is wrong, with the values, and what to try
};

using Contradictions = std::vector<Contradiction>;

/// All contradictions in the scenario; empty when it can be simulated. Each field is taken to be in its own range.
std::vector<Contradiction> find_contradictions(const Scenario& scenario);

/// Mass of a moored structure, with the water that moves with it, over that of the heaviest floe.
double structure_over_floe(const Scenario& scenario);

/// The same of the mass with which it answers the worst blow on its waterline, along the normal there: less than its
/// own where it turns, 1/m = Jᵀ M⁻¹ J over its free motions.
double struck_over_floe(const Scenario& scenario);

/// Adds a contradiction, its sentence as fmt::format() takes it.
template <class... Values>
void refuse(Contradictions& found, std::vector<std::string> keys, fmt::format_string<Values...> sentence,
            Values&&... values) {
    found.push_back({std::move(keys), fmt::format(sentence, std::forward<Values>(values)...)});
}

/// "<floe.element_m>" in the sentence becomes the key with its value, as given() shows it; other text in angle
/// brackets, such as the name of an outline, stays as it is.
std::string with_values(const Scenario& scenario, std::string_view sentence);

/// The same of a sentence that has keys with their values in it, as with_values() puts them there.
template <class... Values>
void refuse(const Scenario& scenario, Contradictions& found, std::vector<std::string> keys,
            fmt::format_string<Values...> sentence, Values&&... values) {
    found.push_back({std::move(keys), with_values(scenario, fmt::format(sentence, std::forward<Values>(values)...))});
}

/// The checks behind find_contradictions(), in checks_*.cpp. Each adds what it finds.
void check_sizes(const Scenario& scenario, Contradictions& found);   ///< laws of sizes have floes of whole elements
void check_traced(const Scenario& scenario, Contradictions& found);  ///< outlines of a file are floes
void check_shapes(const Scenario& scenario, Contradictions& found);  ///< nothing that polygons cannot do yet
void check_spread(const Scenario& scenario, Contradictions& found);  ///< laws of the ice give ice that can be computed
void check_elements(const Scenario& scenario, Contradictions& found);  ///< floes are whole squares, not too many
void check_sides(const Scenario& scenario, Contradictions& found);     ///< floes are whole squares
void check_element_count(const Scenario& scenario, double elements, Contradictions& found);  ///< of all floes
void check_stress_averaging(const Scenario& scenario, Contradictions& found);  ///< over not too many steps
void check_proportions(const Scenario& scenario, Contradictions& found);  ///< sheets that bend a little, and a field
void check_friction(const Scenario& scenario, Contradictions& found);     ///< bounds that hold a coefficient
void check_solver(const Scenario& scenario, Contradictions& found);       ///< it refuses nothing that it is to do
void check_floating(const Scenario& scenario, Contradictions& found);     ///< the ice floats, heave is stable
void check_time(const Scenario& scenario, Contradictions& found);         ///< whole steps, segments, history values
void check_levels(const Scenario& scenario, Contradictions& found);       ///< load levels rise
void check_averaging(const Scenario& scenario, Contradictions& found);    ///< whole steps within a segment, rising
void check_shape(const Scenario& scenario, Contradictions& found);        ///< a body that stands in the water
void check_tow(const Scenario& scenario, Contradictions& found);          ///< it meets the ice and stays in it
void check_path(const Scenario& scenario, Contradictions& found);         ///< likewise, of a path that is not straight
void check_moorings(const Scenario& scenario, Contradictions& found);     ///< they hold, and a step resolves the motion
/// Those of moorings alone, which other programs' moorings go through too. `name` begins the sentences about a line.
void check_hanging(const HangingLine& line, const std::string& name, Contradictions& found);  ///< it can be hung up
void check_matrices(const Moorings& moorings, Contradictions& found);     ///< symmetric, and damping takes energy
void check_boundaries(const Scenario& scenario, Contradictions& found);   ///< what presses has something to press on
void check_wake(const Scenario& scenario, Contradictions& found);         ///< the structure strikes no resting floe
void check_bed(const Scenario& scenario, Contradictions& found);          ///< ice floats above it at the start
void check_endless(const Scenario& scenario, Contradictions& found);      ///< such ice comes from ahead and rests there
void check_level(const Scenario& scenario, Contradictions& found);        ///< one sheet that fits into the field
void check_lattice(const Scenario& scenario, Contradictions& found);      ///< the floes fit
void check_given_floes(const Scenario& scenario, Contradictions& found);  ///< each is ice that floats, in elements
void check_poses(const Scenario& scenario, Contradictions& found);        ///< given poses belong to the field

}  // namespace floes
