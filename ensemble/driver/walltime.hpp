#pragma once
// The time that the batch system leaves: asked for once, counted down on a monotonic clock.

#include <chrono>
#include <optional>
#include <string_view>

namespace floes {

/// Seconds in what `squeue -o %L` prints: [days-][[hours:]minutes:]seconds. Nothing for words such as UNLIMITED.
std::optional<double> parse_time_left(std::string_view text);

/// `asked` seconds when that is positive, else what Slurm says inside a job, else nothing.
std::optional<double> find_time_left(double asked);

class Walltime {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `seconds_left` from `now` on; nothing: for ever. Of that a tenth, at most a minute, is kept for publishing.
    explicit Walltime(std::optional<double> seconds_left = {}, Time now = std::chrono::steady_clock::now());

    /// Seconds for computing; not positive when it is time to stop; nothing when there is no end.
    std::optional<double> left(Time now) const;

  private:
    std::optional<Time> end_;
};

}  // namespace floes
