#pragma once
// A campaign in numbers, before it is run: how long each member takes, how large it is, and what that comes to on so
// many cores.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "forecast/measured_run.hpp"
#include "forecast/simulate.hpp"

namespace floes {

/// The members of a campaign, in member order, and where their run times come from, a sentence.
struct PlannedMembers {
    std::vector<SimulatedMember> members;
    std::string source;
};

/// By the expected cost of each member, times what a unit of it took on the machine named in the sentence, with the
/// scatter that was seen there.
PlannedMembers expected_members(const Campaign& campaign);

/// By a run of this or a like campaign. A member draws one of the times measured for the case of its name, in
/// proportion to the expected cost where that differs; of all cases, where there is no case of its name. The draws
/// depend on the campaign's seed and the member's number alone. Throws InputError when no member is done yet.
PlannedMembers measured_members(const Campaign& campaign, const MeasuredRun& run);

/// Every record becomes so large, and takes as much less or more in the campaign file.
void set_record_bytes(PlannedMembers& planned, double bytes);

/// One setting, and what comes of it.
struct PlanRow {
    int cores = 1;
    int ranks = 1;
    Forecast forecast;
    double master_memory = 0;  ///< bytes: it holds every record of the run but its history
};

/// Ranks of so many cores when nothing is said: one for each node of up to 64.
int usual_ranks(int cores);

PlanRow plan_row(std::span<const SimulatedMember> members, int cores, int ranks, const DriverCosts& costs);

}  // namespace floes
