#pragma once
// SIGINT, SIGTERM and SIGUSR1 as a request to stop. The first is remembered for who asks; a second one leaves at once
// with the exit status "stopped and resumable", which the journal makes true at any moment.

#include <csignal>

#include <array>

namespace floes {

/// Exit status of a run that was stopped on request and can be resumed.
inline constexpr int exit_stopped = 85;

inline constexpr std::array stop_signals{SIGINT, SIGTERM, SIGUSR1};

/// Catches the signals as long as it lives; one at a time in a process.
class StopSignals {
  public:
    StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals();

    /// The signal that came first; 0 when none came.
    int received() const;

  private:
    std::array<struct sigaction, stop_signals.size()> former_{};
};

/// As long as it lives the first of these signals ends the process with exit_stopped: for work that leaves nothing to
/// publish. One at a time in a process, and not beside StopSignals.
class LeaveOnSignals {
  public:
    LeaveOnSignals();
    LeaveOnSignals(const LeaveOnSignals&) = delete;
    LeaveOnSignals& operator=(const LeaveOnSignals&) = delete;
    ~LeaveOnSignals();

  private:
    std::array<struct sigaction, stop_signals.size()> former_{};
};

/// "SIGTERM" and so on.
const char* signal_name(int signal);

}  // namespace floes
