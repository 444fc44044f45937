#pragma once
// Floes without water or gravity, loaded by hand, for the tests of the ice.

#include <cmath>
#include <vector>

#include "ice/ice_field.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes::test {

/// A scenario whose floes are of `elements_long` x `elements_broad` elements, otherwise the paper's.
inline Scenario scenario_of(int elements_long, int elements_broad) {
    Scenario scenario = sweeping_scenario();
    scenario.floe.length = elements_long * scenario.floe.element;
    scenario.floe.breadth = elements_broad * scenario.floe.element;
    return scenario;
}

inline World weightless_world() {
    return World({.gravity = 0});
}

inline double element_mass(const Scenario& scenario) {
    return scenario.ice.density * scenario.floe.thickness * scenario.floe.element * scenario.floe.element;
}

/// Loads a joint between `a` and its neighbour `b`, `arm` being the joint seen from a in a's own axes: such that, at
/// rest, the joint exerts `force` and `moment` (in a's axes) on a.
inline void load_joint(World& world, BodyId a, BodyId b, const Vec3& arm, const Vec3& force, const Vec3& moment) {
    const BodyState state_a = world.state(a);
    const BodyState state_b = world.state(b);
    const Vec3 f = state_a.rotation * force;
    const Vec3 m = state_a.rotation * moment;
    world.apply(a, {-f, -m - (state_a.rotation * arm).cross(f)});
    world.apply(b, {f, m - (state_b.rotation * arm).cross(f)});
}

}  // namespace floes::test
