#include "water/flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace {

constexpr double radius = 0.614;
constexpr double speed = 0.07;

Vec2 polar(double r, double theta) {
    return {r * std::cos(theta), r * std::sin(theta)};
}

TEST(PotentialFlow, DoesNotPassThroughTheMovingCircle) {
    for (double theta = 0; theta < 2 * std::numbers::pi; theta += 0.1) {
        const Vec2 outward = polar(1, theta);
        EXPECT_NEAR(potential_flow(polar(radius, theta), radius, speed).dot(outward), speed * std::cos(theta), 1e-15);
    }
}

TEST(PotentialFlow, HasThePrintedPolarComponents) {
    for (const double r : {0.7, 1.5, 4.0}) {
        for (double theta = 0.05; theta < 6.2; theta += 0.3) {
            const Vec2 velocity = potential_flow(polar(r, theta), radius, speed);
            const double scale = speed * radius * radius / (r * r);
            EXPECT_NEAR(velocity.dot(polar(1, theta)), scale * std::cos(theta), 1e-15);
            EXPECT_NEAR(velocity.dot(polar(1, theta + std::numbers::pi / 2)), scale * std::sin(theta), 1e-15);
        }
    }
}

TEST(PotentialFlow, HasNoVorticityAndNoDivergenceOutside) {
    const double h = 1e-5;
    for (const Vec2& place : {Vec2(1, 0.3), Vec2(-0.2, 0.8), Vec2(-2, -1)}) {
        const auto u = [&](double dx, double dz) { return potential_flow(place + Vec2(dx, dz), radius, speed); };
        const Vec2 by_x = (u(h, 0) - u(-h, 0)) / (2 * h);
        const Vec2 by_z = (u(0, h) - u(0, -h)) / (2 * h);
        EXPECT_NEAR(by_x.x() + by_z.y(), 0, 1e-9);
        EXPECT_NEAR(by_z.x() - by_x.y(), 0, 1e-9);
    }
}

TEST(PotentialFlow, FallsWithTheSquareOfDistance) {
    const double near = potential_flow({2, 1}, radius, speed).norm();
    const double far = potential_flow({20, 10}, radius, speed).norm();
    EXPECT_NEAR(far / near, 0.01, 1e-12);
}

TEST(PotentialFlow, WithinTheCircleKeepsTheValueAtItsEdge) {
    for (double theta = 0.1; theta < 6.2; theta += 0.5) {
        const Vec2 edge = potential_flow(polar(radius, theta), radius, speed);
        EXPECT_NEAR((potential_flow(polar(0.2 * radius, theta), radius, speed) - edge).norm(), 0, 1e-15);
    }
    EXPECT_EQ(potential_flow({0, 0}, radius, speed), Vec2(speed, 0));
}

}  // namespace
}  // namespace floes
