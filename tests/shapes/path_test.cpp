#include "shapes/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace floes {
namespace path_test {

constexpr double pi = std::numbers::pi;

TEST(Path, LegsFollowOneAnother) {
    const Path path{.legs = {{0, 0.5, 10, 0}, {pi / 2, 0.25, 8, 0}}};
    const std::vector<PathPlace> places = places_of(path, 0.1, 300);
    EXPECT_NEAR(places[100].pose.x, 5, 1e-12);
    EXPECT_NEAR(places[180].pose.z, 2, 1e-12);
    EXPECT_NEAR(places[300].pose.z, 2, 1e-12) << "after the last leg it stands";
    EXPECT_EQ(places[300].velocity, Vec2(0, 0));
    EXPECT_NEAR(way_of(places, 0.1), 7, 1e-12);
}

// Evenly from rest to v in t: v t / 2. From one heading to the other at one speed: an arc.
TEST(Path, RampsChangeSpeedAndHeadingEvenly) {
    const Path path{.legs = {{0, 1, 10, 0}, {0, 0, 10, 0}, {0, 2, 10, 0}}, .ramp = 4};
    const std::vector<PathPlace> places = places_of(path, 0.5, 60);
    EXPECT_NEAR(places[8].pose.x, 2, 1e-12);
    EXPECT_NEAR(places[20].pose.x, 8, 1e-12);
    EXPECT_NEAR(places[28].pose.x, 10, 1e-12) << "stops";
    EXPECT_NEAR(places[40].pose.x, 10, 1e-12);
    EXPECT_NEAR(places[60].pose.x, 10 + 4 + 12, 1e-12) << "and goes";
    const std::vector<PathPlace> bend = places_of({.legs = {{0, 1, 4, 0}, {pi / 2, 1, 8, 0}}, .ramp = 4}, 0.01, 1200);
    const double radius = 4 / (pi / 2);
    EXPECT_NEAR(bend[800].pose.x - bend[400].pose.x, radius, 1e-4);
    EXPECT_NEAR(bend[800].pose.z, radius, 1e-4);
}

// A turn of 2π is a circle of the radius v/ω that comes back, to (ω Δt)²/24 of its radius.
TEST(Path, CircleCloses) {
    const double turn = 2 * pi / 100;
    const std::vector<PathPlace> places = places_of({.legs = {{0, 0.3, 100, turn}}, .bow = PathBow::ahead}, 0.1, 1000);
    EXPECT_NEAR(places[1000].pose.x, 0, 1e-10);
    EXPECT_NEAR(places[1000].pose.z, 0, 1e-10);
    EXPECT_NEAR(places[500].pose.z, 2 * 0.3 / turn, 2e-5);
    EXPECT_NEAR(places[250].pose.yaw, -pi / 2, 1e-12) << "the bow points to +z: a heading towards +z is a negative yaw";
    EXPECT_NEAR(places[250].turning, -turn, 1e-12);
}

TEST(Path, IceThatDriftsIsTheStructureTheOtherWay) {
    const std::vector<PathLeg> legs{{0.3, 0.2, 5, 0.01}, {1.2, 0.4, 5, 0}};
    const std::vector<PathPlace> ship = places_of({.legs = legs}, 0.1, 100);
    const std::vector<PathPlace> ice = places_of({.legs = legs, .of = PathOf::ice}, 0.1, 100);
    for (std::size_t k = 0; k < ship.size(); ++k) {
        EXPECT_DOUBLE_EQ(ice[k].pose.x, -ship[k].pose.x);
        EXPECT_DOUBLE_EQ(ice[k].pose.z, -ship[k].pose.z);
        EXPECT_EQ(ice[k].pose.yaw, 0);
    }
}

TEST(Path, TableIsStraightBetweenItsRows) {
    const Path path{.table = {{0, 0, 0, 0}, {2, 1, 0.5, 0.1}, {4, 1, 0.5, 0.1}, {5, 2, 0, 0}}};
    const std::vector<PathPlace> places = places_of(path, 0.5, 14);
    EXPECT_DOUBLE_EQ(places[2].pose.x, 0.5);
    EXPECT_DOUBLE_EQ(places[2].velocity.x(), 0.5);
    EXPECT_DOUBLE_EQ(places[2].turning, 0.05);
    EXPECT_DOUBLE_EQ(places[6].velocity.norm(), 0);
    EXPECT_DOUBLE_EQ(places[9].pose.x, 1.5);
    EXPECT_DOUBLE_EQ(places[14].pose.x, 2) << "after the last row it stands";
}

// 350 to 10 degrees is a turn by 20, as if 370 stood there; what is within half a turn keeps its bits.
TEST(Path, TurnsGoTheShorterWay) {
    constexpr double degree = pi / 180;
    const auto led = [](double first, double second, double third) {
        return places_of({.legs = {{first, 0.1, 10, 0}, {second, 0.1, 10, 0.01}, {third, 0.1, 10, 0}},
                          .bow = PathBow::ahead,
                          .ramp = 4},
                         0.5, 60);
    };
    const auto shown = [](double first, double second, double third) {
        return places_of({.table = {{0, 0, 0, first}, {10, 1, 0, second}, {20, 2, 0, third}}}, 0.5, 60);
    };
    for (const auto& make : {std::function(led), std::function(shown)}) {
        const std::vector<PathPlace> wrapped = make(350 * degree, 10 * degree, 355 * degree);
        const std::vector<PathPlace> written = make(350 * degree, 370 * degree, 355 * degree);
        const std::vector<PathPlace> other_way = make(10 * degree, -10 * degree, 350 * degree);
        for (std::size_t k = 0; k < wrapped.size(); ++k) {
            EXPECT_NEAR(wrapped[k].pose.yaw, written[k].pose.yaw, 1e-12);
            EXPECT_NEAR(wrapped[k].pose.z, written[k].pose.z, 1e-12);
            EXPECT_LT(std::abs(wrapped[k].turning), 9 * degree) << "no spin";
            EXPECT_LT(std::abs(other_way[k].turning), 9 * degree);
        }
    }
    EXPECT_EQ(shown(0, pi, 0)[10].pose.yaw, 0.5 * pi) << "half a turn goes as it is written";
    EXPECT_EQ(shown(0, -pi, 0)[10].pose.yaw, -0.5 * pi);
}

TEST(Path, EndsWithItsLastLegOrRow) {
    EXPECT_EQ(duration_of({.legs = {{0, 1, 10, 0}, {0, 0, 5, 0}}}), 15);
    EXPECT_EQ(duration_of({.table = {{0, 0, 0, 0}, {7, 1, 0, 0}}}), 7);
    EXPECT_EQ(duration_of({}), 0);
    EXPECT_TRUE(ends_moving({.legs = {{0, 0, 10, 0}, {0, 1, 5, 0}}}));
    EXPECT_FALSE(ends_moving({.legs = {{0, 1, 10, 0}, {0, 0, 5, 0}}}));
    EXPECT_TRUE(ends_moving({.table = {{0, 0, 0, 0}, {7, 0, 0, 1}}}));
    EXPECT_FALSE(ends_moving({.table = {{0, 0, 0, 0}, {7, 1, 0, 0}, {8, 1, 0, 0}}}));
}

}  // namespace path_test
}  // namespace floes
