#pragma once
// A campaign in sentences: what is wrong with it, what its loads rest on, and what would change them.

#include <string>
#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// Sentences, the worst first; none for a campaign that nothing is wrong with. `summary`: of the sample.
std::vector<std::string> warnings_of(const Sample& sample, const Summary& summary);

/// A line for each.
std::string warning_lines(const std::vector<std::string>& warnings);

struct CampaignAnswer {
    std::vector<std::string> warnings;  ///< what is wrong with the whole
    std::vector<std::string> basis;     ///< ice field, members, method, and how far it extrapolates
    std::vector<std::string> changes;   ///< the axes of a design that change the mean load most, or what all variations
                                        ///< of a base case do together; empty where page one has the differences
};

/// Of a figure what a reader has to know with it is in `basis`: methods that differ, and how far it extrapolates.
CampaignAnswer find_answer(Evidence& evidence);

}  // namespace floes
