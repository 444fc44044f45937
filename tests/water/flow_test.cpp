// The flow round the structure, seen by a speck of ice: round a circle, round ellipses, of a current.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "water/water_model.hpp"

namespace floes {
namespace flow_test {

constexpr double radius = 0.614;
constexpr double speed = 0.07;

Water streaming(double current, double direction) {
    return {.density = 1,
            .form_drag = 0,
            .skin_drag = 0,
            .heave_drag = 0,
            .heave_damping_from = WaterFrom::share,
            .heave_damping = 0.5,
            .current = current,
            .current_direction = direction};
}

WaterModel model_of(const Water& water, double circle = radius) {
    constexpr double side = 0x1p-60;
    return {water, 1, {side, side}, 1 / (side * side), circle, speed};
}

/// Velocity (x, z) of the water at a place (x, z) from the structure's axis, seen by a speck of ice with linear damping
/// of 1 N s/m alone: a force along its normal with the number of the velocity.
Vec2 velocity(const WaterModel& model, const Vec2& from_axis, double structure_x = 0) {
    ElementState speck;
    speck.position = {structure_x + from_axis.x(), -1, from_axis.y()};
    speck.rotation << 0, 1, 0, 1, 0, 0, 0, 0, -1;  // its normal along x
    const double x = model.wrench(speck, structure_x).force.x();
    speck.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // along z
    return {x, model.wrench(speck, structure_x).force.z()};
}

/// `flow` gives the velocity at a place.
void expect_no_vorticity_and_no_divergence(const auto& flow, const Vec2& place) {
    const double h = 1e-5;
    const auto u = [&](double dx, double dz) -> Vec2 { return flow(place + Vec2(dx, dz)); };
    const Vec2 by_x = (u(h, 0) - u(-h, 0)) / (2 * h);
    const Vec2 by_z = (u(0, h) - u(0, -h)) / (2 * h);
    EXPECT_NEAR(by_x.x() + by_z.y(), 0, 1e-9);
    EXPECT_NEAR(by_z.x() - by_x.y(), 0, 1e-9);
}

Vec2 potential_flow(const Vec2& from_axis) {
    return velocity(model_of(streaming(0, 0)), from_axis, 0.25);
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
    for (const Vec2& place : {Vec2(1, 0.3), Vec2(-0.2, 0.8), Vec2(-2, -1)})
        expect_no_vorticity_and_no_divergence(potential_flow, place);
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

Vec2 flow_round(const std::vector<FlowEllipse>& ellipses, const Vec2& place, double circle = 1, Vec2 current = {0, 0}) {
    WaterModel model = model_of(streaming(current.norm(), std::atan2(current.y(), current.x())), circle);
    model.flow_round(ellipses);
    return velocity(model, place);
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
    const auto flow = [](const Vec2& place) { return flow_round({{0, 0, 5, 1}}, place); };
    for (const Vec2& place : {Vec2(6, 0.3), Vec2(-0.2, 1.8), Vec2(-4, -2), Vec2(0, -1.5)})
        expect_no_vorticity_and_no_divergence(flow, place);
}

TEST(FlowRoundEllipses, OfSeveralAddsUp) {
    const FlowEllipse one{3, 2, 1, 0.5};
    const FlowEllipse other{-3, -2, 0.5, 1};
    const Vec2 place(0.4, 5);
    EXPECT_NEAR((flow_round({one, other}, place) - flow_round({one}, place) - flow_round({other}, place)).norm(), 0,
                1e-15);
}

TEST(Current, IsUndisturbedFarAwayAndDoesNotPassThroughTheStructure) {
    for (const double direction : {0.0, 0.8, 2.5, -1.2}) {
        const Water water = streaming(0.2, direction);
        const Vec2 current(0.2 * std::cos(direction), 0.2 * std::sin(direction));
        EXPECT_NEAR((velocity(model_of(water), {600, -200}) - current).norm(), 0, 1e-6);
        for (double theta = 0; theta < 6.2; theta += 0.3) {
            const Vec2 outward(std::cos(theta), std::sin(theta));
            EXPECT_NEAR((velocity(model_of(water), radius * outward) - Vec2(speed, 0)).dot(outward), 0, 1e-14);
        }
    }
}

// What a body meets depends on its velocity through the water alone: turned by an angle, everything turns.
TEST(Current, IsTheFlowOfATowWhenTheStructureRests) {
    const Water still = streaming(0, 0);
    Water against = streaming(speed, std::numbers::pi);  // and the tow at tow: together twice as fast
    for (const Vec2& place : {Vec2(1, 0.3), Vec2(-0.2, 0.8), Vec2(-2, -1)}) {
        const Vec2 relative = velocity(model_of(against), place) - Vec2(-speed, 0);
        EXPECT_NEAR((relative - 2 * velocity(model_of(still), place)).norm(), 0, 1e-14);
    }
}

TEST(Current, PassesAStillStructureOnlyAsStillWater) {
    Water water = streaming(0.2, 0.5);
    water.flow = WaterFlow::still;
    EXPECT_NEAR((velocity(model_of(water), {0.7, 0.1}) - 0.2 * Vec2(std::cos(0.5), std::sin(0.5))).norm(), 0, 1e-14);
}

}  // namespace flow_test
}  // namespace floes
