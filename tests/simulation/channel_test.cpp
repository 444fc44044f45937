#include "simulation/sheets.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace channel_test {

double top(const IceSheet& sheet) {
    return sheet.centre.y() + sheet.half_extents.y();
}

TEST(Channel, HasSheetsAlongBothWallsAndAcrossTheFarEnd) {
    const Scenario scenario;
    const Channel channel = make_channel(scenario, floes_of(scenario));
    ASSERT_EQ(channel.sheets.size(), 3u);
    EXPECT_NEAR(channel.sheets[0].centre.z() - channel.sheets[0].half_extents.z(), 2.4, 1e-12);
    EXPECT_NEAR(channel.sheets[1].centre.z() + channel.sheets[1].half_extents.z(), -2.4, 1e-12);
    EXPECT_NEAR(channel.sheets[2].centre.x() - channel.sheets[2].half_extents.x(), 24.9, 1e-12);
    EXPECT_NEAR(channel.sheets[2].half_extents.z(), 2.4, 1e-12);
    EXPECT_NEAR(channel.outer_edge, 3.4, 1e-12);
    EXPECT_EQ(channel.room, 1.0);
    EXPECT_EQ(channel.begin, scenario.structure.start - 0.736 - 1.0);
    EXPECT_NEAR(channel.end, 25.9, 1e-12);
    for (const IceSheet& sheet : channel.sheets) {
        EXPECT_NEAR(2 * sheet.half_extents.y(), 0.033, 1e-15);
        EXPECT_NEAR(top(sheet), 0.07 * 0.033, 1e-15);  // freeboard of ice of 930 kg/m³
    }
}

TEST(Channel, LeavesRoomForFloesOfAnySize) {
    Scenario scenario;
    scenario.floe.breadth = 30;
    EXPECT_DOUBLE_EQ(make_channel(scenario, floes_of(scenario)).room, 50);
}

TEST(Channel, WithAnOpenEndHasWallsAsFarAsTheTowCanPush) {
    Scenario scenario;
    scenario.field.far_end = FarEnd::open;
    const Channel channel = make_channel(scenario, floes_of(scenario));
    EXPECT_EQ(channel.sheets.size(), 2u);
    EXPECT_NEAR(channel.end, 24.9 + 1.0 + 0.07 * 270, 1e-12);
}

}  // namespace channel_test
}  // namespace floes
