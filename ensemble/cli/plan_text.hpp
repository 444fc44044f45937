#pragma once
// What `floes plan` prints.

#include <span>
#include <string>

#include "forecast/plan.hpp"
#include "tables/section.hpp"

namespace floes {

/// Values common to all rows.
struct PlanHead {
    std::string title;
    int members = 0;
    double mean_run_time = 0;  ///< s
    double longest = 0;        ///< s
    double message_bytes = 0;  ///< the largest answer
    std::string source;        ///< origin of the run times
    bool calibrates = false;   ///< cases are calibrated first, which the plan does not count
};

PlanHead plan_head(const Campaign& campaign, const PlannedMembers& planned);

/// For people with a note on the bottleneck of each setting that has one. In JSON one object, in CSV a line for each
/// setting; times in s, sizes in bytes.
Section plan_section(const PlanHead& head, std::span<const PlanRow> rows);

}  // namespace floes
