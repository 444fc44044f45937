#pragma once
// Twelve elements that drift together and collide, at all angles: the laws of contact may only take energy.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene.hpp"

namespace floes::test {

inline double kinetic_energy(const BodyState& state) {
    const double a = element_side * element_side;
    const double b = element_thickness * element_thickness;
    const Vec3 inertia = element_mass / 12 * Vec3(a + b, 2 * a, a + b);
    const Vec3 angular_velocity = state.rotation.transpose() * state.angular_velocity;
    return 0.5 *
           (element_mass * state.velocity.squaredNorm() + inertia.dot(angular_velocity.cwiseProduct(angular_velocity)));
}

inline void expect_a_collision_that_never_gains_energy(const WorldDefinition& definition, double duration) {
    World world(definition);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 12; ++i) {
        const Vec3 at(0.23 * (i % 4 - 1.5), 0.004 * (i % 3), 0.23 * (i / 4 - 1));
        bodies.push_back(world.add_element(element_at(at, turned(0.1 * i, Vec3::UnitY()))));
        const Vec3 velocity = -0.8 * at + 0.1 * Vec3(std::sin(i), 0.2 * std::cos(3 * i), std::cos(2 * i));
        set_moving(world, bodies.back(), velocity, 0.5 * Vec3(0, std::sin(5 * i), 0));
    }
    const auto energy = [&] {
        double sum = 0;
        for (const BodyId body : bodies) sum += kinetic_energy(world.state(body));
        return sum;
    };
    const double first = energy();
    double last = first;
    for (double time = 0; time < duration; time += definition.time_step) {
        world.step();
        const double now = energy();
        EXPECT_LE(now, last * (1 + 1e-9)) << time;
        last = now;
    }
    EXPECT_LT(last, 0.7 * first) << "they must have collided";
}

}  // namespace floes::test
