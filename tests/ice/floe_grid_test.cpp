// The grid of a floe: places and joints.

#include "ice/floe_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace floes {
namespace floe_grid_test {

const FloeGrid grid{3, 2, 0.2};

TEST(FloeGridTest, LaysElementsAboutTheMiddle) {
    EXPECT_TRUE(grid.centre(0).isApprox(Vec3(-0.2, 0, -0.1)));
    EXPECT_TRUE(grid.centre(5).isApprox(Vec3(0.2, 0, 0.1)));
    EXPECT_TRUE(grid.pivot({0, 1, JointAxis::x}).isApprox(Vec3(-0.1, 0, -0.1)));
    EXPECT_TRUE(grid.pivot({0, 3, JointAxis::z}).isApprox(Vec3(-0.2, 0, 0)));
}

TEST(FloeGridTest, KnowsItsOutline) {
    EXPECT_EQ(grid.outline_edges(0), edge_minus_x | edge_minus_z);
    EXPECT_EQ(grid.outline_edges(1), edge_minus_z);
    EXPECT_EQ(grid.outline_edges(5), edge_plus_x | edge_plus_z);
    EXPECT_EQ((FloeGrid{1, 1, 0.2}.outline_edges(0)), 15);
}

TEST(JointOrderTest, HasEveryCommonEdgeOnce) {
    const FloeGrid floe{5, 4, 0.2};
    std::set<std::pair<int, int>> pairs;
    for (const GridJoint& joint : joint_order(floe)) {
        const Vec3 step = floe.centre(joint.b) - floe.centre(joint.a);
        EXPECT_TRUE(step.isApprox(joint.axis == JointAxis::x ? Vec3(0.2, 0, 0) : Vec3(0, 0, 0.2)));
        EXPECT_TRUE(pairs.emplace(joint.a, joint.b).second);
    }
    EXPECT_EQ(pairs.size(), 4u * 4u + 5u * 3u);
}

TEST(JointFrameTest, LooksFromAToB) {
    EXPECT_TRUE((joint_frame(JointAxis::x) * Vec3::UnitX()).isApprox(Vec3::UnitX()));
    EXPECT_TRUE((joint_frame(JointAxis::z) * Vec3::UnitX()).isApprox(Vec3::UnitZ()));
    EXPECT_TRUE((joint_frame(JointAxis::z) * Vec3::UnitY()).isApprox(Vec3::UnitY()));
}

}  // namespace floe_grid_test
}  // namespace floes
