#pragma once
// Signals as a request to stop: those of users, and those that batch systems send before a limit. The first is stored
// to be queried. A second one ends the process immediately with the exit status "stopped and resumable", which the
// journal makes true at any moment.

#include <array>
#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>

#include "core/started_program.hpp"

namespace floes {

/// Exit status of a run that was stopped on request and can be resumed.
inline constexpr int exit_stopped = 85;

/// SIGXCPU is the soft limit of processor time (ulimit -S -t, s_cpu of Grid Engine), SIGUSR2 the notice of LSF and Grid
/// Engine, SIGALRM that of a timer which the starting program has set.
inline constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGQUIT, SIGALRM};

/// Whether whoever started this process wants it to outlive the signal, as nohup (SIGHUP) and our array scripts
/// (SIGUSR2) do: SIGHUP or SIGUSR2 that is ignored. Shells ignore SIGINT and SIGQUIT for all that runs in the
/// background.
bool is_to_be_outlived(int signal);

/// Catches the signals during its lifetime. Of several in a process, those within another one see what that received
/// before them; only those may be of other threads.
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
std::string signal_name(int signal);

// The time left in the batch job: queried once, counted down on a monotonic clock.

/// Seconds from the output of `squeue -o %L`: [days-][[hours:]minutes:]seconds. Empty for words such as UNLIMITED.
std::optional<double> parse_time_left(std::string_view text);

struct JobTimeLeft {
    std::optional<double> seconds;  ///< none: no limit that is known
    std::string remark;             ///< a sentence where Slurm does not say what is left of its job; otherwise empty
};

/// `asked` seconds if positive, otherwise the time left according to Slurm inside a job, if it says so in time.
JobTimeLeft find_time_left(double asked, Seconds longest_wait = Seconds(30));

class Walltime {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `seconds_left` from `now` on; empty: no limit. A tenth of it, at most a minute, is reserved for publishing.
    explicit Walltime(std::optional<double> seconds_left = {}, Time now = std::chrono::steady_clock::now());

    /// Seconds left for computing; not positive when it is time to stop; empty if there is no limit.
    std::optional<double> left(Time now) const;

  private:
    std::optional<Time> end_;
};

}  // namespace floes
