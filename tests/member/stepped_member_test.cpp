#include "member/stepped_member.hpp"

#include <gtest/gtest.h>

#include "member/run_member.hpp"
#include "shapes/moorings.hpp"
#include "support/jam_scenario.hpp"

namespace floes {
namespace stepped_member_test {

/// A jam for two seconds.
Scenario brief() {
    Scenario scenario = jam_scenario();
    scenario.analysis.steady_start = 1;
    scenario.analysis.window = 1;
    return scenario;
}

Scenario moored() {
    Scenario scenario = brief();
    scenario.moorings = {.mass = 800, .gyration = 0.4, .surge = 4000, .sway = 4000, .yaw = 500};
    return scenario;
}

TEST(SteppedMember, GoesAsARunDoes) {
    for (const Scenario& scenario : {brief(), moored()}) {
        const MemberResult run = run_member(scenario, 7, 0);
        SteppedMember member(scenario, 7, 0);
        double impulse = 0;
        for (int k = 0; k < scenario.step_count() / 5; ++k) impulse += -member.step(5, {}).force.x();
        EXPECT_EQ(member.simulation().loads().surge, run.history.surge);
        double sum = 0;
        for (const double load : run.history.surge) sum += load;
        const bool turns = scenario.moorings.give_way();  // and so do the axes of the history
        EXPECT_NEAR(5 * impulse, sum, (turns ? 1e-2 : 1e-9) * sum);
        EXPECT_GT(sum, 0);
    }
}

TEST(SteppedMember, IsLedFromWhereItsTowHasIt) {
    const Scenario scenario = brief();
    Vec6 at_start = Vec6::Zero();
    at_start[at(Motion::surge)] = -0.25;
    at_start[at(Motion::yaw)] = 0.1;
    SteppedMember member(scenario, 7, 0, &at_start);
    const StructureMotion& structure = member.simulation().structure();
    EXPECT_EQ(structure.after().position.x(), scenario.structure.start - 0.25);
    EXPECT_EQ(structure.after().yaw, 0.1);
    HullInput input{.offset = at_start};
    input.velocity[at(Motion::sway)] = 0.05;
    input.velocity[at(Motion::pitch)] = 0.02;
    member.step(10, input);
    const double time = 10 * scenario.general.time_step;
    EXPECT_NEAR(structure.after().position.x(), scenario.structure.start - 0.25 + scenario.structure.speed * time,
                1e-12);
    EXPECT_NEAR(structure.after().position.z(), 0.05 * time, 1e-15);
    EXPECT_NEAR(structure.after().pitch, 0.02 * time, 1e-15);
    EXPECT_NEAR(structure.velocity().z(), 0.05, 1e-12);
    EXPECT_NEAR(structure.angular_velocity().norm(), 0.02, 1e-9);
    EXPECT_EQ(member.simulation().motions().yaw.size(), 10u);
}

TEST(SteppedMember, IsSetAtAnyTime) {
    SteppedMember member(moored(), 7, 0);
    HullInput input;
    input.load.force = {-300, 0, 50};
    member.step(30, input);
    const Bytes saved = member.simulation().saved();
    const Vec3 once = member.step(40, input).force;
    member.set(saved);
    EXPECT_EQ(member.simulation().steps(), 30);
    EXPECT_EQ(member.step(40, input).force, once);
    member.set(saved);
    EXPECT_NE(member.step(40, {}).force, once);
}

}  // namespace stepped_member_test
}  // namespace floes
