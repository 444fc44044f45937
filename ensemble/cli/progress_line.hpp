#pragma once
// The progress of one long computation on standard error: a line that is updated on a terminal, elsewhere a new line
// every ten seconds.

#include <chrono>
#include <cstdio>
#include <string>

namespace floes {

class ProgressLine {
  public:
    /// what: "computing member 3".
    explicit ProgressLine(std::string what);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();  // ends the live line

    /// done: share, 0-1. Says "computing member 3: 47 %, 14 s left" if that is due.
    void show(double done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool live_;
    bool open_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = Clock::now();
};

}  // namespace floes
