#pragma once
// Which floes of a field without end are computed: those round the structure. Floes farther ahead rest, fixed to
// whatever touches them, as ice that is held from ahead; floes farther behind are taken out of the world. The window
// moves with the structure in strides of a quarter of a floe, and the field is laid part after part as it comes there.
// It never moves back with a structure that swings on its moorings: what has left is gone, and ice that rests anew
// would have to be ice that never moved. Nothing here depends on how long the run will be.

#include <vector>

#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

class MovingWindow {
  public:
    /// floes: those laid already; ahead: where others come from.
    MovingWindow(const Scenario& scenario, const FloeSet& floes, IceAhead ahead);

    /// Moves with the structure's axis, now at x = `structure_x` m. Whether it has come a stride farther than ever.
    bool moves_to(double structure_x);

    /// Whether a structure with its axis there may touch ice that is gone.
    bool has_left(double structure_x) const { return structure_x - least_ < first(); }

    double first() const { return at_ - behind_; }  ///< x of its edge behind, m
    double last() const { return at_ + ahead_; }    ///< x of its edge ahead, m

    /// The next part of the field, if what is laid does not reach far enough beyond the edge ahead; empty otherwise.
    std::vector<SingleFloe> next_part();

    /// What lies at each place of the ice (IceField::enter).
    std::vector<SingleFloe>& places() { return places_; }
    const std::vector<SingleFloe>& places() const { return places_; }

  private:
    double ahead_, behind_;  // m
    double stride_;          // m
    double least_;           // m from the structure's axis to the edge behind, at least
    double reserve_;         // m of ice at rest ahead of the window, at least
    double at_;              // largest x of the structure's axis so far, in whole strides, m
    IceAhead ice_;
    std::vector<SingleFloe> places_;
};

}  // namespace floes
