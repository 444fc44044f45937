#pragma once
// What a hull displaces and cuts out of the water, from its convex solids, at any heel and trim.

#include "core/vector.hpp"
#include "shapes/convex_solid.hpp"
#include "shapes/shape.hpp"

namespace floes {

/// In the hull's own axes (x ahead, y up from its waterline, z to starboard), SI. Where its solids overlap it counts
/// twice.
struct Hydrostatics {
    double volume = 0;              ///< ∇, displaced, m³
    Vec3 buoyancy = Vec3::Zero();   ///< B, the centroid of ∇, m
    double waterplane = 0;          ///< A_w, m²
    Vec3 flotation = Vec3::Zero();  ///< F, the centroid of A_w, m
    double about_length = 0;        ///< I_T, second moment of A_w about the axis through F along the hull, m⁴
    double about_breadth = 0;       ///< I_L, about the axis in A_w at right angles to it, m⁴
    double product = 0;             ///< of A_w about these axes, ∫ of along times across (+z upright), m⁴

    double metacentric_radius() const { return about_length / volume; }                ///< B to M in roll, m
    double longitudinal_metacentric_radius() const { return about_breadth / volume; }  ///< in pitch, m
};

/// `water`: its surface in the hull's axes, the normal upwards and not along x; the level waterline by default. Exact
/// for flat faces; round walls are polygons of the same area at each height, so that ∇ is exact upright. Throws
/// InputError with the fault of a shape that has one.
Hydrostatics hydrostatics(const Shape& shape, const Plane& water = {});

/// What water and weight do against small motions of an upright hull about its axis at the waterline, N, m and rad, in
/// the order of Motion (shapes/moorings.hpp): ρg of the waterplane's moments, and with turns the couple of buoyancy and
/// weight, ρg∇ y_B - mg y_G. `mass`: m, kg; `height`: y_G, m. The hull lies level at rest.
Mat6 water_stiffness(const Hydrostatics& at_rest, double density, double gravity, double mass, double height);

}  // namespace floes
