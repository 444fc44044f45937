#pragma once
// The time of the master's one thread: it does one thing after the other, brings the journal to the disk when that is
// due, and publishes. Times in s from the start of the run.

#include <queue>
#include <vector>

#include "forecast/measured_costs.hpp"

namespace floes {

/// The processors that all threads share, first come, first served.
class Processors {
  public:
    /// count 0: every thread has one of its own.
    explicit Processors(int count);

    /// The end of `work` seconds that are ready to begin at `ready`. To be asked in order of time.
    double run(double ready, double work);

  private:
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at_;
};

class MasterClock {
  public:
    /// Both must outlive the clock. `begin`: when the first member can be handed out.
    MasterClock(const DriverCosts& costs, Processors& processors, double begin);

    /// Notices at `ready` or later that there is something to do; `asleep`: a message, which it has to look for.
    void notice(double ready, bool asleep);
    /// Works for so long.
    void work(double seconds);
    /// A record of so many bytes is in the journal.
    void keep(double bytes);
    /// Brings everything to the disk and publishes.
    void finish();

    double now() const { return now_; }    ///< when it is free
    double busy() const { return busy_; }  ///< of all this time, s

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

/// How long after it arrived a message is noticed by a rank that has had no news for `silence` seconds: such a rank
/// sleeps for about as long as it has waited already, at most for costs.longest_pause.
double notice_delay(const DriverCosts& costs, double silence);

}  // namespace floes
