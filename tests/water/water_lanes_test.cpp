#include "water/water_lanes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "core/error.hpp"
#include "solver/lane_width.hpp"

namespace floes {
namespace water_lanes_test {

constexpr ElementShape shape{0.2, 0.033};
constexpr double structure_x = 1.5;

WaterModel model(WaterFlow flow, ElementShape size = shape, double current = 0) {
    Water water;
    water.flow = flow;
    water.current = current;
    water.current_direction = 2;
    water.turning = 4 * current;
    const Vec2 wind_stress(current, -2 * current);
    return {water, 9.81, size, 930 * size.side * size.side * size.thickness, 0.614, 0.07, wind_stress};
}

/// A regular polygon of ice.
WaterModel model_of_polygon(WaterFlow flow, int corners) {
    Water water;
    water.flow = flow;
    Outline outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        outline.push_back({0.1 * std::cos(angle), 0.1 * std::sin(angle)});
    }
    const CutElement element = cut_into_cells(outline, 1).elements.front();
    return {water, 9.81, element, 0.033, 930 * 0.033 * element.area, 0.614, 0.07};
}

Mat3 turned(double angle, const Vec3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

constexpr std::array<EdgeShelter, 6> sheltered{{{}, {0, 0.05}, {0.5, -0.01}, {0.9, 0.02}, {0.3, 0}, {}}};

/// In the lee and in the open, floating, sunk, dry, tilted, upright, upside down, at rest and fast, within the
/// structure's circle and far off.
std::vector<ElementState> every_kind_of_element() {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto vector = [&](double size) {
        return Vec3(between(-size, size), between(-size, size), between(-size, size));
    };
    std::vector<ElementState> elements;
    for (int i = 0; i < 2003; ++i) {
        ElementState state;
        const double tilt = i % 3 == 0 ? 0.02 : std::numbers::pi;
        state.rotation = turned(between(-tilt, tilt), vector(1)) * turned(between(-3, 3), Vec3::UnitY());
        state.position = vector(i % 5 == 0 ? 0.5 : 3);
        state.position.y() = between(-0.03, 0.03) * (i % 7 == 0 ? 10 : 1);
        state.velocity = vector(i % 4 == 0 ? 1 : 0.05);
        state.angular_velocity = vector(i % 4 == 1 ? 2 : 0.05);
        state.exposed_edges = static_cast<std::uint8_t>(random() % 16);
        if (i % 2 == 0) state.shelter = sheltered;
        elements.push_back(state);
    }
    ElementState resting;  // flat, zeros everywhere
    elements.push_back(resting);
    resting.position.x() = structure_x;  // the middle of the structure
    resting.exposed_edges = 15;
    elements.push_back(resting);
    resting.rotation = turned(std::numbers::pi / 2, Vec3::UnitX());
    resting.rotation(1, 1) = 0;  // its normal exactly level
    elements.push_back(resting);
    resting.position.y() = -0.1;
    elements.push_back(resting);
    return elements;
}

::testing::AssertionResult same_bits(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) {
            return ::testing::AssertionFailure() << "[" << i << "]: " << a[i] << " and " << b[i];
        }
    }
    return ::testing::AssertionSuccess();
}

class WaterLanesOf : public ::testing::TestWithParam<WaterFlow> {};

TEST_P(WaterLanesOf, EveryWidthHasTheBitsOfOneElementAlone) {
    const std::vector<WaterModel> models{model(GetParam()), model(GetParam(), {0.3, 0.05}),
                                         model(GetParam(), shape, 0.1), model_of_polygon(GetParam(), 3),
                                         model_of_polygon(GetParam(), 6)};
    std::vector<ElementState> elements = every_kind_of_element();
    std::vector<std::size_t> model_of;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        model_of.push_back(i / 2 % models.size());
        if (model_of.back() == 3) elements[i].exposed_edges &= 0b111;
    }
    for (const int width : lane_widths()) {
        // Squares and polygons by turns, some that drift, and every third element left out: lanes are filled with what
        // there is of a kind.
        WaterLanes many(models, model_of, width);
        for (std::size_t i = 0; i < elements.size(); ++i) many.set(i, elements[i]);
        many.clear();  // others had the places before
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (i % 3 != 0) many.set(i, elements[i]);
        many.compute(structure_x);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (i % 3 == 0) continue;
            const Wrench expected = models[model_of[i]].wrench(elements[i], structure_x);
            ASSERT_TRUE(same_bits(many.wrench(i).force, expected.force)) << "element " << i << ", width " << width;
            ASSERT_TRUE(same_bits(many.wrench(i).moment, expected.moment)) << "element " << i << ", width " << width;
        }
    }
}

// The flow goes with the structure: everything moved aside and turned by 90° has the same forces, turned.
void expect_flow_to_follow(const WaterModel& made) {
    const std::vector<ElementState> elements = every_kind_of_element();
    const std::vector<std::size_t> model_of(elements.size(), 0);
    const Mat3 turn = turned(std::numbers::pi / 2, Vec3::UnitY());  // +x to -z
    const Vec3 aside(3, 0, 0.4);
    const std::vector<WaterModel> models{made};
    WaterLanes there(models, model_of, 1);
    WaterLanes here(models, model_of, 1);
    here.move_structure({.z = aside.z(), .yaw = std::numbers::pi / 2, .velocity = {0, -0.07}});
    for (std::size_t i = 0; i < elements.size(); ++i) {
        ElementState state = elements[i];
        state.position.x() -= structure_x;
        there.set(i, state);
        state.position = aside + turn * state.position;
        state.rotation = turn * state.rotation;
        state.velocity = turn * state.velocity;
        state.angular_velocity = turn * state.angular_velocity;
        here.set(i, state);
    }
    there.compute(0);
    here.compute(aside.x());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const double scale = 1e-9 * (1 + there.wrench(i).force.norm());
        EXPECT_NEAR((here.wrench(i).force - turn * there.wrench(i).force).norm(), 0, scale) << i;
        EXPECT_NEAR((here.wrench(i).moment - turn * there.wrench(i).moment).norm(), 0, scale) << i;
    }
}

TEST_P(WaterLanesOf, FlowFollowsTheStructure) {
    WaterModel made = model(GetParam());
    expect_flow_to_follow(made);
    const std::array<FlowEllipse, 2> hulls{{{0.1, 0.05, 1, 0.4}, {-1.5, 0, 0.3, 0.2}}};
    made.flow_round(hulls);
    expect_flow_to_follow(made);
}

INSTANTIATE_TEST_SUITE_P(Flows, WaterLanesOf, ::testing::Values(WaterFlow::potential, WaterFlow::still));

TEST(WaterLanes, RefuseAWidthThatThereIsNot) {
    EXPECT_THROW(WaterLanes(std::vector{model(WaterFlow::still)}, std::vector<std::size_t>(4), 3), RunError);
}

}  // namespace water_lanes_test
}  // namespace floes
