#pragma once
// Whether the lists of all cases can be held, in memory and as the text of the campaign. For this room only.

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
    std::size_t poses_ = 0;          ///< of all cases
    std::uint64_t first_poses_ = 0;  ///< digest of those of the first
    bool differ_ = false;            ///< so they stand in the campaign's text case by case
    std::size_t cases_ = 0;
};

}  // namespace floes
