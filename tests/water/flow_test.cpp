#include "water/water_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace flow_test {

constexpr double radius = 0.614;
constexpr double speed = 0.07;

/// Velocity (x, z) of the water at a place (x, z) from the structure's axis, seen by a speck of ice with linear damping
/// of 1 N s/m alone: a force along its normal with the number of the velocity.
Vec2 potential_flow(const Vec2& from_axis) {
    constexpr double side = 0x1p-60;
    constexpr double structure_x = 0.25;
    const Water water{.density = 1,
                      .form_drag = 0,
                      .skin_drag = 0,
                      .heave_drag = 0,
                      .heave_damping_from = WaterFrom::share,
                      .heave_damping = 0.5};
    const WaterModel model(water, 1, {side, side}, 1 / (side * side), radius, speed);
    ElementState speck;
    speck.position = {structure_x + from_axis.x(), -1, from_axis.y()};
    speck.rotation << 0, 1, 0, 1, 0, 0, 0, 0, -1;  // its normal along x
    const double x = model.wrench(speck, structure_x).force.x();
    speck.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // along z
    return {x, model.wrench(speck, structure_x).force.z()};
}

Vec2 polar(double r, double theta) {
    return {r * std::cos(theta), r * std::sin(theta)};
}

TEST(PotentialFlow, DoesNotPassThroughTheMovingCircle) {
    for (double theta = 0; theta < 2 * std::numbers::pi; theta += 0.1) {
        const Vec2 outward = polar(1, theta);
        EXPECT_NEAR(potential_flow(polar(radius, theta)).dot(outward), speed * std::cos(theta), 1e-15);
    }
}

TEST(PotentialFlow, HasThePrintedPolarComponents) {
    for (const double r : {0.7, 1.5, 4.0}) {
        for (double theta = 0.05; theta < 6.2; theta += 0.3) {
            const Vec2 velocity = potential_flow(polar(r, theta));
            const double scale = speed * radius * radius / (r * r);
            EXPECT_NEAR(velocity.dot(polar(1, theta)), scale * std::cos(theta), 1e-15);
            EXPECT_NEAR(velocity.dot(polar(1, theta + std::numbers::pi / 2)), scale * std::sin(theta), 1e-15);
        }
    }
}

TEST(PotentialFlow, HasNoVorticityAndNoDivergenceOutside) {
    const double h = 1e-5;
    for (const Vec2& place : {Vec2(1, 0.3), Vec2(-0.2, 0.8), Vec2(-2, -1)}) {
        const auto u = [&](double dx, double dz) { return potential_flow(place + Vec2(dx, dz)); };
        const Vec2 by_x = (u(h, 0) - u(-h, 0)) / (2 * h);
        const Vec2 by_z = (u(0, h) - u(0, -h)) / (2 * h);
        EXPECT_NEAR(by_x.x() + by_z.y(), 0, 1e-9);
        EXPECT_NEAR(by_z.x() - by_x.y(), 0, 1e-9);
    }
}

TEST(PotentialFlow, FallsWithTheSquareOfDistance) {
    const double near = potential_flow({2, 1}).norm();
    const double far = potential_flow({20, 10}).norm();
    EXPECT_NEAR(far / near, 0.01, 1e-12);
}

TEST(PotentialFlow, WithinTheCircleKeepsTheValueAtItsEdge) {
    for (double theta = 0.1; theta < 6.2; theta += 0.5) {
        const Vec2 edge = potential_flow(polar(radius, theta));
        EXPECT_NEAR((potential_flow(polar(0.2 * radius, theta)) - edge).norm(), 0, 1e-15);
    }
}

}  // namespace flow_test
}  // namespace floes
