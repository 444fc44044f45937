#include "cli/waiting_note.hpp"

#include <utility>

namespace floes {

WaitingNote::WaitingNote(std::ostream& out, std::string doing, std::chrono::milliseconds patience)
    : waiting_([this, &out, doing = std::move(doing), patience](const std::stop_token& stop) {
          std::unique_lock lock(mutex_);
          over_.wait_for(lock, stop, patience, [] { return false; });
          if (!stop.stop_requested()) out << "floes: " + doing + "\n" << std::flush;
      }) {}

}  // namespace floes
