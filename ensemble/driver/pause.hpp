#pragma once
// How long the thread that waits for messages sleeps between two looks: short after something happened, then longer and
// longer. A rank that waits for the last member of another must not take its core.

#include <algorithm>
#include <chrono>

namespace floes {

class Pause {
  public:
    /// `longest`: how late a message may be noticed.
    explicit Pause(std::chrono::microseconds longest) : longest_(longest) {}

    void something_happened() { next_ = shortest; }

    /// The time to sleep now.
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

/// For a rank among others a message is noticed within 10 ms, a small part of the time that its cores have work for: a
/// look costs some 40 us, five times as often was 2 % of a core. Alone, only signals and timers are to be noticed,
/// since an outcome wakes the sleeper.
inline Pause pause_between_polls(int ranks) {
    return Pause(ranks > 1 ? std::chrono::milliseconds(10) : std::chrono::milliseconds(50));
}

}  // namespace floes
