#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace state_test {

/// The structure drives into two floes so hard that they break, in still water.
Scenario breaking_scenario(SolverKind solver) {
    Scenario scenario = sweeping_scenario();
    scenario.general.solver = solver;
    if (solver == SolverKind::stock) scenario.contact = {};  // it has the paper's laws only
    scenario.field.floes = 2;
    scenario.field.concentration = 0.05;
    scenario.structure.start = 3.9;
    scenario.structure.speed = 0.5;
    scenario.ice.bending_strength = 5e3;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 6;
    return scenario;
}

const std::vector<PlanarPose> two{{5.3, 0.1, 0.3}, {6.2, -0.2, 0.9}};

class ResumedTow : public ::testing::TestWithParam<SolverKind> {};

// As long as the structure touches nothing, no contact is lost with a state: every step is the same, to the bit.
TEST_P(ResumedTow, GoesOnWithTheSameBitsWhileNothingTouches) {
    const Scenario scenario = breaking_scenario(GetParam());
    Simulation whole(scenario, floes_at(scenario, two));
    for (int i = 0; i < 10; ++i) whole.step();
    Simulation resumed(scenario, floes_at(scenario, two), whole.state());
    EXPECT_EQ(resumed.steps(), 10);
    EXPECT_TRUE(std::isnan(resumed.loads().surge[9]));
    for (int i = 0; i < 10; ++i) {
        whole.step();
        resumed.step();
    }
    ASSERT_EQ(whole.loads().surge.back(), 0) << "the scene is one without contact";
    for (std::size_t i = 0; i < whole.element_states().size(); ++i) {
        EXPECT_EQ(resumed.element_states()[i].position, whole.element_states()[i].position) << i;
        EXPECT_EQ(resumed.element_states()[i].rotation, whole.element_states()[i].rotation) << i;
        EXPECT_EQ(resumed.element_states()[i].velocity, whole.element_states()[i].velocity) << i;
    }
    EXPECT_EQ(resumed.loads().surge.size(), whole.loads().surge.size());
}

TEST_P(ResumedTow, HasTheBreaksAndTheirPiecesAndStaysClose) {
    const Scenario scenario = breaking_scenario(GetParam());
    Simulation whole(scenario, floes_at(scenario, two));
    while (whole.ice().breaks().empty() && whole.steps() < scenario.step_count()) whole.step();
    for (int i = 0; i < 5; ++i) whole.step();
    ASSERT_FALSE(whole.ice().breaks().empty());
    Simulation resumed(scenario, floes_at(scenario, two), whole.state());
    EXPECT_EQ(resumed.ice().breaks(), whole.ice().breaks());
    EXPECT_EQ(resumed.ice().live_joints(), whole.ice().live_joints());
    for (std::size_t i = 0; i < whole.ice().elements().size(); ++i) {
        EXPECT_EQ(resumed.ice().elements()[i].piece, whole.ice().elements()[i].piece) << i;
        EXPECT_EQ(resumed.ice().elements()[i].exposed_edges, whole.ice().elements()[i].exposed_edges) << i;
    }
    whole.step();
    resumed.step();
    const double way = scenario.structure.speed * scenario.general.time_step;
    for (std::size_t i = 0; i < whole.element_states().size(); ++i) {
        EXPECT_LT((resumed.element_states()[i].position - whole.element_states()[i].position).norm(), way) << i;
    }
}

TEST_P(ResumedTow, RefusesAStateOfOtherFloes) {
    const Scenario scenario = breaking_scenario(GetParam());
    SimulationState state = Simulation(scenario, floes_at(scenario, two)).state();
    SimulationState few = state;
    few.elements.pop_back();
    EXPECT_THROW(Simulation(scenario, floes_at(scenario, two), few), InputError);
    state.breaks.push_back({.time = 0.1, .floe = 2, .joint = 0, .mode = FailureMode::bending});
    EXPECT_THROW(Simulation(scenario, floes_at(scenario, two), state), InputError);
}

INSTANTIATE_TEST_SUITE_P(Solvers, ResumedTow, ::testing::Values(SolverKind::stock, SolverKind::lanes),
                         [](const auto& given) { return given.param == SolverKind::stock ? "stock" : "lanes"; });

}  // namespace state_test
}  // namespace floes
