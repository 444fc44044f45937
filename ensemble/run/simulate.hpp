#pragma once
// Measured costs of members and of the driver. The figures are in measured_costs.cpp, with the commands that produced
// them.

#include <queue>
#include <span>
#include <string>
#include <vector>

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
    double read_per_member = 0;   ///< read the journals of other writers before that
    double read_per_byte = 0;

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

/// Costs of the present driver on the machine named in measured_costs.cpp.
DriverCosts measured_costs();

/// Costs of a member.
struct MemberCosts {
    double direct_per_unit = 0;  ///< s per unit of expected_cost(), an element in a step; beams solved exactly
    double lanes_per_unit = 0;   ///< the same with sweeps over joints, as the paper has them
    double stock_per_unit = 0;   ///< the same with Bullet's own solver
    double jam = 0;              ///< times this at an upright wall, where jams take many sweeps
    double variation = 0;        ///< of the run times of a case: standard deviation over mean
    double history_bytes =
        0;  ///< per number of a history, packed, in record and campaign file: of ice that leaves the hull less
    double file_per_record_byte = 0;  ///< of everything else: the file has rows that several records share only once
    double file_bytes = 0;            ///< of a campaign file without members
    std::string source;               ///< a sentence: where and when
};

MemberCosts measured_member_costs();

// Simulated time of the master's single thread, which works sequentially, syncs the journal when due, and publishes,
// with other writers only at the end. Times in s from the start of the run.

/// The processors shared by all threads, first come, first served.
class Processors {
  public:
    /// count 0: every thread has its own.
    explicit Processors(int count);

    /// When `work` seconds of work end that can start at `ready`. To be called in order of time.
    double run(double ready, double work);

  private:
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at_;
};

class MasterClock {
  public:
    /// Both must outlive the clock. `begin`: when the first member can be handed out. `with_file`: it publishes.
    MasterClock(const DriverCosts& costs, Processors& processors, double begin, bool with_file);

    /// Notices an event at `ready` or later; `asleep`: a message, which is found by polling.
    void notice(double ready, bool asleep);
    /// Works for this time.
    void work(double seconds);
    /// Appends a record of this size to the journal.
    void keep(double bytes);
    /// Notes a record of this size that another writer has kept.
    void keep_in_part(double bytes);
    /// Syncs everything to the disk.
    void finish();
    /// Writes the campaign file.
    void publish();

    double now() const { return now_; }    ///< when the master is free
    double busy() const { return busy_; }  ///< time spent working, s

  private:
    void tend(double until);

    const DriverCosts& costs_;
    Processors& processors_;
    double now_;
    double busy_ = 0;
    double last_sync_;
    double next_publish_;
    bool with_file_;
    bool synced_ = true;
    bool published_ = true;
    double members_ = 0;
    double bytes_ = 0;
    double members_in_parts_ = 0;
    double bytes_in_parts_ = 0;
};

/// Delay until an arrived message is noticed by a rank that has received nothing for `silence` seconds. Such a rank
/// sleeps about as long as it has already waited, at most costs.longest_pause.
double notice_delay(const DriverCosts& costs, double silence);

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
    double file_time = 0;      ///< s in which one core writes the campaign file, at the end or later
    double journal_bytes = 0;  ///< of all records
    double file_bytes = 0;
};

/// `with_file`: whether the run ends with the campaign file, or with its journals.
Forecast simulate(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                  bool with_file = true);

}  // namespace floes
