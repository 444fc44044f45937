// The flow round ellipses, for hulls that are no circle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "water/water_model.hpp"

namespace floes {
namespace ellipse_test {

constexpr double speed = 0.07;

/// As in flow_test.cpp: the velocity of the water seen by a speck of ice.
Vec2 flow_round(const std::vector<FlowEllipse>& ellipses, const Vec2& place, double radius = 1, Vec2 current = {0, 0}) {
    constexpr double side = 0x1p-60;
    const Water water{.density = 1,
                      .form_drag = 0,
                      .skin_drag = 0,
                      .heave_drag = 0,
                      .heave_damping_from = WaterFrom::share,
                      .heave_damping = 0.5,
                      .current = current.norm(),
                      .current_direction = std::atan2(current.y(), current.x())};
    WaterModel model(water, 1, {side, side}, 1 / (side * side), radius, speed);
    model.flow_round(ellipses);
    ElementState speck;
    speck.position = {place.x(), -1, place.y()};
    speck.rotation << 0, 1, 0, 1, 0, 0, 0, 0, -1;
    const double x = model.wrench(speck, 0).force.x();
    speck.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return {x, model.wrench(speck, 0).force.z()};
}

TEST(FlowRoundEllipses, OfACircleIsThatOfTheCircle) {
    for (const Vec2& current : {Vec2(0, 0), Vec2(0.02, -0.05)})
        for (const Vec2& place : {Vec2(2, 0.3), Vec2(-0.2, 1.8), Vec2(-2, -1), Vec2(0.3, 0.2), Vec2(0, -3)})
            EXPECT_NEAR(
                (flow_round({{0, 0, 1.2, 1.2}}, place, 1, current) - flow_round({}, place, 1.2, current)).norm(), 0,
                1e-14)
                << place.transpose();
}

TEST(FlowRoundEllipses, DoesNotPassThroughTheMovingHull) {
    const Vec2 current(0.01, 0.03);
    for (const auto& [a, b] : {std::pair{5.0, 1.0}, std::pair{1.0, 4.0}}) {
        for (double angle = 0.05; angle < 2 * std::numbers::pi; angle += 0.1) {
            const Vec2 edge(a * std::cos(angle), b * std::sin(angle));
            const Vec2 outward = Vec2(std::cos(angle) / a, std::sin(angle) / b).normalized();
            const Vec2 velocity = flow_round({{2, -1, a, b}}, edge + Vec2(2, -1), 1, current);
            EXPECT_NEAR(velocity.dot(outward), speed * outward.x(), 1e-13) << a << " " << angle;
        }
    }
}

TEST(FlowRoundEllipses, HasNoVorticityAndNoDivergence) {
    const double h = 1e-5;
    for (const Vec2& place : {Vec2(6, 0.3), Vec2(-0.2, 1.8), Vec2(-4, -2), Vec2(0, -1.5)}) {
        const auto u = [&](double dx, double dz) { return flow_round({{0, 0, 5, 1}}, place + Vec2(dx, dz)); };
        const Vec2 by_x = (u(h, 0) - u(-h, 0)) / (2 * h);
        const Vec2 by_z = (u(0, h) - u(0, -h)) / (2 * h);
        EXPECT_NEAR(by_x.x() + by_z.y(), 0, 1e-9);
        EXPECT_NEAR(by_z.x() - by_x.y(), 0, 1e-9);
    }
}

TEST(FlowRoundEllipses, OfSeveralAddsUp) {
    const FlowEllipse one{3, 2, 1, 0.5};
    const FlowEllipse other{-3, -2, 0.5, 1};
    const Vec2 place(0.4, 5);
    EXPECT_NEAR((flow_round({one, other}, place) - flow_round({one}, place) - flow_round({other}, place)).norm(), 0,
                1e-15);
}

}  // namespace ellipse_test
}  // namespace floes
