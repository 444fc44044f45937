// Every contradiction with its exact sentence, and the borders that are none.

#include "scenario/validate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "support/sweeping_scenario.hpp"

namespace floes {
namespace validate_test {

using Change = std::function<void(Scenario&)>;

std::string sentence(const Change& change) {
    Scenario scenario = sweeping_scenario();
    change(scenario);
    const Contradictions found = find_contradictions(scenario);
    return found.empty() ? "consistent" : found.front().sentence;
}

void use_file(Scenario& s) {
    s.arrangement.method = ArrangementMethod::file;
    s.field.floes = 2;
    s.field.concentration = 0.01;  // 15 m
    s.structure.speed = 0.05;
    s.arrangement.poses = {{6.3, 0, 0}, {20.7, 2.1, 0}};
}

TEST(Validate, DefaultsAreConsistent) {
    EXPECT_EQ(sentence([](Scenario&) {}), "consistent");
}

TEST(Validate, EveryContradictionIsOneSentence) {
    const std::pair<Change, const char*> cases[] = {
        {[](Scenario& s) { s.floe.element = 0.25; },
         "floe.element_m = 0.25 does not divide floe.length_m = 0.6; the nearest side that does is 0.3"},
        {[](Scenario& s) { s.floe.breadth = 0.5; },
         "floe.element_m = 0.2 does not divide floe.breadth_m = 0.5; the nearest side that does is 0.166667"},
        {[](Scenario& s) { s.floe.element = 1.2; },
         "floe.element_m = 1.2 does not divide floe.length_m = 0.6; the nearest side that does is 0.6"},
        {[](Scenario& s) { s.floe.element = 0.001; },
         "floe.element_m = 0.001 with field.floes = 189 makes 6.804e+07 elements, more than the 1e+07 a member may "
         "have; take "
         "larger elements or fewer floes"},
        {[](Scenario& s) { s.ice.density = 1000; },
         "ice.density_kg_m3 = 1000.0 is not below water.density_kg_m3 = 1000.0, so the ice sinks; lower the ice's "
         "density"},
        {[](Scenario& s) { s.floe.thickness = 0.001; },
         "general.time_step_s = 0.02 is too long for ice.thickness_m = 0.001: floating ice heaves at 102.7 rad/s there "
         "and "
         "diverges; take a step below 0.01677"},
        {[](Scenario& s) {
             s.floe.thickness = 0.0033;
             s.water.heave_damping_from = WaterFrom::share;
             s.water.heave_damping = 1;
         },
         "general.time_step_s = 0.02 is too long for ice.thickness_m = 0.0033: floating ice heaves at 56.54 rad/s "
         "there "
         "and diverges; take a step below 0.01465"},
        {[](Scenario& s) {
             s.contact = {.friction = Friction::cone};
             s.general.solver = SolverKind::stock;
         },
         "contact.friction = \"cone\" is not possible with general.solver = \"stock\": Bullet's own solver "
         "bounds friction by a square; take general.solver = \"lanes\", or contact.preset = \"paper\""},
        {[](Scenario& s) {
             s.contact = {.normal = NormalLaw::crushing};
             s.general.solver = SolverKind::stock;
         },
         "contact.law = \"crushing\" is not possible with general.solver = \"stock\": Bullet's own solver has "
         "no "
         "contacts that crush; take general.solver = \"lanes\", or contact.law = \"rigid\""},
        {[](Scenario& s) {
             s.contact = {.internal_edges = false};
             s.general.solver = SolverKind::stock;
         },
         "paper.internal_edges = false is not possible with general.solver = \"stock\": Bullet's own solver "
         "does not know which faces lie inside a floe; take general.solver = \"lanes\", or paper.internal_edges = "
         "true"},
        {[](Scenario& s) { s.contact.ice_ice_friction = 0; },
         "contact.ice_ice_friction = 0.0 is not possible with contact.ice_structure_friction = 0.2: friction is a "
         "product of two materials, and without that of ice on ice there is none; take a small one such as "
         "contact.ice_ice_friction = 1e-6"},
        {[](Scenario& s) { s.general.time_step = 1e-6; },
         "general.time_step_s = 1e-06 with analysis.steady_start_s = 120.0 and analysis.window_s = 150.0 makes 2.7e+08 "
         "steps, "
         "more than the 2e+07 a run may have; take a longer step or a shorter run"},
        {[](Scenario& s) { s.analysis.steady_start = 80.01; },
         "analysis.steady_start_s = 80.01 is not a whole number of steps of general.time_step_s = 0.02; the nearest "
         "that is: "
         "80.02"},
        {[](Scenario& s) { s.analysis.window = 0.005; },
         "analysis.window_s = 0.005 is not a whole number of steps of general.time_step_s = 0.02; the nearest that is: "
         "0.02"},
        {[](Scenario& s) { s.analysis.segments = 7; },
         "analysis.segments = 7 does not cut analysis.window_s = 150.0 (7500 steps) into equal parts of at least 2 "
         "steps; take analysis.window_s = 149.94 or 150.08, or analysis.segments = 6"},
        {[](Scenario& s) {
             s.analysis.window = 20;
             s.analysis.history_stride = 50;
         },
         "analysis.segments = 3 does not cut analysis.window_s = 20.0 (1000 steps) into equal parts of at least 2 "
         "steps; take analysis.window_s = 18 or 21, or analysis.segments = 2"},
        {[](Scenario& s) { s.analysis.segments = 7500; },
         "analysis.segments = 7500 does not cut analysis.window_s = 150.0 (7500 steps) into equal parts of at least 2 "
         "steps; take analysis.window_s = 300, or analysis.segments = 3750"},
        {[](Scenario& s) {
             s.structure.shape = Shape({{0, 1}});
         },
         "structure.profile_m = [[0.0, 1.0]] is not a body; give at least two [height_m, radius_m] points"},
        {[](Scenario& s) {
             s.structure.shape = Shape({{-1, 1}, {1, 1}, {0.5, 1}});
         },
         "structure.profile_m = [[-1.0, 1.0], [1.0, 1.0], [0.5, 1.0]] has a height that falls; give the points from "
         "the keel "
         "up"},
        {[](Scenario& s) {
             s.structure.shape = Shape({{0, 1}, {1, 1}});
         },
         "structure.profile_m = [[0.0, 1.0], [1.0, 1.0]] does not span the waterline; give points below and above "
         "height 0"},
        {[](Scenario& s) {
             s.structure.shape = Shape({{-1, 1}, {0, 0}, {1, 0}});
         },
         "structure.profile_m = [[-1.0, 1.0], [0.0, 0.0], [1.0, 0.0]] has no radius at the waterline; make its radius "
         "at height "
         "0 greater than 0"},
        {[](Scenario& s) { s.general.runaway_speed = 0.07; },
         "structure.speed_m_s = 0.07 is not below general.runaway_speed_m_s = 0.07, so ice pushed by the structure "
         "would count "
         "as run away; raise the limit"},
        {[](Scenario& s) { s.field.half_width = 0.6; },
         "the structure's waterline radius of 0.614 m does not fit between the ice sheets at field.half_width_m = 0.6; "
         "widen "
         "the field or make the structure slimmer"},
        {[](Scenario& s) { s.structure.start = 5.5; },
         "structure.start_m = 5.5 puts the structure's waterline to x = 6.114 m, inside the ice that begins at "
         "field.begin_m = "
         "6.0; start before 5.386"},
        {[](Scenario& s) { s.structure.speed = 0.01; },
         "the tow never reaches the ice: with structure.start_m = 2.0 and structure.speed_m_s = 0.01 the structure's "
         "waterline "
         "ends at x = 5.314 m after 270 s, before field.begin_m = 6.0; start nearer, tow faster or longer"},
        {[](Scenario& s) { s.analysis.window = 300; },
         "the tow runs into the ice sheet at the far end: with structure.start_m = 2.0 and structure.speed_m_s = 0.07 "
         "the "
         "structure's waterline ends at x = 32.01 m after 420 s, past the field's end at 24.9 m; tow for a shorter "
         "time or take "
         "more floes"},
        {[](Scenario& s) {
             s.analysis.window = 300;
             s.field.far_end = FarEnd::open;
         },
         "the tow runs out of the ice: with structure.start_m = 2.0 and structure.speed_m_s = 0.07 the structure's "
         "waterline "
         "ends at x = 32.01 m after 420 s, past the field's end at 24.9 m; tow for a shorter time or take more floes"},
        {[](Scenario& s) {
             s.field.concentration = 0.95;
             s.analysis.window = 120;
         },
         "field.concentration_percent = 95.0 cannot hold field.floes = 189 with arrangement.clearance_m = 0.002: the "
         "field of "
         "14.92 m x 4.8 m has room for 7 rows of 24; lower the concentration or the clearance, or change the width so "
         "that "
         "whole rows fit"},
        {[](Scenario& s) { s.arrangement.clearance = 0.2; },
         "field.concentration_percent = 75.0 cannot hold field.floes = 189 with arrangement.clearance_m = 0.2: the "
         "field of "
         "18.9 m x 4.8 m has room for 5 rows of 23; lower the concentration or the clearance, or change the width so "
         "that whole "
         "rows fit"},
        {[](Scenario& s) { s.floe.thickness = 5; },
         "ice.thickness_m = 5.0 is more than the floe's side of 0.6 m, so that it would lie on its edge; a floe is a "
         "sheet. Take thinner ice or larger floes"},
        {[](Scenario& s) { s.ice.elastic_modulus = 0.3e6; },
         "ice.bending_strength_kPa = 36.4 is more than a tenth of ice.elastic_modulus_MPa = 0.3: such ice is rubber, "
         "and joints are elastic only as long as they turn little. Sea ice has some 500 kPa and 5000 MPa, model ice "
         "some 40 kPa and 60 MPa; mind that one is in kPa and the other in MPa"},
        {[](Scenario& s) { s.field.concentration = 0.0075; },
         "field.concentration_percent = 0.75 is less than 1 percent, a field of 1890 m almost without ice; write 75 "
         "for "
         "three quarters. For single floes in open water give their places: arrangement.method = \"file\""},
        {[](Scenario& s) { s.arrangement.clearance = 9; },
         "field.concentration_percent = 75.0 cannot hold field.floes = 189 with arrangement.clearance_m = 9.0: the "
         "field of "
         "18.9 m x 4.8 m has room for 0 rows of 1; lower the concentration or the clearance, or change the width so "
         "that whole "
         "rows fit"},
        {[](Scenario& s) {
             s.arrangement.poses = {{7, 0, 0}};
         },
         "arrangement.method = \"scattered\" does not use arrangement.poses; write arrangement.method = \"file\" or "
         "leave the "
         "poses out"},
        {[](Scenario& s) { s.arrangement.method = ArrangementMethod::file; },
         "arrangement.method = \"file\" needs poses; give arrangement.file or arrangement.poses"},
        {[](Scenario& s) {
             use_file(s);
             s.arrangement.poses.pop_back();
         },
         "field.floes = 2 is not the number of poses given, 1; make them agree"},
        {[](Scenario& s) {
             s.field.wake_radius = 3;
             s.contact = {};
             s.general.solver = SolverKind::stock;
         },
         "field.wake_radius_m = 3.0 is not possible with general.solver = \"stock\": Bullet's own solver lets no floes "
         "rest; take general.solver = \"lanes\", or field.wake_radius_m = 0"},
        {[](Scenario& s) { s.joint.model = JointModel::beam; },
         "joint.model = \"beam\" is not possible with general.solver = \"lanes\": joints as stiff as ice do not "
         "converge in sweeps; take general.solver = \"direct\", or joint.model = \"cfm\""},
        {[](Scenario& s) {
             s.contact.friction = Friction::one_direction;
             s.general.solver = SolverKind::direct;
         },
         "contact.friction = \"one_direction\" is not possible with general.solver = \"direct\": the direct solver has "
         "friction in the whole contact plane only; take contact.friction = \"cone\", or general.solver = "
         "\"lanes\" with joint.model = \"cfm\""},
        {[](Scenario& s) {
             s.contact.normal = NormalLaw::rigid;
             s.general.solver = SolverKind::direct;
         },
         "paper.split_impulse_depth_m = 0.04 is not possible with general.solver = \"direct\": the direct solver "
         "opens every penetration of rigid contacts within the impulse; take "
         "paper.split_impulse_depth_m = inf"},
        {[](Scenario& s) {
             s.field.far_end = FarEnd::never;
             s.water.current = 0.1;
         },
         "water.current_m_s = 0.1 does not go together with field.far_end = \"never\": ice ahead of the computed part "
         "rests and cannot drift; take 0, or a field with an end"},
        {[](Scenario& s) {
             s.field.far_end = FarEnd::never;
             s.field.confining = 40;
         },
         "field.confining_N_m = 40.0 does not go together with field.far_end = \"never\": no rigid sheet is as long as "
         "the field; take 0, or a field with an end"},
        {[](Scenario& s) {
             s.field.far_end = FarEnd::never;
             s.arrangement.method = ArrangementMethod::monte_carlo;
         },
         "arrangement.method = \"monte_carlo\" does not go together with field.far_end = \"never\", whose parts are "
         "laid beside one another without a seam; take \"scattered\", or a field with an end"},
        {[](Scenario& s) {
             s.field.far_end = FarEnd::never;
             s.arrangement.method = ArrangementMethod::scattered;
             s.arrangement.ordering_sweeps = 10;
         },
         "arrangement.ordering_sweeps = 10 would move floes that lie already, which field.far_end = \"never\" does not "
         "allow; take 0, or a field with an end"},
        {[](Scenario& s) {
             s.field.far_end = FarEnd::never;
             s.arrangement.method = ArrangementMethod::scattered;
             s.field.ahead = 1.5;
         },
         "field.ahead_m = 1.5 is 1.5 m, and the structure would strike floes at rest when they are nearer than the "
         "structure's radius and a floe's diagonal, 1.585 m; take more"},
        {[](Scenario& s) { s.field.wake_radius = 1.1; },
         "field.wake_radius_m = 1.1 lets the structure strike a floe at rest, whose middle may be 1.16 m from its axis "
         "then; take more than that, or 0 for none at rest"},
        {[](Scenario& s) { s.analysis.history_stride = 7; },
         "analysis.history_steps = 7 does not divide both the 6000 steps before the window and the 7500 in it, so "
         "that "
         "a value of the history would lie across its edge; take a divisor of both"},
        {[](Scenario& s) {
             s.analysis.exceedance_levels = {20, 50, 50};
         },
         "analysis.exceedance_levels_N = [20.0, 50.0, 50.0] does not rise from each to the next"},
        {[](Scenario& s) {
             s.general.solver = SolverKind::direct;
             s.joint.model = JointModel::beam;
             s.joint.failure = JointFailure::stress;
             s.joint.averaging = 10;
             s.general.time_step = 0.005;
         },
         "the stress at joints is averaged over 10 s, 2000 steps of general.time_step_s = 0.005, more than the 1000 "
         "that are kept; take longer steps or a shorter joint.averaging_s"},
        {[](Scenario& s) {
             s.analysis.averaging = {0.5, 0.1};
         },
         "analysis.averaging_s = [0.5, 0.1] does not rise from each to the next"},
        {[](Scenario& s) {
             s.analysis.averaging = {0.1, 0.25};
         },
         "analysis.averaging_s = [0.1, 0.25]: 0.25 s is not a whole number of steps of general.time_step_s = 0.02; the "
         "nearest that is: 0.26"},
        {[](Scenario& s) { s.analysis.averaging = {0.001}; },
         "analysis.averaging_s = [0.001]: 0.001 s is not a whole number of steps of general.time_step_s = 0.02; the "
         "nearest that is: 0.02"},
        {[](Scenario& s) { s.analysis.averaging = {51}; },
         "analysis.averaging_s = [51.0]: 51 s is longer than a segment of 50 s; take a shorter time"},
        {[](Scenario& s) {
             for (int k = 1; k <= 101; ++k) s.analysis.averaging.push_back(2 + k);
         },
         "analysis.averaging_s has 105 times, more than the 100 that a member takes"},
        {[](Scenario& s) {
             for (int k = 0; k <= 1000; ++k) s.analysis.exceedance_levels.push_back(k);
         },
         "analysis.exceedance_levels_N has 1001 levels, more than the 1000 that a member counts"},
    };
    for (const auto& [change, expected] : cases) EXPECT_EQ(sentence(change), expected);
}

// Whoever leaves the key alone gets what suits the rest.
TEST(AveragingTimes, OfTheDefaultAreThoseThatSuit) {
    Scenario scenario = sweeping_scenario();
    EXPECT_EQ(scenario.averaging_times(), (std::vector{0.1, 0.5, 1.0, 2.0}));
    scenario.general.time_step = 0.025;
    EXPECT_EQ(scenario.averaging_times(), (std::vector{0.1, 0.5, 1.0, 2.0}));
    scenario.general.time_step = 0.04;
    EXPECT_EQ(scenario.averaging_times(), (std::vector{1.0, 2.0}));
    EXPECT_EQ(sentence([](Scenario& s) { s.general.time_step = 0.04; }), "consistent");
    scenario.analysis.segments = 150;
    EXPECT_EQ(scenario.averaging_times(), (std::vector{1.0}));
    scenario.analysis.averaging = {0.2};
    EXPECT_EQ(scenario.averaging_times(), (std::vector{0.2}));
}

TEST(Validate, BordersAreConsistent) {
    EXPECT_EQ(sentence([](Scenario& s) { s.contact.ice_ice_friction = s.contact.ice_structure_friction = 0; }),
              "consistent");
    EXPECT_EQ(sentence(use_file), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.segments = 3750; }), "consistent");  // parts of exactly 2 steps
    EXPECT_EQ(sentence([](Scenario& s) { s.floe.element = 0.6; }), "consistent");        // one element a floe
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.steady_start = 0; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.field.wake_radius = 1.17; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.field.far_end = FarEnd::never;
                  s.arrangement.method = ArrangementMethod::scattered;
                  s.analysis.window = 36000;  // ten hours
              }),
              "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.history_stride = 500; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.analysis.history_stride = 3;
                  s.analysis.keep_history = false;
              }),
              "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.exceedance_levels = {0, 50}; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.averaging = {0.02, 50}; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.analysis.averaging = {}; }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.structure.shape = Shape({{-1, 0.2}, {0, 0.3}, {0, 0.5}, {1, 0.6}});
              }),
              "consistent");
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.structure.start = 5.386;
                  s.analysis.window = 120;
              }),
              "consistent");
}

TEST(Validate, VoronoiCellsNeedNoLattice) {
    const auto dense = [](ShapeKind kind) {
        Scenario scenario;
        scenario.shapes.kind = kind;
        scenario.field.concentration = 0.92;
        scenario.analysis.window = 60;
        std::string all;
        for (const Contradiction& one : find_contradictions(scenario)) all += one.sentence;
        return all;
    };
    EXPECT_EQ(dense(ShapeKind::voronoi), "");
    EXPECT_THAT(dense(ShapeKind::rectangle), testing::HasSubstr("cannot hold field.floes = 189"));
}

TEST(Validate, SingleFloesInOpenWaterMayHaveColumns) {
    EXPECT_EQ(sentence([](Scenario& s) {
                  use_file(s);
                  s.field.concentration = 0.005;
                  s.arrangement.columns = "ice.thickness_m";
                  s.arrangement.values = {{0.03}, {0.04}};
              }),
              "consistent");
}

TEST(Validate, AllFloesAverageTheStressOverOneTime) {
    EXPECT_THAT(sentence([](Scenario& s) {
                    use_file(s);
                    s.arrangement.columns = "joint.averaging_s";
                    s.arrangement.values = {{0.03}, {0.04}};
                }),
                testing::HasSubstr("no such number"));
}

TEST(Validate, TheBedIsBelowTheThickestFloe) {
    const auto over = [](double thickest) {
        return sentence([=](Scenario& s) {
            use_file(s);
            s.water.depth = 0.5;
            s.arrangement.columns = "ice.thickness_m";
            s.arrangement.values = {{0.03}, {thickest}};
        });
    };
    EXPECT_EQ(over(0.04), "consistent");
    EXPECT_THAT(over(0.6), testing::HasSubstr("is to float at the start"));
}

TEST(Validate, FirstKeyNamedIsAKey) {
    Scenario scenario = sweeping_scenario();
    scenario.floe.element = 0.25;
    scenario.analysis.segments = 7;
    const std::vector<Contradiction> found = find_contradictions(scenario);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].keys, (std::vector<std::string>{"floe.element_m", "floe.length_m"}));
    EXPECT_EQ(found[1].keys.front(), "analysis.segments");
}

}  // namespace validate_test
}  // namespace floes
