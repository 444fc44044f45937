#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "support/default_scenes.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace saved_state_test {

/// A scene, and the steps after which it is saved; it ends some steps behind the last.
struct SavedScene {
    std::string name;
    Scenario scenario;
    std::vector<int> saved_after;
    std::uint32_t arrangement = 0;

    Simulation begun() const {
        LaidField laid = lay_field(scenario, 1, arrangement);
        return {scenario, laid.laid(), std::move(laid.ahead)};
    }
    friend void PrintTo(const SavedScene& scene, std::ostream* out) { *out << scene.name; }
};

constexpr int steps_behind = 60;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same_frame(const Simulation& a, const Simulation& b) {
    Frame one;
    Frame other;
    a.read_frame(one);
    b.read_frame(other);
    EXPECT_TRUE(same_bits(one.pieces, other.pieces));
    EXPECT_TRUE(same_bits(one.utilisation, other.utilisation));
    ASSERT_EQ(one.contacts.size(), other.contacts.size());
    for (std::size_t i = 0; i < one.contacts.size(); ++i) {
        EXPECT_EQ(one.contacts[i].point, other.contacts[i].point);
        EXPECT_EQ(one.contacts[i].normal, other.contacts[i].normal);
    }
}

void expect_same_run(const Simulation& a, const Simulation& b) {
    ASSERT_EQ(a.steps(), b.steps());
    for (const auto& history : load_histories)
        EXPECT_TRUE(same_bits(a.loads().*history.values, b.loads().*history.values));
    for (const auto& history : motion_histories)
        EXPECT_TRUE(same_bits(a.motions().*history.values, b.motions().*history.values));
    EXPECT_EQ(a.ice().breaks(), b.ice().breaks());
    EXPECT_EQ(a.ice().peaks(), b.ice().peaks());
    EXPECT_EQ(a.ice().fracture_work(), b.ice().fracture_work());
    EXPECT_EQ(a.ice().pieces(), b.ice().pieces());
    EXPECT_EQ(a.ice().split_floes(), b.ice().split_floes());
    EXPECT_EQ(a.ice().cracked_floes(), b.ice().cracked_floes());
    EXPECT_EQ(a.mean_sweeps(), b.mean_sweeps());
    EXPECT_EQ(a.floes_entered(), b.floes_entered());
    EXPECT_EQ(a.floes_met(), b.floes_met());
    EXPECT_EQ(a.floes_met_broken(), b.floes_met_broken());
    EXPECT_EQ(a.floes_resting(), b.floes_resting());
    EXPECT_EQ(a.fallen_astern().area, b.fallen_astern().area);
    EXPECT_EQ(a.load_map(), b.load_map());
    EXPECT_EQ(a.hull_loads().yaw().sd, b.hull_loads().yaw().sd);
    for (const auto share : all_work_shares) EXPECT_EQ(a.work().*share, b.work().*share);
    ASSERT_EQ(a.element_states().size(), b.element_states().size());
    EXPECT_TRUE(same_bits(a.element_states(), b.element_states()));
    EXPECT_TRUE(same_bits(a.sheets(), b.sheets()));
    if (a.structure().moored()) {
        EXPECT_TRUE(same_bits(a.structure().moored()->largest_tensions(), b.structure().moored()->largest_tensions()));
    }
    expect_same_frame(a, b);
}

class SavedState : public ::testing::TestWithParam<SavedScene> {};

// The tow that is set goes on, is saved and set again, and ends as the one that never stopped.
TEST_P(SavedState, GoesOnWithTheSameBits) {
    const SavedScene& scene = GetParam();
    Simulation whole = scene.begun();
    Simulation resumed = scene.begun();
    for (const int after : scene.saved_after) {
        while (whole.steps() < after) whole.step();
        while (resumed.steps() < after) resumed.step();
        const Bytes saved = resumed.saved();
        EXPECT_TRUE(whole.saved() == saved) << "after step " << after;
        resumed = scene.begun();
        resumed.set(saved);
        EXPECT_TRUE(resumed.saved() == saved) << "after step " << after;
    }
    for (int i = 0; i < steps_behind; ++i) {
        whole.step();
        resumed.step();
    }
    expect_same_run(whole, resumed);
}

/// The whole run is in the window, so that all is measured from the first step.
Scenario in_window_at_once(Scenario scenario) {
    scenario.analysis.window += scenario.analysis.steady_start;
    scenario.analysis.steady_start = 0;
    return scenario;
}

std::vector<SavedScene> saved(const std::vector<DefaultScene>& scenes) {
    std::vector<SavedScene> all;
    for (const DefaultScene& scene : scenes) {
        const Scenario scenario = in_window_at_once(scene.scenario());
        const auto there = static_cast<int>(scene.time / scenario.general.time_step);
        all.push_back({scene.name, scenario, {0, 1, there / 3, there}, scene.arrangement});
    }
    return all;
}

/// What the default does not have.
std::vector<DefaultScene> others() {
    return {
        {"lanes", "table3_physical.toml", "", 20},
        {"sheets_that_give_way", "gallery/under_pressure.toml", "", 12},
        {"wind_and_current", "gallery/drifting.toml", "", 12},
        {"parts_of_a_hull", "gallery/four_legs.toml", "", 12},
        {"turning", "gallery/turning_drift.toml", "", 12},
        {"heaving", "floating.toml", "heave", 20},
        {"cracks", "gallery/tough_ice.toml", "", 16},
        {"asleep", "smoke.toml", "E60", 20, {"field.wake_radius_m=2.0"}},
        {"turret",
         "kulluk.toml",
         "",
         60,
         {"moorings.turret=true", "moorings.turret_m=30.0", "moorings.turret_friction_kN_m=500.0"}},
    };
}

const auto name_of = [](const auto& scene) { return scene.param.name; };

INSTANTIATE_TEST_SUITE_P(OfTheDefault, SavedState, ::testing::ValuesIn(saved(default_scenes())), name_of);
INSTANTIATE_TEST_SUITE_P(OfOthers, SavedState, ::testing::ValuesIn(saved(others())), name_of);

Scenario short_tow(SolverKind solver) {
    Scenario scenario = sweeping_scenario();
    scenario.general.solver = solver;
    if (solver == SolverKind::stock) scenario.contact = {};
    scenario.field.floes = 2;
    scenario.field.concentration = 0.05;
    return scenario;
}

const std::vector<PlanarPose> two{{5.3, 0.1, 0.3}, {6.2, -0.2, 0.9}};

// Which bays a pattern of cells meets decides into how many elements it cuts a floe.
TEST(SavedStateOfFloesWithBays, HasTheWaterOfEveryElement) {
    Scenario scenario = in_window_at_once(short_tow(SolverKind::direct));
    scenario.joint.model = JointModel::beam;
    scenario.water.added_mass_from = WaterFrom::outline;
    scenario.shapes.kind = ShapeKind::file;
    for (const double arm : {0.11, 0.17, 0.23}) {  // stars
        Outline& star = scenario.shapes.traced.outlines.emplace_back();
        for (int k = 0; k < 10; ++k) {
            const double radius = k % 2 == 0 ? 0.5 : arm;
            star.push_back(
                {0.5 + radius * std::cos(0.2 * std::numbers::pi * k), radius * std::sin(0.2 * std::numbers::pi * k)});
        }
    }
    scenario.field.floes = 16;
    scenario.floe.element = 0.12;
    scenario.elements.form = ElementForm::cells;
    const FloeSet floes = make_arrangement(scenario, 1, 0);
    double elements = 0;
    for (std::size_t i = 0; i < floes.size(); ++i)
        elements += static_cast<double>(floes.shape(i).cut().elements.size());
    ASSERT_NE(elements, element_count(floes)) << "patterns cut alike";
    Simulation tow(scenario, floes);
    for (int i = 0; i < 3; ++i) tow.step();
    Simulation set(scenario, floes);
    set.set(tow.saved());
    EXPECT_TRUE(set.saved() == tow.saved());
    tow.step();
    set.step();
    expect_same_run(tow, set);
}

TEST(SavedStateOfAnother, IsRefused) {
    const Scenario scenario = short_tow(SolverKind::lanes);
    Simulation tow(scenario, floes_at(scenario, two));
    for (int i = 0; i < 3; ++i) tow.step();
    Bytes bytes = tow.saved();
    Simulation other(scenario, floes_at(scenario, std::span(two).first(1)));
    EXPECT_THROW(other.set(bytes), RunError);
    for (const std::size_t left : {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1}) {
        Simulation same(scenario, floes_at(scenario, two));
        EXPECT_THROW(same.set(std::span(bytes).first(left)), RunError) << left;
    }
    bytes.push_back({});
    Simulation same(scenario, floes_at(scenario, two));
    EXPECT_THROW(same.set(bytes), RunError);
}

TEST(SavedStateOfBullet, DoesNotExist) {
    const Scenario scenario = short_tow(SolverKind::stock);
    Simulation tow(scenario, floes_at(scenario, two));
    EXPECT_FALSE(tow.can_be_saved());
    EXPECT_THROW(static_cast<void>(tow.saved()), RunError);
}

}  // namespace saved_state_test
}  // namespace floes
