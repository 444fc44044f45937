#pragma once
// The force of the water on one element.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "shapes/elements.hpp"
#include "water/water_kernels.hpp"

namespace floes {

// One element as the water sees it, and its numbers in the arrays of the kernels.

/// How far other ice shelters an edge from the flow.
struct EdgeShelter {
    double open = 1;   ///< S_c; 1: no ice ahead
    double speed = 0;  ///< (1 - S_c) v_b · n of the ice ahead, m/s
};

/// Where an element is and how it moves. World axes, SI.
struct ElementState {
    Vec3 position = Vec3::Zero();          ///< of the centre of mass
    Mat3 rotation = Mat3::Identity();      ///< body -> world; the columns are the element's x, normal (y) and z
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass
    Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
    std::uint32_t exposed_edges = 0;       ///< edge faces with form drag: bit k for edge k, of a square +x, +z, -x, -z
    std::span<const EdgeShelter> shelter{};  ///< of edge k, where that is exposed; empty: of none
};

/// Size of an element: a square box of `side` x `thickness` x `side`, m.
struct ElementShape {
    double side = 0;
    double thickness = 0;
};

/// Fields of plan_field of an element; none for a square.
std::vector<double> plan_of(const CutElement& element);

/// Writes the fields of water_field, the first to `fields`, the next `stride` further on.
void put_fields(const ElementState& state, double* fields, std::size_t stride);

/// Likewise the shelter of its exposed edges, as WaterArrays has it.
void put_shelter(const ElementState& state, double* fields, std::size_t stride);

/// The wrench whose first field is at `fields`, the next `stride` further on.
Wrench wrench_at(const double* fields, std::size_t stride);

// The force of the water on one element, as a pure function of its state: buoyancy, form drag, skin drag, heave drag.
//
// For a square of side L and area L²; below, for other elements.
//
// Buoyancy. ρ_w g times the volume of the prism below the surface, at its centroid, exact at any attitude: the pyramids
// from a point in the surface to the wet parts of the faces, each of volume h A/3.
//
// Drag, relative to the velocity u of the water at the point concerned:
//   form  an edge face without a live joint whose outward normal n meets the flow (u_rel · n < 0):
//         F = -½ ρ_w C_d (its wet area) (u_rel · n)² n, pushing inward, at the centroid of that.
//         Ice ahead of the edge shelters it (below); C_d is of front and lee together, so the lee has no force
// The rest acts on the face that looks down, at the 2 x 2 Gauss points of its area, (±L/√12, ±L/√12); A_w is a quarter
// of the wet area of that face.
//   skin  F = ½ ρ_w C_s A_w |u_t| u_t,  u_t = tangential part of u_rel
//   heave along the normal, with w = u_rel · normal:
//         F = [½ ρ_w C_h A_w |w| w + (c/4) w] normal. The second term stands for waves. Of water.heave_damping_from
//         = "share":   c = 2 ζ sqrt(ρ_w g L² m (1 + a)), a fraction ζ of critical damping of the heave of an element
//                      of mass m that carries the share a of added mass, at points whose column along the normal
//                      is wet
//         "outline":   c is the element's share of what its piece radiates (floating_plate.hpp), at points whose column
//                      cuts the surface: ice that is covered by water makes no waves
//         Spread over the Gauss points it damps roll and pitch too.
//
// Shelter. In the lee of ice the flow is the share S_c of what it is elsewhere (Hanssen-Bauer and Gjessing, Tellus 40A,
// 1988; Steele, Morison and Untersteiner, J. Geophys. Res. 94, 1989; here as Tsamados et al., J. Phys. Oceanogr. 44,
// 2014, have it: form drag goes with S_c², S_c = (1 - exp(-s D/H))^½, s = 0.18). D is the gap between the edge and the
// ice ahead of it, H the draught of the edge, 1/s = water.shelter_draughts. They have ice that moves as one. Here the
// water in the lee moves with the ice that shelters it, of velocity v_b, so that ice which comes near other ice at rest
// in still water meets that water still: u_rel · n is that of S_c u + (1 - S_c) v_b, u the water's velocity.
// Which ice is ahead: simulation/lee.hpp.
//
// Flow. Horizontal potential flow round the structure's waterline circle of radius R, which moves at the speed V along
// +x through water at rest: from the potential -V R² cosθ / r follow  u_r = V R² cosθ / r²,  u_θ = V R² sinθ / r²  for
// r >= R (no flow through the circle, no vorticity). Inside the circle, the value at r = R in the same direction; at
// the centre (V, 0). With WaterFlow::still u = 0. A current c makes it c and the flow of a circle that moves at V - c.
//
// Hulls of other shapes: the flow round ellipses of half length a and half breadth b, each as if alone (Lamb,
// Hydrodynamics, article 71, cited from memory):  u - i w = (a + b)(b V_x + i a V_z) / (s (s + ζ)),  ζ = x + i z from
// the middle, s² = ζ² - a² + b². For a = b it is the circle's. Ellipses that are neighbours neglect each other, an
// error of the order of their size over their distance squared.
//
// Below the ice the boundary layer turns skin drag by θ, anticlockwise from above (Leppäranta, The Drift of Sea Ice,
// 2011, chapter 5: τ = ρ C |U| (cosθ U + sinθ k × U), U the water's velocity relative to the ice).
//
// An element of any other convex plan, of area A, has its four points at (±√(xx/A), ±√(zz/A)) in its principal axes;
// alone it has the damping of the square of its area.
//
// Wind. Where a column's top is above the water, ρ_a C_a U² (L²/4) along the wind at the top.

/// Where the structure is across the channel, and how it moves through the water.
struct StructureInWater {
    double z = 0;                  ///< of its axis, m
    double yaw = 0;                ///< about +y, rad
    Vec2 velocity = Vec2::Zero();  ///< along x and z, m/s
};

/// `flows`: whether the water flows round the structure.
void follow_structure(WaterFactors& factors, bool flows, const StructureInWater& structure);

class WaterModel {
  public:
    /// `gravity` m/s², `mass` of one element without added mass kg, `waterline_radius` of the structure m, `speed` of
    /// its tow m/s, `wind_stress` along x and z Pa.
    WaterModel(const Water& water, double gravity, ElementShape shape, double mass, double waterline_radius,
               double speed, const Vec2& wind_stress = Vec2::Zero())
        : WaterModel(water, gravity, shape.side, shape, mass, waterline_radius, speed, wind_stress) {}

    /// For an element of any plan and this thickness, m.
    WaterModel(const Water& water, double gravity, const CutElement& element, double thickness, double mass,
               double waterline_radius, double speed, const Vec2& wind_stress = Vec2::Zero());

    /// From now on the water flows round these ellipses, at most most_flow_ellipses, in place of the circle.
    void flow_round(std::span<const FlowEllipse> ellipses);

    /// c of an element alone, kg/s.
    double damping() const { return damping_; }

    /// With damping c as given, or that of an element alone: force (N) and moment about the centre of mass (N m), world
    /// axes, with the structure's axis at x = `structure_x`. For many elements water_lanes.hpp gives the same bits
    /// sooner.
    Wrench wrench(const ElementState& state, double structure_x) const { return wrench(state, structure_x, damping_); }
    Wrench wrench(const ElementState& state, double structure_x, double damping) const;

    const WaterFactors& factors() const { return factors_; }

    /// Whether the water flows round the structure.
    bool flows() const { return flows_; }

    /// Fields of plan_field; none of a square.
    const std::vector<double>& plan() const { return plan_; }

  private:
    WaterModel(const Water& water, double gravity, double plan_side, ElementShape shape, double mass,
               double waterline_radius, double speed, const Vec2& wind_stress);

    WaterFactors factors_;
    std::vector<double> plan_;
    bool flows_;
    double damping_;
};

}  // namespace floes
