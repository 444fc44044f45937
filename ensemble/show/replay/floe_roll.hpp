#pragma once
// The floes of a field without end that the frames of a record show. A run keeps them in places, where others follow
// those that have left; a record gives each floe that it ever shows elements and joints of its own, floe by floe in the
// order in which they entered, and a frame says which of them are there.

#include <cstddef>
#include <vector>

#include "ice/failure_mode.hpp"
#include "scenario/floes.hpp"
#include "simulation/frame.hpp"
#include "simulation/simulation.hpp"

namespace floes {

class FloeRoll {
  public:
    /// Brings a frame of the run's present into the numbers of the record: floes that are not there any more leave it,
    /// new ones join the roll. Frames come in order of time.
    void enter(const Simulation& run, Frame& frame);

    /// All so far.
    FloeSet floes() const { return gathered(floes_); }
    const std::vector<int>& numbers() const { return numbers_; }  ///< of each: the how-manieth to enter, from 0

    /// Those of the breaks of the run that are of these floes, in the numbers of the record.
    std::vector<BreakEvent> breaks(const std::vector<BreakEvent>& of_run) const;

  private:
    std::size_t index_of(int number) const;

    std::vector<int> numbers_;  // rising
    std::vector<SingleFloe> floes_;
    std::vector<int> first_element_;
    int elements_ = 0;
};

}  // namespace floes
