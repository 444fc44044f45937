// Where the work of the tow goes: it adds up, and each share is there only with its cause.

#include <gtest/gtest.h>

#include <cmath>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace tow_work_test {

/// A short tow through packed floes.
Scenario packed() {
    Scenario scenario = in_smoke_channel({});
    scenario.analysis.steady_start = 6;
    scenario.analysis.window = 10;
    scenario.analysis.segments = 1;
    return scenario;
}

struct Found {
    WorkShares work;
    double mean = 0;
    double looked_at = 0;  ///< mean of every fifth step, those that the work is of
};

Found towed(const Scenario& scenario) {
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    EXPECT_TRUE(simulation.run({}));
    const std::vector<double>& surge = simulation.loads().surge;
    Found found{simulation.work()};
    const auto first = static_cast<std::size_t>(scenario.first_window_step());
    for (std::size_t i = first; i < surge.size(); ++i)
        found.mean += surge[i] / static_cast<double>(surge.size() - first);
    const auto looked_at = static_cast<double>((surge.size() - first + 4) / 5);
    for (std::size_t i = first; i < surge.size(); i += 5) found.looked_at += surge[i] / looked_at;
    return found;
}

// `rest` is the load less all that is computed from the ice's side, so a share that were missing or counted twice would
// show in it.
TEST(TowWork, IsTheLoadToOnePercent) {
    const Found found = towed(packed());
    ASSERT_GT(found.mean, 5);
    EXPECT_LT(std::abs(found.work.rest), 0.01 * found.mean);
    EXPECT_NEAR(together(found.work), found.looked_at, 1e-9 * found.mean);
    for (const double loss : {found.work.ice_friction, found.work.hull_friction, found.work.ice_crushing,
                              found.work.vertical_drag, found.work.waves, found.work.lifting})
        EXPECT_GT(loss, 0);
}

// What the ice does on a structure that gives way, its moorings damp or store. Without this share, most of the load
// here would go nowhere.
TEST(TowWork, OfAMooredStructureIsTheLoadToo) {
    Scenario scenario = packed();
    scenario.moorings.mass = 300;
    scenario.moorings.surge = 300;
    scenario.moorings.damping = 0.5;
    scenario.moorings.free.fill(false);
    scenario.moorings.free[0] = true;
    const Found found = towed(scenario);
    ASSERT_GT(found.mean, 5);
    EXPECT_NEAR(together(found.work), found.looked_at, 1e-9 * found.looked_at);
    EXPECT_LT(std::abs(found.work.rest), 0.01 * found.mean);
    EXPECT_GT(found.work.giving_way, 0.03 * found.mean);
    EXPECT_EQ(towed(packed()).work.giving_way, 0);
}

TEST(TowWork, HasNoShareWithoutItsCause) {
    Scenario scenario = packed();
    scenario.contact.ice_structure_friction = 0;
    scenario.water.heave_damping_from = WaterFrom::share;
    scenario.water.heave_damping = 0;
    scenario.water.form_drag = scenario.water.skin_drag = 0;
    const WorkShares work = towed(scenario).work;
    EXPECT_EQ(work.hull_friction, 0);
    EXPECT_EQ(work.waves, 0);
    EXPECT_EQ(work.plane_drag, 0);
    EXPECT_GT(work.vertical_drag, 0);
    EXPECT_GT(work.ice_friction, 0);
}

TEST(TowWork, IsNothingBeforeTheWindow) {
    Scenario scenario = packed();
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    for (int i = 0; i < 10; ++i) simulation.step();
    EXPECT_EQ(together(simulation.work()), 0);
}

}  // namespace tow_work_test
}  // namespace floes
