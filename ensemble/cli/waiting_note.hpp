#pragma once
// A word to whoever waits.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <stop_token>
#include <string>
#include <thread>

namespace floes {

/// Says on `out` what the program is doing, once, if this still lives after `patience`.
class WaitingNote {
  public:
    WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience = std::chrono::seconds(2));

  private:
    std::mutex mutex_;
    std::condition_variable_any over_;
    std::jthread waiting_;  // the last: it ends before what it uses
};

}  // namespace floes
