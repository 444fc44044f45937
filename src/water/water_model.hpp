#pragma once
// The force of the water on one element, as a pure function of its state: buoyancy, form drag, skin drag, heave drag.
//
// Buoyancy. At the 2 x 2 Gauss points of the element's base, (±L/√12, ±L/√12), there is a column along the element's
// normal. Each gives ρ_w g (L²/4) x (its submerged length), upward, at the middle of its submerged part. As long as
// neither face crosses the surface, force and moment are exact at any tilt: the Gauss points integrate ξ² exactly, so
// the metacentric term ρ_w g L⁴/12 is complete. Fully submerged or dry elements are exact as well.
//
// Drag, relative to the water velocity u (flow.hpp, at the point concerned; the structure's circle moves):
//   form  an edge face without a live joint whose outward normal n meets the flow (u_rel · n < 0):
//         F = -½ ρ_w C_d (L x wetted depth) (u_rel · n)² n, pushing inward, at the middle of the wetted depth
//   skin  on the lower face at the wet Gauss points:  F = ½ ρ_w C_s (L²/4) |u_t| u_t,  u_t = tangential part of u_rel
//   heave along the normal at the wet Gauss points, with w = u_rel · normal:
//         F = [½ ρ_w C_h (L²/4) |w| w + (c/4) w] normal,  c = 2 ζ sqrt(ρ_w g L² m): a fraction ζ of critical damping of
//         the element's heave; spread over the Gauss points it damps roll and pitch too.

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "water/column.hpp"
#include "water/water_kernels.hpp"

namespace floes {

class WaterModel {
  public:
    /// `gravity` m/s², `mass` of one element kg, `waterline_radius` of the structure m, `speed` of its tow m/s.
    WaterModel(const Water& water, double gravity, ElementShape shape, double mass, double waterline_radius,
               double speed);

    /// Force (N) and moment about the centre of mass (N m), world axes, with the structure's axis at x = `structure_x`.
    Wrench wrench(const ElementState& state, double structure_x) const;

    /// The parts of wrench(): hydrostatic, and all drag.
    Wrench buoyancy(const ElementState& state) const;
    Wrench drag(const ElementState& state, double structure_x) const;

    /// Water velocity (x, z) at a place (x, z), m/s; zero for WaterFlow::still.
    Vec2 flow_velocity(const Vec2& place, double structure_x) const;

    /// Depth of the lower face of an element of this mass at rest: m / (ρ_w L²), m.
    double floating_draught() const;

    /// The constants for computing many elements at once (water_lanes.hpp).
    WaterFactors factors() const;

  private:
    struct Columns;
    Columns gauss_columns(const ElementState& state) const;
    Wrench buoyancy(const Columns& columns) const;
    Wrench drag(const ElementState& state, const Columns& columns, double structure_x) const;
    Wrench form_drag(const ElementState& state, double structure_x) const;
    Vec3 relative_velocity(const ElementState& state, const Vec3& arm, double structure_x) const;

    Water water_;
    double gravity_;
    ElementShape shape_;
    double mass_;
    double waterline_radius_;
    double speed_;
    double gauss_offset_;    ///< L / √12, m
    double gauss_area_;      ///< L² / 4, m²
    double linear_damping_;  ///< c / 4, N s/m
};

}  // namespace floes
