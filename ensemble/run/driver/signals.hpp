#pragma once
// SIGINT, SIGTERM, SIGHUP and SIGUSR1 as a request to stop. The first signal is stored to be queried. A second one ends
// the process immediately with the exit status "stopped and resumable", which the journal makes true at any moment.

#include <csignal>

#include <array>

namespace floes {

/// Exit status of a run that was stopped on request and can be resumed.
inline constexpr int exit_stopped = 85;

inline constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP, SIGUSR1};

/// Catches the signals during its lifetime; at most one in a process.
class StopSignals {
  public:
    StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals();

    /// The first signal; 0 if none was received.
    int received() const;

  private:
    std::array<struct sigaction, stop_signals.size()> former_{};
};

/// During its lifetime the first of these signals ends the process with exit_stopped: for work that leaves nothing to
/// publish. At most one in a process, and not together with StopSignals.
class LeaveOnSignals {
  public:
    LeaveOnSignals();
    LeaveOnSignals(const LeaveOnSignals&) = delete;
    LeaveOnSignals& operator=(const LeaveOnSignals&) = delete;
    ~LeaveOnSignals();

  private:
    std::array<struct sigaction, stop_signals.size()> former_{};
};

/// Nobody may be left to read what a run prints, as behind `| head` or after a lost connection. It goes on then: from
/// now on such a write fails, and ends nothing.
void outlive_readers();

/// "SIGTERM" and so on.
const char* signal_name(int signal);

}  // namespace floes
