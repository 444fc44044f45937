#pragma once
// The time left in the batch job: queried once, counted down on a monotonic clock.

#include <chrono>
#include <optional>
#include <string_view>

namespace floes {

/// Seconds from the output of `squeue -o %L`: [days-][[hours:]minutes:]seconds. Empty for words such as UNLIMITED.
std::optional<double> parse_time_left(std::string_view text);

/// `asked` seconds if positive, otherwise the time left according to Slurm inside a job, otherwise empty.
std::optional<double> find_time_left(double asked);

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
