#pragma once
// The answer of a campaign in sentences: the loads, what they rest on, and what would change them.

#include <string>
#include <vector>

#include "findings/evidence.hpp"

namespace floes {

struct CampaignAnswer {
    std::vector<std::string> warnings;  ///< what is wrong with the whole
    std::vector<std::string> loads;     ///< of each case with done members: mean and design load with their intervals,
                                        ///< and doubts; of a design its least and its largest mean
    std::vector<std::string> basis;     ///< ice field, members, method, and how far it extrapolates
    std::vector<std::string> changes;   ///< the axes of a design that change the mean load most, or the other cases
};

/// Design loads are left out for a campaign of many cases, and where the members did not average their load.
CampaignAnswer find_answer(Evidence& evidence);

}  // namespace floes
