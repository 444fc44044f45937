#pragma once
// Whether the lists of all cases can be held in memory. For this room only.

#include <cstddef>
#include <string>

#include "scenario/scenario.hpp"

namespace floes {

class HeldNumbers {
  public:
    /// `file` begins the messages.
    explicit HeldNumbers(std::string file) : file_(std::move(file)) {}

    /// Counts the poses, profile points, levels and times of one more case. Throws InputError when those of all cases
    /// are too many.
    void add(const Scenario& scenario);

  private:
    std::string file_;
    std::size_t numbers_ = 0;
};

}  // namespace floes
