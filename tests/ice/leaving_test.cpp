// Floes that leave an ice field, and others that come in their places.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ice/ice_field.hpp"
#include "ice_scene.hpp"

namespace floes::test {
namespace leaving_test {

Scenario beam_scenario(int elements_long, int elements_broad) {
    Scenario scenario = scenario_of(elements_long, elements_broad);
    scenario.joint.model = JointModel::beam;
    scenario.joint.failure = JointFailure::stress;
    scenario.general.solver = SolverKind::direct;
    return scenario;
}

SingleFloe floe_at(const Scenario& scenario, const PlanarPose& pose) {
    return {pose, scenario.floe, scenario.material()};
}

/// Tears the last element off a floe of three in a row.
void tear(World& world, IceField& ice, int place) {
    const auto first = static_cast<std::size_t>(ice.first_element(place));
    const std::size_t before = ice.breaks().size();
    for (int step = 0; step < 2000 && ice.breaks().size() == before; ++step) {
        const double force = 0.5 * step;
        load_joint(world, ice.elements()[first + 1].body, ice.elements()[first + 2].body, {0.1, 0, 0}, {force, 0, 0},
                   Vec3::Zero());
        world.step();
        ice.break_joints(world, 0.02 * step);
    }
    ASSERT_EQ(ice.breaks().size(), before + 1);
}

TEST(Leaving, KeepsTheCountsAndThePieces) {
    Scenario scenario = beam_scenario(3, 1);
    scenario.joint.failure = JointFailure::moment;
    scenario.ice.tensile_strength = 10.0 / (0.2 * 0.033);  // 10 N
    scenario.general.gravity = 1e-9;                       // nothing carries them
    World world = scenario_world(scenario);
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}, {0, 2, 0}}));
    tear(world, ice, 0);
    ice.leave(world, std::array{0});
    EXPECT_FALSE(ice.is_there(0));
    EXPECT_EQ(ice.enter(world, scenario, floe_at(scenario, {0, 4, 0})), 0) << "the place is free";
    EXPECT_EQ(ice.number_of(0), 2);
    EXPECT_EQ(ice.place_of(2), 0);
    EXPECT_EQ(ice.piece_areas().size(), 2u);
    EXPECT_EQ(ice.pieces(), 4) << "two of the one that left, and two whole floes";
    tear(world, ice, 0);
    tear(world, ice, 1);
    EXPECT_EQ(ice.floes(), 3);
    EXPECT_EQ(ice.places(), 2);
    EXPECT_EQ(ice.broken_floes(), 3);
    EXPECT_EQ(ice.split_floes(), 3);
    EXPECT_EQ(ice.pieces(), 6);
    const std::vector<PieceArea> areas = ice.piece_areas();
    ASSERT_EQ(areas.size(), 6u);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        EXPECT_EQ(areas[i].floe, static_cast<int>(i / 2)) << "by floe, in the order in which they came";
        EXPECT_NEAR(areas[i].area, i % 2 == 0 ? 0.08 : 0.04, 1e-12);
    }
}

/// A floe of this outline, about its centroid.
SingleFloe polygon_at(const Scenario& scenario, Outline outline, const PlanarPose& pose) {
    SingleFloe floe = floe_at(scenario, pose);
    floe.shape.outline = in_axes(outline, measures_of(outline).centroid, {1, 0});
    floe.shape.length = size_of(floe.shape.outline).x;
    floe.shape.breadth = size_of(floe.shape.outline).z;
    return floe;
}

TEST(Leaving, APolygonTakesThePlaceOfOneOfAsManyElements) {
    Scenario scenario = beam_scenario(3, 1);
    scenario.joint.failure = JointFailure::moment;
    scenario.general.gravity = 0;
    const Outline rhomb{{-0.3, -0.1}, {0.2, -0.1}, {0.3, 0.1}, {-0.2, 0.1}};
    const Outline kite{{-0.3, 0}, {-0.1, -0.1}, {0.3, -0.02}, {0.05, 0.1}};
    const Outline other{{-0.3, -0.2}, {0.2, -0.2}, {0.3, 0.2}, {-0.2, 0.2}};
    const SingleFloe first = polygon_at(scenario, rhomb, {0, 0, 0});
    const SingleFloe second = polygon_at(scenario, kite, {0.1, 0, 0.3});
    const SingleFloe third = polygon_at(scenario, other, {0, 2, 0});
    ASSERT_EQ(first.shape.elements(), second.shape.elements());
    ASSERT_NE(first.shape.elements(), third.shape.elements());
    World fresh = scenario_world(scenario);
    IceField alone(fresh, scenario, gathered(std::vector<SingleFloe>{second}));
    World used = scenario_world(scenario);
    IceField ice(used, scenario, gathered(std::vector<SingleFloe>{first}));
    for (int step = 0; step < 5; ++step) {
        used.apply(ice.elements().front().body, {{0.1, 0.03, 0.02}, {0.01, 0.02, -0.01}});
        used.step();
    }
    ice.leave(used, std::array{0});
    EXPECT_EQ(ice.enter(used, scenario, third), 1) << "of more elements";
    EXPECT_EQ(ice.enter(used, scenario, second), 0);
    EXPECT_EQ(ice.number_of(0), 2);
    EXPECT_EQ(ice.live_joints(), alone.live_joints() + static_cast<int>(ice.cut(1).joints.size()));
    for (int step = 0; step < 30; ++step) {
        for (auto& [world, field] : {std::pair(&fresh, &alone), std::pair(&used, &ice)}) {
            world->apply(field->elements().front().body, {{0.01, 0.03, 0.02}, {0.001, 0.002, -0.001}});
            world->step();
        }
        for (std::size_t i = 0; i < alone.elements().size(); ++i)
            ASSERT_EQ(fresh.state(alone.elements()[i].body).position, used.state(ice.elements()[i].body).position)
                << step << ' ' << i;
    }
}

/// A floe of five in a row falls across a bar and breaks there: by its weight and by what the bar presses.
struct Fall {
    explicit Fall(const Scenario& given) : scenario(given), world(scenario_world(given)) {
        const double height = scenario.floe.floating_height(scenario.ice, scenario.water.density);
        world.add_fixed_box({Vec3(0.1, 0.05, 0.3), {Vec3(0.03, height - 0.08, 0), Quat::Identity()}});
    }

    Scenario scenario;
    World world;
};

void expect_alike(Fall& fresh, IceField& alone, Fall& used, IceField& later) {
    const std::size_t before = later.breaks().size();
    std::vector<double> alone_used, later_used;
    for (int step = 0; step < 60; ++step) {
        for (Fall* fall : {&fresh, &used}) fall->world.step();
        alone.read_utilisation(fresh.world, alone_used);
        later.read_utilisation(used.world, later_used);
        ASSERT_EQ(alone_used, later_used) << step;
        ASSERT_EQ(alone.break_joints(fresh.world, step), later.break_joints(used.world, step)) << step;
        for (std::size_t i = 0; i < alone.elements().size(); ++i)
            ASSERT_EQ(fresh.world.state(alone.elements()[i].body).position,
                      used.world.state(later.elements()[i].body).position);
    }
    EXPECT_FALSE(alone.breaks().empty()) << "it is to break";
    EXPECT_EQ(later.breaks().size(), before + alone.breaks().size());
}

TEST(Leaving, GivesAFloeInAnothersPlaceTheStressThatItHasAlone) {
    const Scenario scenario = beam_scenario(5, 1);
    ASSERT_TRUE(scenario.joint.fails_by_stress());
    Fall fresh(scenario);
    IceField alone(fresh.world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
    Fall used(scenario);
    Scenario other = scenario;  // of other ice, that presses on the bar and breaks
    other.ice.bending_strength *= 0.6;
    other.ice.poisson_ratio = 0.1;
    IceField later(used.world, other, floes_at(other, std::vector<PlanarPose>{{0.05, 0, 0}}));
    for (int step = 0; step < 20; ++step) {
        used.world.step();
        later.break_joints(used.world, step);
    }
    EXPECT_FALSE(later.breaks().empty()) << "the first one is to break too";
    later.leave(used.world, std::array{0});
    ASSERT_EQ(later.enter(used.world, scenario, floe_at(scenario, {0, 0, 0})), 0);
    expect_alike(fresh, alone, used, later);
}

}  // namespace leaving_test
}  // namespace floes::test
