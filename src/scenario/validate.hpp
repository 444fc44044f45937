#pragma once
// Contradictions: what no single key shows, because each value is allowed and together they make no simulation.

#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace floes {

struct Contradiction {
    std::vector<std::string> keys;  ///< the keys involved, the likeliest to be wrong first
    std::string sentence;           ///< what is wrong, with the values, and what to try
};

/// All contradictions in the scenario; empty when it can be simulated. Each field is taken to be in its own range.
std::vector<Contradiction> find_contradictions(const Scenario& scenario);

/// Throws InputError with the first contradiction's sentence.
void validate(const Scenario& scenario);

}  // namespace floes
