#pragma once
// Elements as in the paper, for the tests of the world.

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/convex_solid.hpp"
#include "world/world.hpp"

namespace floes::test {

inline constexpr double element_side = 0.2;
inline constexpr double element_thickness = 0.033;
inline constexpr double element_mass = 930.0 * element_side * element_side * element_thickness;

inline WorldDefinition weightless() {
    return {.gravity = 0};
}

/// With what the solver asks of contacts.
inline WorldDefinition solved_by(SolverKind solver, int lanes = 0) {
    WorldDefinition definition{.solver = solver, .lanes = lanes};
    if (solver == SolverKind::direct) {
        definition.contact.friction = Friction::cone;
        definition.contact.split_impulse = false;
    }
    return definition;
}

inline WorldDefinition weightless(SolverKind solver) {
    WorldDefinition definition = solved_by(solver);
    definition.gravity = 0;
    return definition;
}

/// Of a body that lies where it is.
inline BodyState set_moving(World& world, BodyId body, const Vec3& velocity, const Vec3& turning = Vec3::Zero()) {
    BodyState state = world.state(body);
    state.velocity = velocity;
    state.angular_velocity = turning;
    world.place(body, state);
    return state;
}

inline ElementDefinition element_at(const Vec3& position, const Quat& orientation = Quat::Identity(),
                                    int piece = no_piece) {
    ElementDefinition box;
    box.corners = corners_of(element_side / 2, element_side / 2);
    box.half_thickness = element_thickness / 2;
    box.mass = element_mass;
    box.pose = {position, orientation};
    box.piece = piece;
    return box;
}

inline Quat turned(double angle, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

inline ElementDefinition hexagon_at(const Vec3& position, double yaw = 0) {
    ElementDefinition prism;
    for (int k = 0; k < 6; ++k) {
        const double angle = (k + 0.5) * std::numbers::pi / 3;
        prism.corners.push_back({0.12 * std::cos(angle), 0.12 * std::sin(angle)});
    }
    prism.half_thickness = element_thickness / 2;
    prism.mass = 1.2;
    prism.pose = {position, turned(yaw, Vec3::UnitY())};
    return prism;
}

/// A block between two corners.
inline Polyhedron block(const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                             (k & 4) != 0 ? high.z() : low.z());
    return convex_hull(corners);
}

inline bool same_bits(const BodyState& a, const BodyState& b) {
    return a.position == b.position && a.rotation == b.rotation && a.velocity == b.velocity &&
           a.angular_velocity == b.angular_velocity;
}

}  // namespace floes::test
