#pragma once
// What `floes plan` prints.

#include <span>
#include <string>
#include <vector>

#include "forecast/plan.hpp"
#include "tables/data_rows.hpp"

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

/// For people; with a line on the bottleneck of each setting that has one.
std::string plan_table(const PlanHead& head, std::span<const PlanRow> rows);
/// For programs: in JSON one object, in CSV a line for each setting; times in s, sizes in bytes.
std::vector<DataRows> plan_records(const PlanHead& head, std::span<const PlanRow> rows);

}  // namespace floes
