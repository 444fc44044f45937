#pragma once
// The loop of rank 0: it passes events to the scheduler and obeys its commands, keeps the results, and shows the
// progress. The cores of rank 0 compute like those of any other rank; this thread mostly sleeps.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "run/crew.hpp"
#include "run/link.hpp"
#include "run/messages.hpp"
#include "run/progress.hpp"
#include "run/ranks.hpp"
#include "run/recorder.hpp"
#include "run/signals.hpp"
#include "run/worker.hpp"
#include "run/writer.hpp"
#include "schedule/scheduler.hpp"

namespace floes {

/// What the master uses besides its crew.
struct MasterTools {
    Link& link;
    const Groups& groups;
    Recorder& recorder;
    Progress& progress;
    const StopSignals& signals;
};

/// Time limits of a run.
struct MasterLimits {
    Walltime walltime;
    SilenceLimits patience;
};

class Master {
  public:
    /// `campaign` and the tools must outlive the master. `setup`: of the crew of this rank. `mustered`: of muster().
    Master(const Campaign& campaign, const MasterTools& tools, const CrewSetup& setup, const Muster& mustered,
           const MasterLimits& limits);

    /// Returns when every member has an answer or the run was stopped, every worker has said farewell, and every writer
    /// has closed its journal. Stops when no rank is left that computes. Throws RunError if a rank reports trouble or
    /// the journal cannot be written.
    void run();

    /// RankWatch::part(), to be called when everything is on the disk.
    void part() { ranks_.part(); }

    /// A writer was lost, and perhaps its last second with it.
    bool lost_a_writer() const { return lost_a_writer_; }

    /// What stopped the run, e.g. "SIGTERM"; empty if nothing did, or if all members were done nevertheless.
    std::string stopped_by() const;

  private:
    void advance();
    void receive(const Message& message);
    void finished(int worker, int number, MemberRecord record);
    void finished_in_piece(const Kept& kept);
    void note_pace(int number, double wall_time);
    void give_up(const CrewTrouble& trouble);
    void tell_time_left();
    void watch_ranks(std::chrono::steady_clock::time_point now);
    void watch_time(std::chrono::steady_clock::time_point now);
    void request_stop(const std::string& reason);
    void end_when_precise();
    void lose(int rank);
    void close_pieces();
    void handle(const Event& event, MemberRecord* record = nullptr, const Kept* in_piece = nullptr);
    void keep(int number, MemberRecord& record);
    void keep(const Kept& in_piece);
    void note_failure(const Retry& retry, const MemberRecord& record);
    void obey(const Dismiss& command);
    void hand_out();
    std::string name_of(int number) const;
    ProgressState state() const;

    const Campaign& campaign_;
    Link& link_;
    const Groups& groups_;
    Recorder& recorder_;
    Progress& progress_;
    const StopSignals& signals_;
    Walltime walltime_;
    Scheduler scheduler_;
    Scribe scribe_;
    Crew crew_;
    Pause pause_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::map<int, std::vector<Assignment>> handed_out_;  // by worker, since the last hand_out()
    std::map<int, std::vector<std::string>> failures_;   // by member, the reasons of failed attempts that are retried
    RankWatch ranks_;
    double pace_;                // s per unit of cost, of the slowest member so far; 0: unknown
    std::set<int> open_pieces_;  // writers that have not closed theirs
    bool lost_a_writer_ = false;
    std::string stop_reason_;
    bool dismissed_ = false;  // the crew of this rank
    bool left_ = false;
};

}  // namespace floes
