#pragma once
// The forecast of a campaign: measured costs of members and of the driver, a run in simulated time, and what floes plan
// says of it. The figures are in plan.cpp, with the commands that produced them.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/inventory.hpp"

namespace floes {

/// Costs of the driver. All times in s, all sizes in bytes.
struct DriverCosts {
    // -- before the first member
    double start_up = 0;           ///< of a single rank
    double start_up_per_rank = 0;  ///< for each further rank: launch, campaign, hello

    // -- the master's thread
    double send = 0;              ///< a message to another rank
    double assign = 0;            ///< each member in it
    double receive = 0;           ///< a message of another rank
    double answer = 0;            ///< each answer in it: take it, keep it in the journal
    double own_member = 0;        ///< hand out and keep a member of the master's own cores
    double kept = 0;              ///< each member that another writer has kept
    double receive_per_byte = 0;  ///< for each byte of an answer of another rank
    double keep_per_byte = 0;     ///< for each byte of the record
    double sync = 0;              ///< fdatasync of the journal
    double sync_interval = 0;     ///< s between two syncs
    double publish = 0;           ///< write the campaign file
    double publish_per_member = 0;
    double publish_per_byte = 0;  ///< for each byte of its records
    double publish_interval = 0;  ///< minimum time between two publications
    double publish_share = 0;     ///< largest share of the time during the run
    double read_per_member = 0;   ///< where one core writes it later: read the journals of other writers before that
    double read_per_byte = 0;
    double order_per_member = 0;  ///< where all writers publish a piece: tell each which records are in it
    double index = 0;             ///< write the campaign file that refers to pieces, more than one with rows of its own
    double index_per_piece = 0;   ///< refer to a piece in it
    double digest_per_piece = 0;  ///< open a piece to digest what is in all
    double digest_per_member = 0;  ///< digest its values in all datasets, which the writers share out
    double digest_texts = 0;       ///< those of the dearest dataset, which one writer digests

    double memory_per_member = 0;  ///< bytes: the plan of what is to do, the notes of what is done, publishing

    // -- a worker
    double member = 0;             ///< begin and end a member on a core
    double member_per_byte = 0;    ///< for each byte of the packed histories
    double report = 0;             ///< in the rank's message thread: write an answer and send it
    double report_per_byte = 0;    ///< for each byte of the record
    double longest_held_back = 0;  ///< longest time for which an answer is held back
    double most_held_back = 0;     ///< largest number of answers held back

    // -- messages
    double latency = 0;  ///< of a message
    double transfer_per_byte = 0;
    double longest_pause = 0;  ///< longest pause between two polls of an idle rank
};

/// Costs of the present driver on the machine named in plan.cpp.
DriverCosts measured_costs();

/// Costs of a member, measured as plan.cpp says.
struct MemberCosts {
    double direct_per_unit = 2.4e-6;    ///< s per unit of expected_cost(), an element in a step; beams solved exactly
    double lanes_per_unit = 1.6e-6;     ///< the same with sweeps over joints, as the paper has them
    double stock_per_unit = 12e-6;      ///< the same with Bullet's own solver
    double jam = 4.5;                   ///< times this at an upright wall, where jams take many sweeps
    double variation = 0.05;            ///< of the run times of a case: standard deviation over mean
    double history_bytes = 7;           ///< per number of a history, packed; less of ice that leaves the hull
    double file_per_record_byte = 0.8;  ///< of everything else: the file has rows that several records share only once
    double file_bytes = 165e3;          ///< of a campaign file without members
    /// A sentence: where and when.
    std::string source =
        "the expected cost of each member, times the measured time per unit on a Xeon of 2023 (AVX-512); "
        "42 of 46 campaigns took 0.7 to 2.3 times as long. --from takes those of members that ran";
};

// A run in simulated time: the real Scheduler gets the events of a real run, at times that follow from the members and
// the measured costs of the driver. Deterministic: the same members, machine and costs give the same forecast to the
// last bit.
//
//     const Forecast forecast = simulate(members, machine_of(1000, 16), measured_costs());

/// A member as the driver sees it.
struct SimulatedMember {
    double run_time = 0;       ///< s, >= 0
    double expected_cost = 1;  ///< used by the scheduler, any unit, > 0
    double record_bytes = 0;   ///< in a message and in the journal
    double file_bytes = 0;     ///< in the campaign file
    double packed_bytes = 0;   ///< part of the record: histories that the rank has to pack
};

struct Machine {
    std::vector<int> cores_of_rank;  ///< at least one rank; each at least one core
    /// Processors shared by all ranks if there are too few for all; members then sleep instead of computing. 0: every
    /// thread has its own processor.
    int processors = 0;
    int writers = 0;  ///< as Groups has it
};

/// `cores` spread evenly over `ranks`. Throws InputError unless 1 <= ranks <= cores.
Machine machine_of(int cores, int ranks);

struct Forecast {
    double wall_time = 0;      ///< s, from the start of the program to its end
    int writers = 1;           ///< ranks that keep records
    double start_up = 0;       ///< s of it before the first member
    double last_member = 0;    ///< s from the start until the last answer is in the journal
    double run_time = 0;       ///< s, of all members together
    double efficiency = 0;     ///< run_time / (cores x wall_time)
    double master_load = 0;    ///< fraction of the time from start-up to the last answer in which the master works
    double writer_load = 0;    ///< the same of the busiest other writer
    double file_time = 0;      ///< s in which the writers publish the campaign file at the end, or one core later
    double journal_bytes = 0;  ///< of all records
    double file_bytes = 0;
};

/// `with_file`: whether the run ends with the campaign file, or with its journals.
Forecast simulate(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                  bool with_file = true);

// Run times and sizes measured in a finished or running campaign.

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

/// Memory that a core needs for the largest of its members, bytes. Measured: 0.6 to 1.1 times that, in members of 216
/// to 7,500 elements of seven shipped configurations, and 1.9 times where level ice piles up for minutes.
double core_memory(const Campaign& campaign);

/// What a stop rule will take, a sentence: the arrangements before which it does not end, and how long their members
/// that are not done take on so many cores; of a part, how many of them are its own, and how long those take. `done`:
/// members that are; `pace`: s a unit of expected cost that they took; 0: not known.
std::string stop_forecast(const Campaign& campaign, const CampaignPart& part, int done, double pace, int cores);

/// The mean of these for the members of a case, s.
double expected_run_time(const Campaign& campaign, int case_index);

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

// What a member costs, and would cost with other elements and windows: what to know before a long run.

/// A sentence for each case whose members take a minute and more, of a hull that gives way ten seconds and more: what
/// one takes, and what with larger and smaller elements and other windows, as far as these can be run and nothing is
/// odder about them (advice()). Cases with the words of an earlier one have none; of more than eight, one sentence has
/// the least and the most.
std::vector<std::string> cost_words(const Campaign& campaign);

}  // namespace floes
