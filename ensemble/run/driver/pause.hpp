#pragma once
// How long the thread that waits for messages sleeps between two polls: briefly after an event, then longer and longer.
// A rank that waits for another's last member must not take a core from it.

#include <algorithm>
#include <chrono>

namespace floes {

class Pause {
  public:
    /// `longest`: how late a message may be noticed.
    explicit Pause(std::chrono::microseconds longest) : longest_(longest) {}

    void something_happened() { next_ = shortest; }

    /// How long to sleep now.
    std::chrono::microseconds next() {
        const auto now = std::min(next_, longest_);
        next_ = std::min(next_ * 2, longest_);
        return now;
    }

  private:
    static constexpr std::chrono::microseconds shortest{50};
    std::chrono::microseconds longest_;
    std::chrono::microseconds next_ = shortest;
};

/// With several ranks a message is noticed within 10 ms, which is short compared with the work queued for the cores. A
/// poll costs some 40 us; polling five times as often took 2 % of a core. A single rank polls only for signals and
/// timers, because an outcome wakes the sleeper.
inline Pause pause_between_polls(int ranks) {
    return Pause(ranks > 1 ? std::chrono::milliseconds(10) : std::chrono::milliseconds(50));
}

}  // namespace floes
