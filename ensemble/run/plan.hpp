#pragma once
// Run times and sizes measured in a finished or running campaign.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/simulate.hpp"

namespace floes {

struct MeasuredRun {
    Campaign campaign;
    std::vector<double> wall_time;  ///< s, of each member, in member order; NaN unless it is done
    double journal_bytes = 0;       ///< 0: there is none
    double file_bytes = 0;          ///< 0: there is none, or it is older than the journal
};

/// From the journal beside the campaign file, or from the campaign file alone. Throws InputError if neither can be
/// read.
MeasuredRun read_measured_run(const std::filesystem::path& campaign_file);

// Plan of a campaign before it is run: time and size of each member, and the forecast for a number of cores.

/// The members of a campaign, in member order, and a sentence on the origin of their run times.
struct PlannedMembers {
    std::vector<SimulatedMember> members;
    std::string source;
};

/// Run times from the expected cost of each member, times the measured time per unit on the machine named in the
/// sentence, with the scatter observed there.
PlannedMembers expected_members(const Campaign& campaign);

/// Run times from a run of this or a similar campaign. A member draws one of the times measured for the case of the
/// same name, or for all cases if there is none, scaled by the expected cost. The draws depend only on the campaign's
/// seed and the member's number. Throws InputError if no member is done yet.
PlannedMembers measured_members(const Campaign& campaign, const MeasuredRun& run);

/// Sets the size of every record, and scales its size in the campaign file accordingly.
void set_record_bytes(PlannedMembers& planned, double bytes);

/// One setting and its forecast.
struct PlanRow {
    int cores = 1;
    int ranks = 1;
    Forecast forecast;
    double master_memory = 0;  ///< bytes: of its heap for all members, done or not
};

/// Default number of ranks for this number of cores: one for each node of up to 64.
int usual_ranks(int cores);

PlanRow plan_row(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                 bool with_file = true);

}  // namespace floes
