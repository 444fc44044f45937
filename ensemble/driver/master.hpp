#pragma once
// The loop of rank 0: it carries events to the scheduler and its commands out again, keeps the results, and shows the
// progress. Its own cores work like any other rank's; only this thread sleeps.

#include <map>
#include <string>
#include <vector>

#include "driver/crew.hpp"
#include "driver/messages.hpp"
#include "driver/muster.hpp"
#include "driver/pause.hpp"
#include "driver/progress.hpp"
#include "driver/recorder.hpp"
#include "driver/scribe.hpp"
#include "driver/signals.hpp"
#include "schedule/scheduler.hpp"
#include "wire/link.hpp"

namespace floes {

class Master {
  public:
    /// All references must outlive the master. `mustered`: of muster().
    Master(const Campaign& campaign, Link& link, Recorder& recorder, Progress& progress, const StopSignals& signals,
           const MemberFunction& compute, const Muster& mustered);

    /// Until every member has an answer or the run was stopped, and every worker has said farewell. Throws RunError
    /// when a rank is in trouble or the journal cannot be written.
    void run();

    /// Who asked for the stop, e.g. "SIGTERM"; empty when nobody did or all was done all the same.
    std::string stopped_by() const;

  private:
    void advance();
    void receive(const Message& message);
    void finished(int worker, int number, const MemberRecord& record);
    void request_stop(const std::string& reason);
    void end_when_precise();
    void handle(const Event& event, const MemberRecord* record = nullptr);
    void obey(const Assign& command);
    void obey(const Dismiss& command);
    void report_failure(int number, const MemberRecord& record);
    ProgressState state() const;

    const Campaign& campaign_;
    Link& link_;
    Recorder& recorder_;
    Progress& progress_;
    const StopSignals& signals_;
    Scheduler scheduler_;
    Scribe scribe_;
    Crew crew_;
    Pause pause_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::string stop_reason_;
    bool dismissed_ = false;  // the crew of this rank
    bool left_ = false;
};

}  // namespace floes
