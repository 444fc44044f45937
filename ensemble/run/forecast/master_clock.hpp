#pragma once
// Simulated time of the master's single thread, which works sequentially, syncs the journal when due, and publishes.
// Times in s from the start of the run.

#include <queue>
#include <vector>

#include "forecast/measured_costs.hpp"

namespace floes {

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
    /// Both must outlive the clock. `begin`: when the first member can be handed out.
    MasterClock(const DriverCosts& costs, Processors& processors, double begin);

    /// Notices an event at `ready` or later; `asleep`: a message, which is found by polling.
    void notice(double ready, bool asleep);
    /// Works for this time.
    void work(double seconds);
    /// Appends a record of this size to the journal.
    void keep(double bytes);
    /// Syncs everything to the disk and publishes.
    void finish();

    double now() const { return now_; }    ///< when the master is free
    double busy() const { return busy_; }  ///< time spent working, s

  private:
    void tend(double until);
    void publish();

    const DriverCosts& costs_;
    Processors& processors_;
    double now_;
    double busy_ = 0;
    double last_sync_;
    double next_publish_;
    bool synced_ = true;
    bool published_ = true;
    double members_ = 0;
    double bytes_ = 0;
};

/// Delay until an arrived message is noticed by a rank that has received nothing for `silence` seconds. Such a rank
/// sleeps about as long as it has already waited, at most costs.longest_pause.
double notice_delay(const DriverCosts& costs, double silence);

}  // namespace floes
