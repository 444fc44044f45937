#pragma once
// A campaign in sentences: what is wrong with it, what its loads rest on, and all of it on one screen.

#include <string>
#include <vector>

#include "findings/points.hpp"
#include "tables/section.hpp"

namespace floes {

/// Sentences, the worst first; none for a campaign that nothing is wrong with. `summary`: of the sample.
std::vector<std::string> warnings_of(const Sample& sample, const Summary& summary);

/// A line for each.
std::string warning_lines(const std::vector<std::string>& warnings);

// The answer of a campaign in sentences: the loads, what they rest on, and what would change them.

struct CampaignAnswer {
    std::vector<std::string> warnings;  ///< what is wrong with the whole
    std::vector<std::string> basis;     ///< ice field, members, method, and how far it extrapolates
    std::vector<std::string> changes;   ///< the axes of a design that change the mean load most, or what all variations
                                        ///< of a base case do together; empty where page one has the differences
};

/// Of a figure what a reader has to know with it is in `basis`: methods that differ, and how far it extrapolates.
CampaignAnswer find_answer(Evidence& evidence);

// A campaign on one screen: what is wrong with it, a row for each case, and what comes next. The whole is in the other
// findings.

/// Cases that are shown one by one; of a design with more of them, its axes and its extreme points are.
inline constexpr std::size_t most_overview_rows = 12;

/// The points with the least and the largest mean load, in words; none without a result.
std::vector<std::pair<std::string, std::size_t>> extreme_points(const Summary& summary);

/// Warnings and the table. Differences are to the evidence's reference, otherwise to the first case; a design has none.
Section overview_section(const Evidence& evidence, const Sensitivity& sensitivity);

/// The file and the commands for it, `program` as people call it.
Section next_commands(const Evidence& evidence, const std::string& program);

}  // namespace floes
