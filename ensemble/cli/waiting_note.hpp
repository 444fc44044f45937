#pragma once
// A note for a user who has to wait.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <stop_token>
#include <string>
#include <thread>

namespace floes {

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
