// Paths and moorings that cannot be simulated, each with its sentence; and keys that leave digests alone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace motion_test {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

std::string sentence(const std::function<void(Scenario&)>& change) {
    Scenario scenario;
    scenario.structure.start = 2;
    scenario.moorings = {.mass = 500, .gyration = 0.4, .surge = 600, .sway = 600, .yaw = 60};
    change(scenario);
    const Contradictions found = find_contradictions(scenario);
    return found.empty() ? "consistent" : found.front().sentence;
}

MooringLine line() {
    return {.x = 0.5, .distance = 20, .pretension = 10, .stiffness = 500, .break_load = 100};
}

TEST(Motion, MooringsThatHoldAreConsistent) {
    EXPECT_EQ(sentence([](Scenario&) {}), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.moorings.lines.push_back(line()); }), "consistent");
    EXPECT_EQ(sentence([](Scenario& s) { s.moorings = {}; }), "consistent");
}

// What the window of computed floes has left behind does not come back: 4.8 m behind the farthest place, less the
// structure's radius and a floe's diagonal.
TEST(Motion, WaysThroughAFieldWithoutEndComeBackByNoMoreThanWhatIsStillThere) {
    const auto endless = [](const Path& path, const Moorings& moorings = {}) {
        return sentence([&](Scenario& s) {
            s.field.far_end = FarEnd::never;
            s.arrangement.method = ArrangementMethod::scattered;
            s.path = path;
            s.moorings = moorings;
        });
    };
    Scenario usual;
    usual.field.far_end = FarEnd::never;
    const double room = usual.window_behind() - window_least(usual);
    ASSERT_GT(room, 2);
    const auto back_by = [](double way) { return Path{.legs = {{0, 0.1, 100, 0}, {pi, 0.1, 10 * way, 0}}}; };
    EXPECT_EQ(endless({}), "consistent");
    EXPECT_EQ(endless({}, {.mass = 500, .gyration = 0.4, .surge = 600, .sway = 600, .yaw = 60}), "consistent");
    EXPECT_EQ(endless({.legs = {{0, 0.5, 300, 0}}}), "consistent") << "farther than any closed field";
    EXPECT_EQ(endless({.legs = {{-0.01, 0.07, 100, 0.0002}, {0, 0, 50, 0}, {0, 0.07, 200, 0}}}), "consistent");
    EXPECT_EQ(endless(back_by(room - 0.01)), "consistent");
    EXPECT_THAT(
        endless(back_by(room + 0.01)),
        HasSubstr("and with field.far_end = \"never\" floes more than 4.8 m behind the farthest place that it has "
                  "been to are gone, so"));
    EXPECT_THAT(endless({.legs = {{pi, 0.1, 10, 0}, {0, 0.1, 200, 0}}}),
                HasSubstr("it has to stay ahead of structure.start_m = 2.0; begin with a leg along +x"));
    EXPECT_THAT(endless({.legs = {{0.1, 0.1, 200, 0}}}), HasSubstr("into the bank"));
    EXPECT_THAT(endless({.legs = {{0, 400, 300, 0}}}), HasSubstr("the path moves the structure's wall at 400 m/s"));
}

TEST(Motion, MooringsThatDoNotHoldAreRefused) {
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.sway = 0; }),
                HasSubstr("nothing holds the structure in sway; give a stiffness, lines or thrusters"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.surge = 1e6; }),
                HasSubstr("natural period in surge is 0.1405 s, fewer than 50 steps of general.time_step_s = 0.02"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.gyration = 0; }), HasSubstr("leaves nothing to turn"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.mass = 50; }),
                HasSubstr("moorings.mass_t = 0.05 and the water that moves with it are 4.526 times the heaviest floe"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.moorings.lines.push_back(line());
                    s.moorings.lines[0].break_load = 5;
                }),
                HasSubstr("moorings.lines[0] breaks at 0.005 kN, below its pretension of 0.01 kN"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.moorings.lines.push_back(line());
                    s.moorings.curve = {{0, 0}, {1, 500}};
                }),
                HasSubstr("moorings.lines[0] has a stiffness beside moorings.line_curve"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.curve = {{0, 0}, {1, 500}}; }), HasSubstr("there are none"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.moorings.lines.push_back(line());
                    s.moorings.lines[0].stiffness = 0;
                    s.moorings.curve = {{0, 0}, {1, 500}, {2, 400}};
                }),
                HasSubstr("moorings.line_curve[2] does not have more extension and more tension"));
}

TEST(Motion, HullsThatCannotFloatAreRefused) {
    const auto floating = [](const std::function<void(Scenario&)>& change) {
        return sentence([&](Scenario& s) {
            s.moorings.free = {true, true, true, true, true, true};
            s.moorings.pitch_gyration = s.moorings.roll_gyration = 0.4;
            s.moorings.height = -0.3;
            change(s);
        });
    };
    EXPECT_EQ(floating([](Scenario&) {}), "consistent");
    EXPECT_THAT(floating([](Scenario& s) { s.moorings.height = 0.5; }),
                HasSubstr("the hull does not float upright: with its centre at moorings.centre_m = 0.5, in pitch its "
                          "weight turns it over"));
    EXPECT_THAT(floating([](Scenario& s) {
                    s.moorings.height = 0;
                    s.moorings.roll_gyration = 0;
                }),
                HasSubstr("moorings.gyration_roll_m = 0 leaves nothing to turn; give the radius of gyration, or take a "
                          "moorings.free without \"roll\""));
    EXPECT_THAT(floating([](Scenario& s) { s.moorings.free = {}; }), HasSubstr("holds the structure in all motions"));
    const auto with = [&](int row, int column, double tonnes) {
        return floating([&](Scenario& s) {
            s.moorings.added_mass.assign(6, std::vector<double>(6, 0.0));
            s.moorings.added_mass[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = 1000 * tonnes;
        });
    };
    EXPECT_EQ(with(2, 2, 0.3), "consistent");
    EXPECT_THAT(with(2, 2, -1), HasSubstr("mass and added mass together are -0.5 t in heave; they have to be above 0"));
    EXPECT_THAT(with(0, 4, 1), HasSubstr("moorings.added_mass[4][0] and [0][4] differ, 0 and 1; such a matrix is"));
    EXPECT_THAT(floating([](Scenario& s) { s.moorings.added_mass.assign(5, std::vector<double>(6, 0.0)); }),
                HasSubstr("moorings.added_mass has 5 rows of six"));
    EXPECT_THAT(
        floating([](Scenario& s) {
            s.moorings.radiation_damping.assign(6, std::vector<double>(6, 0.0));
            s.moorings.radiation_damping[2][2] = -100;
        }),
        HasSubstr("moorings.radiation_damping[2][2] is -0.1, which would drive that motion on; give 0 or more"));
    const auto hangs = [&](double depth, double length, double breaks) {
        return floating([&](Scenario& s) {
            s.moorings.hanging.push_back({.fairlead = {0.5, -0.2, 0},
                                          .distance = 3,
                                          .depth = depth,
                                          .cable = {length, 10, 1e5, 0},
                                          .break_load = breaks});
        });
    };
    EXPECT_EQ(hangs(1, 3.2, 0), "consistent");
    EXPECT_THAT(hangs(0.1, 3.2, 0), HasSubstr("moorings.hanging_lines[0] has its fairlead 0.1 m below its anchor"));
    EXPECT_THAT(hangs(1, 2, 0), HasSubstr("is 2 m long and would be stretched to 3.105 m"));
    EXPECT_THAT(hangs(1, 3.2, 1), HasSubstr("at rest, more than its break load"));
}

TEST(Motion, ThrustersAndTurretsThatCannotBeAreRefused) {
    EXPECT_EQ(sentence([](Scenario& s) {
                  s.moorings.surge = s.moorings.sway = s.moorings.yaw = 0;
                  s.moorings.thrusters = {.gain = {600, 600, 60}, .limit = {50, 50, 0}};
              }),
              "consistent")
        << "thrusters alone hold it";
    EXPECT_EQ(sentence([](Scenario& s) { s.moorings.turret.curve = {{0, 0}, {0.1, 50}}; }), "consistent");
    const auto on_turret = [](double ahead) {
        return [ahead](Scenario& s) {
            s.moorings.surge = s.moorings.sway = s.moorings.yaw = 0;
            s.moorings.turret = {.curve = {{0, 0}, {0.1, 50}}, .ahead = ahead};
        };
    };
    EXPECT_EQ(sentence(on_turret(0.3)), "consistent") << "the load rights it";
    for (const double ahead : {0.0, -0.3})
        EXPECT_THAT(sentence(on_turret(ahead)), HasSubstr("nothing rights the structure in yaw")) << ahead;
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.turret.lines = true; }), HasSubstr("and there are none"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.thrusters.limit[1] = 50; }),
                HasSubstr("moorings.dp_sway_limit_kN = 0.05 limits thrusters that moorings.dp_sway_kN_m = 0 leaves "
                          "out; give both or neither"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.thrusters.gain[0] = 1e9; }),
                HasSubstr("natural period in surge"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.turret.curve = {{0, 0}}; }), HasSubstr("is the only row"));
    EXPECT_THAT(sentence([](Scenario& s) { s.moorings.turret.curve = {{0, 5}, {1, 50}}; }), HasSubstr("is not [0, 0]"));
    EXPECT_THAT(sentence([](Scenario& s) {
                    s.moorings.turret.curve = {{0, 0}, {1, 50}, {2, 50}};
                }),
                HasSubstr("moorings.turret_curve[2] does not have more offset and more force"));
}

std::string path_sentence(
    const Path& path, const std::function<void(Scenario&)>& change = [](Scenario&) {}) {
    return sentence([&](Scenario& s) {
        s.moorings = {};
        s.path = path;
        change(s);
    });
}

TEST(Motion, PathsAreRefusedWhereTheyCannotGo) {
    EXPECT_EQ(path_sentence({.legs = {{0, 0.07, 270, 0}}}), "consistent");
    EXPECT_EQ(path_sentence({.legs = {{0.02, 0.07, 100, 0}, {0, 0, 10, 0}, {-0.02, 0.05, 200, 0}}, .ramp = 5}),
              "consistent");
    EXPECT_THAT(path_sentence({.legs = {{pi / 2, 0.07, 270, 0}}}),
                HasSubstr("into the bank at field.half_width_m = 2.4; turn earlier or widen the field"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.2, 270, 0}}}), HasSubstr("the path leaves the channel: after "));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 100, 0}, {pi, 0.07, 150, 0}}}), HasSubstr("leaves the channel"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.001, 270, 0}}}), HasSubstr("the path never reaches the ice"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 270, 0}}}, [](Scenario& s) { s.structure.start = 5.6; }),
                HasSubstr("inside the ice that begins at field.begin_m"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 10, 0}, {0.1, 0.07, 260, 0}}, .ramp = 20}),
                HasSubstr("path.ramp_s = 20.0 is longer than the shortest leg, 10 s"));
    EXPECT_THAT(path_sentence({.table = {{0, 0, 0, 0}, {10, 5, 0, 0}, {9, 6, 0, 0}}}),
                HasSubstr("path.places[2] is at 9 s, not after the row before at 10 s; times have to rise"));
    EXPECT_THAT(path_sentence({.table = {{1, 0, 0, 0}, {10, 5, 0, 0}}}), HasSubstr("is not at time 0 at the start"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 270, 0}}, .table = {{0, 0, 0, 0}}}), HasSubstr("are two paths"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 100, 0}, {2.5 * pi, 0.07, 170, 0}}}),
                HasSubstr("path.legs[1] turns from 0 to 450 degrees, and turns go the shorter way, never by more than "
                          "180; let a leg turn by its turn_deg_s for more"));
    EXPECT_EQ(path_sentence({.legs = {{0, 0.07, 100, 0}, {0, 0, 100, 0.04 * pi}, {0, 0.07, 70, 0}}}), "consistent")
        << "after two turns on the spot";
    EXPECT_THAT(path_sentence({.table = {{0, 0, 0, 0}, {100, 7, 0, -4 * pi}, {270, 18, 0, 0}}}),
                HasSubstr("path.places[1] turns from 0 to -720 degrees, and turns go the shorter way, never by more "
                          "than 180; put rows between them for more"));
    EXPECT_THAT(path_sentence({.table = {{0, 0, 0, 0}, {200, 14, 0, 0}, {200.02, 14, 0, 3}}}),
                HasSubstr("give turns time"));
    EXPECT_THAT(path_sentence({.legs = {{0, 0.07, 270, 0}}, .bow = PathBow::ahead},
                              [](Scenario& s) {
                                  s.moorings = {.mass = 500, .gyration = 0.4, .surge = 600, .sway = 600, .yaw = 60};
                              }),
                HasSubstr("would turn the moorings with the heading"));
}

/// Wider than long, so that it reaches farther ahead where it begins across the tow.
TEST(Motion, AHullThatBeginsTurnedMayNotBeginInTheIce) {
    const auto begin = [](double yaw) {
        return path_sentence({.table = {{0, 0, 0, yaw}, {270, 18, 0, yaw}}}, [](Scenario& s) {
            s.structure.shape =
                Shape(HullKind::barge, {.length = 0.4, .beam = 1, .draught = 0.2, .freeboard = 0.1, .stem = pi / 3});
            s.structure.start = s.field.begin - 0.3;
        });
    };
    EXPECT_EQ(begin(0), "consistent");
    EXPECT_THAT(begin(pi / 2), HasSubstr("inside the ice that begins at field.begin_m"));
}

/// A blow at the end of a hull that may turn meets M/(1 + r²/k²), through the middle M.
TEST(Motion, ABlowMeetsTheMassThatAnswersIt) {
    constexpr double gyration = 0.3;
    Scenario scenario;
    scenario.structure.shape =
        Shape(HullKind::barge, {.length = 1.6, .beam = 0.4, .draught = 0.2, .freeboard = 0.1, .stem = pi / 3});
    scenario.moorings = {.mass = 500, .gyration = gyration, .surge = 600, .sway = 600, .yaw = 60};
    const double whole = structure_over_floe(scenario);
    EXPECT_NEAR(struck_over_floe(scenario), whole / (1 + 0.8 * 0.8 / (gyration * gyration)), 1e-9 * whole);
    scenario.moorings.free = {true, true, false, false, false, false};
    EXPECT_NEAR(struck_over_floe(scenario), whole, 1e-9 * whole);
    scenario.moorings.free = {true, true, true, false, false, false};
    scenario.structure.shape = Shape();
    EXPECT_NEAR(struck_over_floe(scenario), whole, 1e-9 * whole) << "a round wall is met through its axis";
}

TEST(Motion, UnusedKeysAreInNoDigest) {
    Scenario scenario;
    const std::string before = canonical_text(scenario);
    EXPECT_EQ(before.find("moorings"), std::string::npos);
    EXPECT_EQ(before.find("path"), std::string::npos);
    scenario.moorings.surge = 600;  // without a mass it has no effect
    scenario.path.ramp = 4;
    EXPECT_EQ(canonical_text(scenario), before);
    scenario.moorings.mass = 500;
    EXPECT_THAT(canonical_text(scenario), HasSubstr("moorings.surge_kN_m"));
}

}  // namespace motion_test
}  // namespace floes
