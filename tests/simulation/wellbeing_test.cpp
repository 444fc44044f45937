#include "simulation/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace floes {
namespace wellbeing_test {

using testing::HasSubstr;

class WellbeingTest : public testing::Test {
  protected:
    const Scenario scenario;
    const Wellbeing wellbeing{scenario, make_channel(scenario, floes_of(scenario))};

    std::string trouble_at(const Vec3& position, const Vec3& velocity = Vec3::Zero()) const {
        return wellbeing.trouble({.position = position, .velocity = velocity}).value_or("well");
    }
};

TEST_F(WellbeingTest, AFloatingElementIsWell) {
    EXPECT_EQ(trouble_at({10, -0.014, 1}), "well");
    EXPECT_EQ(trouble_at({10, -0.4, 1}, {9.9, 0, 0}), "well");
    EXPECT_EQ(trouble_at({10, 0.1, 3.39}), "well");
}

TEST_F(WellbeingTest, ARunawayIsNamedWithItsSpeed) {
    EXPECT_THAT(trouble_at({10, 0, 0}, {0, 10.1, 0}), HasSubstr("10.1 m/s"));
}

TEST_F(WellbeingTest, AnElementIsGoneBeyondEachSideOfItsRange) {
    EXPECT_THAT(trouble_at({10, 0, 3.41}), HasSubstr("wall sheet at 3.4 m"));
    EXPECT_THAT(trouble_at({10, 0, -3.41}), HasSubstr("wall sheet at -3.4 m"));
    EXPECT_EQ(trouble_at({10, 1.11, 0}), "well") << "on the deck";
    EXPECT_THAT(trouble_at({10, 1.13, 0}), HasSubstr("height 1.13 m"));
    EXPECT_THAT(trouble_at({10, -1.45, 0}), HasSubstr("height -1.45 m"));
    EXPECT_THAT(trouble_at({27.0, 0, 0}), HasSubstr("x = 27 m"));
    EXPECT_THAT(trouble_at({-1, 0, 0}), HasSubstr("x = -1 m"));
}

TEST_F(WellbeingTest, LargeFloesMayGoFarther) {
    Scenario large = scenario;
    large.floe.length = large.floe.breadth = 60;
    const Wellbeing limits(large, make_channel(large, floes_of(large)));
    EXPECT_FALSE(limits.trouble({.position = {10, -100, 0}}));
    EXPECT_FALSE(limits.trouble({.position = {-90, 99, 0}}));
    EXPECT_TRUE(limits.trouble({.position = {10, -101, 0}}));
}

TEST_F(WellbeingTest, NotANumberIsNotWell) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(trouble_at({10, nan, 0}), HasSubstr("not a number"));
    EXPECT_THAT(trouble_at({10, 0, 0}, {nan, 0, 0}), HasSubstr("not a number"));
}

}  // namespace wellbeing_test
}  // namespace floes
