#pragma once
// A line through an element along its own normal, and the part of it that is under water.

#include <cstdint>

#include "core/vector.hpp"

namespace floes {

/// Where an element is and how it moves. World axes, SI.
struct ElementState {
    Vec3 position = Vec3::Zero();          ///< of the centre of mass
    Mat3 rotation = Mat3::Identity();      ///< body -> world; the columns are the element's x, normal (y) and z
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass
    Vec3 angular_velocity = Vec3::Zero();  ///< angular velocity
    std::uint8_t exposed_edges = 0;        ///< edge faces with form drag: bit 0 +x, 1 -x, 2 +z, 3 -z

    Vec3 normal() const { return rotation.col(1); }
    /// Velocity of the element's material at `arm` (m from the centre of mass, world axes).
    Vec3 velocity_at(const Vec3& arm) const { return velocity + angular_velocity.cross(arm); }
};

/// Size of an element: a square box of `side` x `thickness` x `side`, m.
struct ElementShape {
    double side = 0;
    double thickness = 0;
};

/// The submerged part of a column from the bottom face to the top face.
struct SubmergedColumn {
    double length = 0;        ///< m along the normal; 0 when dry
    Vec3 arm = Vec3::Zero();  ///< from the centre of mass to the middle of the submerged part, world axes, m
};

/// The column through body point (x, 0, z) of an element; the water surface is y = 0. Exact for any tilt, upside down
/// too.
SubmergedColumn submerged_column(const ElementState& state, double x, double z, double thickness);

}  // namespace floes
