#pragma once
// The water that a flat piece of ice moves when it heaves, rolls and pitches, and the waves it makes.
//
// A thin rectangular plate afloat on deep water, each motion at the plate's own natural frequency: from a table that
// docs/figures/floating_plate.py computes (docs/water.md has the derivation and the limits). The added mass is laid
// over the piece so that heave, roll and pitch have theirs: along each side by the weight
// 1 - t + t (15/8) (1 - s²)², s from -1 to 1, whose second moment t sets.

#include <span>
#include <vector>

#include "core/vector.hpp"
#include "shapes/elements.hpp"
#include "solver/carried_water.hpp"

namespace floes {

/// The water of a plate b by l, b <= l, in its own numbers.
struct PlateWater {
    double added_mass = 0;       ///< of heave, over ρ b² l
    double gyration_across = 0;  ///< squared radius of gyration of it in turning along b, over b²
    double gyration_along = 0;   ///< likewise along l, over l²
    double damping = 0;          ///< of heave, over the added mass and √(g/b)
};

/// aspect: l/b, at least 1; draught: over b, at least 0. Between the entries of the table linear in log(aspect) and in
/// the draught; beyond its ends the last entry: l/b 8, draught 0.5 b.
PlateWater plate_water(double aspect, double draught);

/// What water there is.
struct WaterBody {
    double density = 0;   ///< kg/m³
    double gravity = 0;   ///< m/s²
    double in_plane = 0;  ///< added mass along the surface and in yaw, as a share of the ice's
};

/// The share of one element of a piece.
struct ElementWater {
    CarriedWater carried;
    double damping = 0;  ///< kg/s: force over the speed along the normal, of an element that cuts the surface
};

/// How what a plate carries lies over a piece: by the weight above along each side.
struct PlateLoad {
    Vec2 middle = Vec2::Zero();  ///< of the outline, m
    Vec2 half = Vec2::Zero();    ///< half its sides, m
    double tx = 0;               ///< t of the weight along x
    double tz = 0;
    double mass = 0;     ///< added mass of the piece, kg
    double damping = 0;  ///< over the added mass, 1/s
};

/// For a piece with an outline of these sides, m, about this point, and of this area, m².
PlateLoad plate_load(const Vec2& middle, const Vec2& size, double area, double draught, const WaterBody& water);

/// For each element of a connected piece, given the elements' centres (x and z in the axes of the floe, m), their side
/// and draught (m). A piece that does not fill its outline counts as a rectangle of the outline's proportions and its
/// own area. At least one element.
std::vector<ElementWater> water_of_piece(std::span<const Vec2> centres, double side, double draught,
                                         const WaterBody& water);

/// The same of elements that are polygons, `elements` in the axes of the floe; each carries its water in its own axes.
std::vector<ElementWater> water_of_piece(std::span<const CutElement* const> elements, double draught,
                                         const WaterBody& water);

}  // namespace floes
