// No length of the program's own: a scene scaled by Froude gives the same loads, scaled.

#include "support/froude.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace froude_test {

using test::scaled;

/// configs/smoke.toml at 60 MPa.
Scenario smoke() {
    Scenario scenario = in_smoke_channel(sweeping_scenario());
    scenario.analysis.steady_start = 8;
    scenario.analysis.window = 18;
    return scenario;
}

Scenario with_paper_contacts(Scenario scenario, SolverKind solver) {
    scenario.general.solver = solver;
    scenario.contact = with_preset(scenario.contact, ContactPreset::paper);
    return scenario;
}

/// Surge load of every step over s³, N.
std::vector<double> loads(const Scenario& original, const Arrangement& arrangement, double s, int steps) {
    const Scenario larger = scaled(original, s);
    Simulation simulation(larger, floes_at(larger, scaled(arrangement.poses(), s)));
    while (simulation.steps() < steps) simulation.step();
    std::vector<double> surge = simulation.loads().surge;
    for (double& load : surge) load /= s * s * s;
    return surge;
}

std::size_t first_contact(const std::vector<double>& loads) {
    return static_cast<std::size_t>(std::ranges::find_if(loads, [](double load) { return load != 0; }) - loads.begin());
}

class Froude : public ::testing::TestWithParam<double> {};

// Nothing is rounded differently, so the members need not be compared by their means: they are the same to the end.
// Rigid ice, too, which breaks most.
TEST_P(Froude, AMemberIsTheSameAtEverySize) {
    for (const double cfm : {0.016, 1e-10}) {
        Scenario scenario = smoke();
        scenario.joint.cfm = cfm;
        const Arrangement arrangement = make_arrangement(scenario, 1, 0);
        const std::vector<double> expected = loads(scenario, arrangement, 1, scenario.step_count());
        ASSERT_GT(*std::ranges::max_element(expected), 50);
        EXPECT_EQ(loads(scenario, arrangement, GetParam(), scenario.step_count()), expected);
    }
}

TEST_P(Froude, AMemberOfElasticBeamsIsTheSameAtEverySize) {
    Scenario scenario = smoke();
    scenario.general.solver = SolverKind::direct;
    scenario.joint.model = JointModel::beam;
    const Arrangement arrangement = make_arrangement(scenario, 1, 0);
    const std::vector<double> expected = loads(scenario, arrangement, 1, 600);
    ASSERT_GT(*std::ranges::max_element(expected), 10);
    EXPECT_EQ(loads(scenario, arrangement, GetParam(), 600), expected);
}

TEST_P(Froude, FirstContactsAreTheSameWithPaperContactsInBothSolvers) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::stock}) {
        const Scenario scenario = with_paper_contacts(smoke(), solver);
        const Arrangement arrangement = make_arrangement(scenario, 1, 0);
        const std::vector<double> expected = loads(scenario, arrangement, 1, 400);
        ASSERT_LT(first_contact(expected), 300u);
        EXPECT_EQ(loads(scenario, arrangement, GetParam(), 400), expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, Froude, ::testing::Values(0.25, 4, 16, 64));

// A scale whose root is not exact rounds otherwise, and a member is chaotic; but not at once.
TEST(FroudeOfAnyScale, FirstContactsAreTheSame) {
    const Scenario scenario = smoke();
    for (std::uint32_t number = 0; number < 3; ++number) {
        const Arrangement arrangement = make_arrangement(scenario, 1, number);
        const std::vector<double> expected = loads(scenario, arrangement, 1, 300);
        const std::vector<double> found = loads(scenario, arrangement, 30, 300);
        const std::size_t contact = first_contact(expected);
        ASSERT_LT(contact, 250u);
        for (std::size_t i = contact; i < contact + 20; ++i) {
            EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]) << i;
        }
    }
}

}  // namespace froude_test
}  // namespace floes
