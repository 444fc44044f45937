// Each rule by which a field lays itself, in closed form, and what leaves a scenario as it is.

#include "scenario/layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenario/floes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace layout_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

OpenKeys all() {
    return OpenKeys().set();
}

OpenKeys but(std::initializer_list<LaidKey> stated) {
    OpenKeys open = all();
    for (const LaidKey key : stated) open.reset(static_cast<std::size_t>(key));
    return open;
}

/// A cone of 70 m, 81 m over all, among floes of 40 m x 20 m: mean side √800 m, diagonal √2000 m.
Scenario cone() {
    Scenario scenario;
    scenario.general.time_step = 0.1;
    scenario.structure.shape = Shape({{-11.5, 25.2}, {0, 35}, {3.3, 40.5}});
    scenario.structure.speed = 0.5;
    scenario.floe.length = 40;
    scenario.floe.breadth = 20;
    scenario.floe.element = 5;
    scenario.floe.thickness = 1;
    scenario.ice.elastic_modulus = 5e9;
    scenario.field.far_end = FarEnd::never;
    return scenario;
}

/// 150 m long, 28 m wide.
Scenario ship() {
    Scenario scenario = cone();
    HullSizes sizes;
    sizes.length = 150;
    sizes.beam = 28;
    sizes.draught = 9;
    sizes.freeboard = 8;
    sizes.entrance = 35 * std::numbers::pi / 180;
    sizes.stem = 0.5 * std::numbers::pi;
    scenario.structure.shape = Shape(HullKind::drillship, sizes);
    return scenario;
}

/// With a period of 25 s in surge and sway and of 20 s in yaw.
void moor(Scenario& scenario) {
    Moorings& moorings = scenario.moorings;
    moorings.mass = 2.8e7;
    moorings.gyration = 25;
    const double stiffness = moorings.mass * std::pow(2 * std::numbers::pi / 25, 2);
    moorings.surge = moorings.sway = stiffness;
    moorings.yaw = moorings.mass * 25 * 25 * std::pow(2 * std::numbers::pi / 20, 2);
}

LaidReasons lay_one(Scenario& scenario, OpenKeys open) {
    Unlaid one{&scenario, open};
    lay({&one, 1});
    return one.laid;
}

Scenario laid(Scenario scenario, OpenKeys open = all()) {
    lay_one(scenario, open);
    return scenario;
}

std::string reason(const Scenario& scenario, LaidKey key, OpenKeys open = all()) {
    Scenario copy = scenario;
    return lay_one(copy, open)[key];
}

TEST(Layout, OfTheConeInClosedForm) {
    const Scenario scenario = laid(cone());
    EXPECT_DOUBLE_EQ(scenario.field.sheet_width, 45);  // √2000 = 44.7
    EXPECT_DOUBLE_EQ(scenario.field.begin, 0);
    EXPECT_DOUBLE_EQ(scenario.structure.start, -61);        // 40.5 + 20 = 60.5
    EXPECT_DOUBLE_EQ(scenario.analysis.steady_start, 370);  // (20.5 + 81 + 80) / 0.5 = 363
    EXPECT_DOUBLE_EQ(scenario.analysis.window, 3 * 330);    // 2 · 81 / 0.5 = 324 each
    EXPECT_DOUBLE_EQ(scenario.field.half_width, 130);       // 40.5 + 81 = 121.5
    EXPECT_DOUBLE_EQ(scenario.field.ahead, 210);            // 40.5 + 2 · 81 = 202.5
    EXPECT_DOUBLE_EQ(scenario.field.behind, 130);           // 40.5 + √2000 + 40 = 125.2
    EXPECT_EQ(scenario.field.floes, 83);                    // 0.75 · 260 · 340 / 800 = 82.9
    EXPECT_EQ(scenario.analysis.segments, 3);
    EXPECT_THAT(find_contradictions(scenario), IsEmpty());
}

TEST(Layout, SaysWhy) {
    EXPECT_EQ(reason(cone(), LaidKey::sheet_width), "the diagonal of the largest floe, 44.72 m");
    EXPECT_EQ(reason(cone(), LaidKey::begin), "x = 0 is where the ice begins");
    EXPECT_EQ(reason(cone(), LaidKey::start),
              "the bow, 40.5 m ahead of the axis, is half a floe of 40 m before the ice");
    EXPECT_EQ(reason(cone(), LaidKey::steady_start),
              "ice lies along the hull of 81 m and two floes of 40 m more, 181.5 m on");
    EXPECT_EQ(reason(cone(), LaidKey::window), "three times two breadths of the hull, 162 m, at 0.5 m/s");
    EXPECT_EQ(reason(cone(), LaidKey::half_width),
              "the hull reaches 40.5 m aside, and beside it is its breadth of 81 m");
    EXPECT_EQ(reason(cone(), LaidKey::ahead), "the hull reaches 40.5 m, and two breadths of it, 162 m, ahead");
    EXPECT_EQ(reason(cone(), LaidKey::behind), "the hull and the floes about it reach 85.22 m, and a floe more");
    EXPECT_EQ(reason(cone(), LaidKey::floes), "a part as long as the 340 m that are computed");
    EXPECT_EQ(reason(cone(), LaidKey::segments), "");
}

TEST(Layout, ASlenderHullHasRoomByItsFloes) {
    const Scenario scenario = laid(ship());
    EXPECT_DOUBLE_EQ(scenario.structure.start, -95);        // 75 + 20
    EXPECT_DOUBLE_EQ(scenario.field.half_width, 94);        // 14 + 2 · 40
    EXPECT_DOUBLE_EQ(scenario.field.ahead, 200);            // 76 + 3 · 40 = 196, of the corners at the stern
    EXPECT_DOUBLE_EQ(scenario.analysis.steady_start, 500);  // (20 + 150 + 80) / 0.5
    EXPECT_DOUBLE_EQ(scenario.analysis.window, 3 * 290);    // 5 · √800 / 0.5 = 282.8
    EXPECT_THAT(find_contradictions(scenario), IsEmpty());
}

TEST(Layout, WindowsHoldTenNaturalPeriods) {
    Scenario scenario = cone();
    moor(scenario);
    scenario.structure.speed = 5;
    const Scenario fast = laid(scenario);
    EXPECT_DOUBLE_EQ(fast.analysis.window, 3 * 84);     // 250 / 3 = 83.3
    EXPECT_DOUBLE_EQ(fast.analysis.steady_start, 130);  // 20.5 / 5 + 5 · 25 = 129.1
    EXPECT_EQ(reason(scenario, LaidKey::window), "10 natural periods of 25 s in surge");
    EXPECT_EQ(reason(scenario, LaidKey::steady_start),
              "the bow meets the ice, and then 5 natural periods of 25 s in surge");
    scenario.moorings.damping = 0.3;
    EXPECT_DOUBLE_EQ(laid(scenario).analysis.steady_start, 44);  // 4.1 + 3 · 25 / (2 π 0.3) = 43.9
    EXPECT_THAT(reason(scenario, LaidKey::steady_start), HasSubstr("1.6 natural periods of 25 s in surge, in which"));
}

TEST(Layout, AFieldWithAnEndIsAsLongAsTheTow) {
    Scenario scenario = cone();
    scenario.field.far_end = FarEnd::ice_sheet;
    const Scenario tow = laid(scenario);
    const double way = 0.5 * (370 + 990);
    EXPECT_GE(tow.field_end(), tow.structure.start + way + 40.5 + 162);
    EXPECT_LE(tow.field_end(), tow.structure.start + way + 40.5 + 162 + 60);  // two figures, whole rows
    EXPECT_THAT(find_contradictions(tow), IsEmpty());
    EXPECT_THAT(reason(scenario, LaidKey::floes), HasSubstr("a way of 680 m, the hull, and two breadths of it, 162 m"));
}

TEST(Layout, StatedFloesEndTheRun) {
    Scenario scenario = cone();
    scenario.field.far_end = FarEnd::ice_sheet;
    scenario.field.floes = 100;
    const Scenario run = laid(scenario, but({LaidKey::floes}));
    EXPECT_EQ(run.field.floes, 100);
    const double end = run.structure.start + 0.5 * (run.analysis.steady_start + run.analysis.window) + 40.5;
    EXPECT_LE(end, run.field_end());
    EXPECT_GE(end, run.field_end() - 1);
    EXPECT_THAT(find_contradictions(run), IsEmpty());
    EXPECT_THAT(reason(scenario, LaidKey::window, but({LaidKey::floes})), HasSubstr("until the ice of 100 floes ends"));
}

TEST(Layout, GivenPlacesEndTheRun) {
    Scenario scenario = cone();
    scenario.field.far_end = FarEnd::ice_sheet;
    scenario.field.half_width = 130;
    scenario.arrangement.method = ArrangementMethod::file;
    scenario.arrangement.poses.resize(100);
    lay_one(scenario, all());
    const Analysis& analysis = scenario.analysis;
    const double end = scenario.structure.start + 0.5 * (analysis.steady_start + analysis.window) + 40.5;
    EXPECT_LE(end, scenario.field_end());
    EXPECT_GT(end, scenario.field_end() - 30);
}

// Its pieces are some characteristic lengths long; the sheet's own length is no floe's.
TEST(Layout, LevelIceIsMeasuredByWhatBreaksOff) {
    Scenario scenario = cone();
    scenario.arrangement.method = ArrangementMethod::level;
    scenario.field.floes = 1;
    scenario.floe.breadth = 200;
    Scenario farther = scenario;
    farther.field.ahead = 1000;
    lay_one(scenario, all());
    lay_one(farther, but({LaidKey::ahead}));
    EXPECT_DOUBLE_EQ(scenario.analysis.window, 3 * 330);  // 3 times two breadths of 81 m, at 0.5 m/s, to two figures
    EXPECT_DOUBLE_EQ(farther.analysis.window, scenario.analysis.window);
    EXPECT_DOUBLE_EQ(farther.analysis.steady_start, scenario.analysis.steady_start);
}

TEST(Layout, EachOfManySegmentsHasTheWay) {
    Scenario scenario = cone();
    scenario.analysis.segments = 6;
    lay_one(scenario, all());
    EXPECT_GE(scenario.analysis.window / 6, 2 * 81 / 0.5);
}

TEST(Layout, OneOfStartAndBeginFollowsTheOther) {
    Scenario scenario = cone();
    scenario.field.begin = 100;
    EXPECT_DOUBLE_EQ(laid(scenario, but({LaidKey::begin})).structure.start, 39);
    scenario.structure.start = 30;
    EXPECT_DOUBLE_EQ(laid(scenario, but({LaidKey::start})).field.begin, 91);
}

TEST(Layout, APathEndsTheRunAndWidensTheField) {
    Scenario scenario = ship();
    scenario.path.legs = {{0, 0.5, 1000, 0}, {0.5 * std::numbers::pi, 0.5, 100, 0}, {0, 0.5, 400, 0}};
    const Scenario turned = laid(scenario);
    EXPECT_NEAR(turned.analysis.steady_start + turned.analysis.window, 1500, 0.3);
    EXPECT_DOUBLE_EQ(turned.analysis.steady_start, 500);
    EXPECT_DOUBLE_EQ(turned.field.half_width, 210);  // 50 + 76 + 80
    EXPECT_EQ(reason(scenario, LaidKey::window), "until the path ends after 1500 s");
    EXPECT_THAT(find_contradictions(turned), IsEmpty());
    scenario.path.legs.push_back({std::numbers::pi, 0.5, 100, 0});
    const Scenario back = laid(scenario);
    EXPECT_DOUBLE_EQ(back.field.behind - turned.field.behind, 50);
    EXPECT_THAT(find_contradictions(back), IsEmpty());
}

TEST(Layout, AWindowThatThreeDoNotCutHasFewerSegments) {
    Scenario scenario = cone();
    scenario.analysis.window = 500.2;  // 5002 steps
    const OpenKeys open = but({LaidKey::window});
    EXPECT_EQ(laid(scenario, open).analysis.segments, 2);
    EXPECT_THAT(reason(scenario, LaidKey::segments, open), HasSubstr("2 cut the window of 500.2 s"));
}

TEST(Layout, HistoriesCutNoEdge) {
    Scenario scenario = cone();
    scenario.analysis.history_stride = 7;
    const Scenario whole = laid(scenario);
    EXPECT_EQ(whole.first_window_step() % 7, 0);
    EXPECT_EQ((whole.step_count() - whole.first_window_step()) % 21, 0);
    EXPECT_THAT(find_contradictions(whole), IsEmpty());
}

TEST(Layout, FieldsAreAlikeInAllCases) {
    Scenario small = cone();
    Scenario large = cone();
    small.structure.shape = Shape({{-5, 10}, {2, 10}});
    std::vector<Unlaid> cases{{&small, all()}, {&large, all()}};
    lay(cases);
    EXPECT_EQ(small.field.half_width, large.field.half_width);
    EXPECT_EQ(small.field.begin, large.field.begin);
    EXPECT_EQ(small.field.floes, large.field.floes);
    EXPECT_GT(small.structure.start, large.structure.start);
    EXPECT_THAT(cases[0].laid.at(LaidKey::half_width), HasSubstr(", in the case that needs most"));
    EXPECT_THAT(find_contradictions(small), IsEmpty());
}

TEST(Layout, KeepsWhatIsStated) {
    const Scenario before = cone();
    Scenario after = before;
    EXPECT_THAT(lay_one(after, {}), IsEmpty());
    EXPECT_EQ(after.field.half_width, before.field.half_width);
    EXPECT_EQ(laid(before, but({LaidKey::half_width})).field.half_width, before.field.half_width);
}

TEST(Layout, LeavesThePapersHullAndFaultyScenariosAlone) {
    Scenario paper;
    EXPECT_THAT(lay_one(paper, all()), IsEmpty());
    EXPECT_FALSE(lays_itself(paper));
    paper.structure.shape = Shape({{-0.443, 0.3}, {0, 0.614}, {0.122, 0.736}});  // another wall below
    EXPECT_FALSE(lays_itself(paper));
    Scenario under = cone();
    under.structure.shape = Shape({{-2, 30}, {-1, 30}});
    EXPECT_THAT(lay_one(under, all()), IsEmpty());
    Scenario nameless = cone();
    nameless.sizes.law = SizeLaw::list;  // of nothing
    EXPECT_THAT(lay_one(nameless, all()), IsEmpty());
    Scenario timeless = cone();
    timeless.path.table = {{0, 0, 0, 0}, {0, 10, 0, 0}};
    EXPECT_THAT(find_contradictions(laid(timeless)), Not(IsEmpty()));
}

}  // namespace layout_test
}  // namespace floes
