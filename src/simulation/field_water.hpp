#pragma once
// The models of the water of all elements, and which element has which.

#include <vector>

#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "water/floating_plate.hpp"
#include "water/water_lanes.hpp"
#include "world/world.hpp"

namespace floes {

/// One model for all squares of the same size and density, and one for each polygon. floes: those at the places of the
/// ice.
WaterLanes make_water(const Scenario& scenario, const FloeSet& floes, const IceField& ice);

// The water that connected pieces of ice move and the waves they make, shared out among their elements: anew whenever
// a floe has broken.

class PieceWater {
  public:
    /// floes: those at the places of the ice.
    PieceWater(const Scenario& scenario, const FloeSet& floes, const IceField& ice);

    /// Gives the elements of all floes what their pieces have, as far as water.added_mass_from and
    /// water.heave_damping_from say "outline"; or those of one floe, which is not part of a sheet.
    void share_out(const IceField& ice, World& world, WaterLanes& water);
    void share_out(int floe, const IceField& ice, World& world, WaterLanes& water);

    /// What an element carries, by its place in ice.elements().
    const CarriedWater& carried(std::size_t element) const { return carried_[element]; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    void share_out_listed(const IceField& ice, World& world, WaterLanes& water);

    WaterBody body_;
    bool carries_;
    bool radiates_;
    std::vector<double> draught_;              ///< by floe, m
    std::vector<CarriedWater> carried_;        ///< by element
    std::vector<int> piece_order_;             ///< elements of one floe or sheet, piece after piece
    std::vector<Vec2> centres_;                ///< of one piece
    std::vector<const CutElement*> polygons_;  ///< likewise, of polygons
    std::vector<CutElement> of_sheet_;         ///< likewise, of those of a sheet
};

}  // namespace floes
