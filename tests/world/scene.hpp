#pragma once
// Elements as in the paper, for the tests of the world.

#include <cmath>

#include "world/world.hpp"

namespace floes::test {

inline constexpr double element_side = 0.2;
inline constexpr double element_thickness = 0.033;
inline constexpr double element_mass = 930.0 * element_side * element_side * element_thickness;

inline WorldDefinition weightless() {
    WorldDefinition definition;
    definition.gravity = 0;
    return definition;
}

inline BoxDefinition element_at(const Vec3& position, const Quat& orientation = Quat::Identity(),
                                int piece = no_piece) {
    BoxDefinition box;
    box.half_extents = Vec3(element_side, element_thickness, element_side) / 2;
    box.mass = element_mass;
    box.pose = {position, orientation};
    box.piece = piece;
    return box;
}

inline Quat turned(double angle, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

inline bool same_bits(const BodyState& a, const BodyState& b) {
    return a.position == b.position && a.rotation == b.rotation && a.velocity == b.velocity &&
           a.angular_velocity == b.angular_velocity;
}

}  // namespace floes::test
