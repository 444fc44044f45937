#pragma once
// The water on an element that is a convex polygon: the terms of water_model.hpp, one element at a time.
//
// The four columns stand at (±√(xx/A), ±√(zz/A)) in the principal axes of the polygon, each for a quarter of its area
// A. So buoyancy and the moment that rights it are exact at any tilt as long as neither face crosses the surface, as
// they are for a square. Form drag acts in the middle of each exposed edge.

#include "shapes/elements.hpp"
#include "water/water_kernels.hpp"
#include "water/water_model.hpp"

namespace floes {

class PolygonWater {
  public:
    /// For an element of this thickness, m, and mass, kg; the rest as WaterModel takes it.
    PolygonWater(const Water& water, double gravity, const CutElement& element, double thickness, double mass,
                 double waterline_radius, double speed, const Vec2& wind_stress);

    /// c of an element alone, kg/s: that of the square of its area.
    double damping() const { return damping_; }

    /// Force (N) and moment about the centre of mass (N m), world axes; damping c in kg/s. Factors may be those of
    /// factors() with terms left out.
    Wrench wrench(const ElementState& state, const WaterFactors& factors, double damping, double structure_x) const;

    /// Half lengths and areas are those of the polygon; gauss_offset and half_side are not used.
    const WaterFactors& factors() const { return factors_; }

    /// As WaterLanes::move_structure().
    void move_structure(const StructureInWater& structure) { follow_structure(factors_, flows_, structure); }

  private:
    WaterFactors factors_;
    bool flows_ = false;
    Outline corners_;
    double gauss_x_, gauss_z_;
    double damping_;
};

}  // namespace floes
