#pragma once
// The width of standard output, and results as text for it.

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <ostream>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "tables/section.hpp"

namespace floes {

/// Characters on a line of standard output: of the terminal, otherwise the environment's COLUMNS, otherwise 100; at
/// least 40.
int terminal_width();

/// The sections in that format: "table", "json" or "csv".
std::string written(const std::vector<Section>& sections, const std::string& format, const Units& units = {});

// The progress of one long computation on standard error: a line that is updated on a terminal, elsewhere a new line
// every ten seconds.

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

// A note for a user who has to wait.

/// Prints on `out`, once, what the program is doing, if the object still exists after `patience`.
class WaitingNote {
  public:
    WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience = std::chrono::seconds(2));

  private:
    std::mutex mutex_;
    std::condition_variable_any over_;
    std::jthread waiting_;  // the last: it ends before what it uses
};

}  // namespace floes
