#include "simulation/moving_window.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/simulation.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace sleeping_floes_test {

constexpr double wake_radius = 1.3;

/// A floe ahead of the structure, within the radius; 5 cm beyond it another; and one to the side.
Scenario three_floes() {
    Scenario scenario = sweeping_scenario();
    scenario.field.floes = 3;
    scenario.field.concentration = 0.05;
    scenario.field.wake_radius = wake_radius;
    scenario.structure.start = 4.5;
    scenario.structure.speed = 0.2;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 6;
    return scenario;
}
const std::vector<PlanarPose> poses{{5.7, 0.1, 0}, {6.35, 0.1, 0}, {5.4, -1.1, 0.3}};

bool same_bits(const Simulation& a, const Simulation& b, int floe) {
    for (std::size_t i = 0; i < a.ice().elements().size(); ++i) {
        const BodyState& left = a.element_states()[i];
        const BodyState& right = b.element_states()[i];
        if (a.ice().elements()[i].floe == floe &&
            !(left.position == right.position && left.rotation == right.rotation && left.velocity == right.velocity &&
              left.angular_velocity == right.angular_velocity)) {
            return false;
        }
    }
    return true;
}

TEST(SleepingFloes, ARadiusBeyondTheFieldGivesTheBitsOfNone) {
    Scenario scenario = three_floes();
    scenario.field.wake_radius = 0;
    Simulation off(scenario, floes_at(scenario, poses));
    scenario.field.wake_radius = 100;
    Simulation far(scenario, floes_at(scenario, poses));
    ASSERT_TRUE(off.run({}));
    ASSERT_TRUE(far.run({}));
    EXPECT_EQ(off.loads().surge, far.loads().surge);
    EXPECT_GT(*std::ranges::max_element(off.loads().surge), 1) << "the structure is to meet the ice";
    for (const int floe : {0, 1, 2}) EXPECT_TRUE(same_bits(off, far, floe)) << floe;
}

TEST(SleepingFloes, StayExactlyWhereTheyAreUntilAMovingFloeTouchesThem) {
    const Scenario scenario = three_floes();
    const Simulation start(scenario, floes_at(scenario, poses));
    Simulation tow(scenario, floes_at(scenario, poses));
    while (same_bits(tow, start, 1) && tow.steps() < scenario.step_count()) tow.step();
    const double axis = scenario.structure.start + scenario.structure.speed * tow.time();
    EXPECT_GT(poses[1].x - axis, wake_radius) << "the second was woken by the first, not by the structure";
    // It woke with a gap of some millimetres at most between the two.
    double front = 0;
    for (const BodyState& state : tow.element_states()) {
        if (&state - tow.element_states().data() < 9) front = std::max(front, state.position.x());
    }
    EXPECT_NEAR(front + 0.1, poses[1].x - 0.3, 0.01);
}

TEST(SleepingFloes, WakeWhenTheStructureComesWithinTheRadius) {
    const Scenario scenario = three_floes();
    const Simulation start(scenario, floes_at(scenario, poses));
    Simulation tow(scenario, floes_at(scenario, poses));
    double before = 0;
    while (same_bits(tow, start, 2)) {
        ASSERT_LT(tow.steps(), scenario.step_count());
        before = tow.time();
        tow.step();
    }
    const double axis = scenario.structure.start + scenario.structure.speed * before;
    const Vec3 way(poses[2].x - axis, 0, poses[2].z);
    EXPECT_LE(way.norm(), wake_radius);
    EXPECT_GT(way.norm(), wake_radius - scenario.structure.speed * scenario.general.time_step);
}

TEST(SleepingFloes, SleepOnInATowThatIsTakenUpAgain) {
    const Scenario scenario = three_floes();
    Simulation whole(scenario, floes_at(scenario, poses));
    for (int i = 0; i < 10; ++i) whole.step();
    Simulation resumed(scenario, floes_at(scenario, poses), whole.state());
    for (int i = 0; i < 20; ++i) {
        whole.step();
        resumed.step();
    }
    for (const int floe : {0, 1, 2}) EXPECT_TRUE(same_bits(whole, resumed, floe)) << floe;
    EXPECT_TRUE(same_bits(resumed, Simulation(scenario, floes_at(scenario, poses)), 2));
}

TEST(SleepingFloes, TheStatedBoundHoldsForWhatTheFlowWouldHaveDone) {
    Scenario scenario = three_floes();
    scenario.field.wake_radius = 0;
    Simulation awake(scenario, floes_at(scenario, std::vector<PlanarPose>{{8.0, 0.3, 0.2}}));
    const BodyState before = awake.element_states()[4];  // the middle of the floe
    const auto axis = [&] { return scenario.structure.start + scenario.structure.speed * awake.time(); };
    while ((before.position - Vec3(axis(), 0, 0)).norm() > wake_radius) awake.step();
    const double moved = (awake.element_states()[4].position - before.position).norm();
    const double a = scenario.structure.shape.waterline_radius();
    EXPECT_GT(moved, 0);
    EXPECT_LT(moved, a * a / wake_radius);
    EXPECT_LT(awake.element_states()[4].velocity.norm(),
              scenario.structure.speed * a * a / (wake_radius * wake_radius));
}

}  // namespace sleeping_floes_test
}  // namespace floes
