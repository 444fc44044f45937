// Joints break at their thresholds in the world, and the consequences.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ice_scene.hpp"

namespace floes::test {
namespace breaking_test {

struct Loading {
    FailureMode mode;
    Vec3 force;  // of the joint on a at the threshold, shares of the threshold, joint axes
    Vec3 moment;
};

class BreakingTest : public testing::TestWithParam<Loading> {};

/// Two elements side by side along the floe's x or z, lying at some yaw.
class Pair {
  public:
    explicit Pair(const Corner& along)
        : scenario_(along.x > 0 ? scenario_of(2, 1) : scenario_of(1, 2)),
          along_(along),
          world_(weightless_world()),
          ice_(world_, strong(scenario_), floes_at(strong(scenario_), std::vector<PlanarPose>{{3, -1, 0.7}})) {}

    /// Grows the load in the joint's axes to `share` of (force, moment) and holds it. Returns the joints that failed.
    int load(const Vec3& force, const Vec3& moment, double share) {
        const Quat frame = turned_to(along_);
        const Vec3 arm = frame * Vec3(scenario_.floe.element / 2, 0, 0);
        const int ramp = 200;
        int failed = 0;
        for (int step = 0; step < 2 * ramp; ++step) {
            const double level = reached_ + (share - reached_) * std::min(1.0, static_cast<double>(step) / ramp);
            load_joint(world_, ice_.elements()[0].body, ice_.elements()[1].body, arm, frame * force * level,
                       frame * moment * level);
            world_.step();
            failed += ice_.break_joints(world_, ++steps_ * 0.02);
            if (failed > 0) break;
        }
        reached_ = share;
        return failed;
    }

    const IceField& ice() const { return ice_; }

  private:
    // Every mode has a criterion, and the joint is so stiff that the pair keeps its shape.
    static const Scenario& strong(Scenario& scenario) {
        scenario.ice.tensile_strength = 1e5;
        scenario.ice.torsion_strength = 1e5;
        scenario.ice.in_plane_bending_strength = 1e5;
        scenario.joint.cfm = 1e-10;
        return scenario;
    }

    Scenario scenario_;
    Corner along_;
    World world_;
    IceField ice_;
    double reached_ = 0;
    int steps_ = 0;
};

TEST_P(BreakingTest, HappensAtTheThresholdAndNotOnePercentUnderIt) {
    for (const Corner& along : {Corner{1, 0}, Corner{0, 1}}) {
        Pair pair(along);
        EXPECT_EQ(pair.load(GetParam().force, GetParam().moment, 0.99), 0);
        ASSERT_EQ(pair.load(GetParam().force, GetParam().moment, 1.001), 1);
        EXPECT_EQ(pair.ice().breaks().front().mode, GetParam().mode);
        EXPECT_EQ(pair.ice().live_joints(), 0);
    }
}

constexpr double compression = 0.2 * 0.033 * 145.6e3;
constexpr double shear = 0.2 * 0.033 * 72.8e3;
constexpr double bending = 0.2 * 0.033 * 0.033 / 6 * 36.4e3;
constexpr double tension = 0.2 * 0.033 * 1e5;
constexpr double torsion = 0.2 * 0.033 * 0.033 / 3 * 1e5;
constexpr double in_plane_bending = 0.033 * 0.2 * 0.2 / 6 * 1e5;

INSTANTIATE_TEST_SUITE_P(Ice, BreakingTest,
                         testing::Values(Loading{FailureMode::compression, {-compression, 0, 0}, {0, 0, 0}},
                                         Loading{FailureMode::tension, {tension, 0, 0}, {0, 0, 0}},
                                         Loading{FailureMode::shear, {0, 0.6 * shear, -0.8 * shear}, {0, 0, 0}},
                                         Loading{FailureMode::bending, {0, 0, 0}, {0, 0, -bending}},
                                         Loading{FailureMode::torsion, {0, 0, 0}, {torsion, 0, 0}},
                                         Loading{FailureMode::in_plane_bending, {0, 0, 0}, {0, in_plane_bending, 0}}),
                         [](const auto& instance) {
                             return std::string(failure_mode_names[static_cast<std::size_t>(instance.param.mode)]);
                         });

// Floes of three in a row; the last element of the second floe is torn off.
TEST(IceBreaking, IsLoggedAndCountedAndSplitsTheFloe) {
    Scenario scenario = scenario_of(3, 1);
    scenario.ice.tensile_strength = 10.0 / (0.2 * 0.033);  // 10 N
    World world = weightless_world();
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}, {0, 2, 0}}));
    ASSERT_EQ(ice.live_joints(), 4);
    EXPECT_EQ(ice.elements()[5].piece, 3);
    EXPECT_EQ(ice.elements()[5].exposed_edges, edge_plus_x | edge_plus_z | edge_minus_z);
    double time = 0;
    while (ice.breaks().empty() && time < 20) {  // pulled by 1 N more every second
        load_joint(world, ice.elements()[4].body, ice.elements()[5].body, {0.1, 0, 0}, {time, 0, 0}, Vec3::Zero());
        world.step();
        time += 0.02;
        ice.break_joints(world, time);
    }
    EXPECT_NEAR(time, 10, 0.1);
    ASSERT_EQ(ice.breaks().size(), 1u);
    const BreakEvent expected{time, 1, 1, FailureMode::tension};
    EXPECT_EQ(ice.breaks().front(), expected);
    EXPECT_EQ(ice.broken_floes(), 1);
    EXPECT_EQ(ice.failure_ratio(), 0.5);
    EXPECT_EQ(ice.live_joints(), 3);
    EXPECT_NEAR(ice.peaks().tension, 10, 0.1);
    EXPECT_EQ(ice.elements()[2].piece, 0);
    EXPECT_EQ(ice.elements()[3].piece, 3);
    EXPECT_EQ(ice.elements()[4].piece, 3);
    EXPECT_EQ(ice.elements()[5].piece, 5);
    EXPECT_EQ(ice.elements()[4].exposed_edges, edge_plus_x | edge_plus_z | edge_minus_z);
    EXPECT_EQ(ice.elements()[5].exposed_edges, 15);
    const std::vector<PieceArea> areas = ice.piece_areas();
    ASSERT_EQ(areas.size(), 2u) << "the other floe is whole";
    EXPECT_EQ(areas[0].floe, 1);
    EXPECT_NEAR(areas[0].area, 2 * 0.04, 1e-12);
    EXPECT_NEAR(areas[1].area, 0.04, 1e-12);
}

// Squeezed together until the joint fails, the two overlap; the step after, they push each other apart.
TEST(IceBreaking, LetsThePartsTouchInTheNextStep) {
    Scenario scenario = scenario_of(2, 1);
    scenario.ice.compressive_strength = 100.0 / (0.2 * 0.033);  // 100 N
    World world = weightless_world();
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
    const BodyId a = ice.elements()[0].body;
    const BodyId b = ice.elements()[1].body;
    for (int step = 0; step < 1000 && ice.breaks().empty(); ++step) {
        load_joint(world, a, b, {0.1, 0, 0}, {-0.2 * step, 0, 0}, Vec3::Zero());
        world.step();
        EXPECT_EQ(world.contact_force(a), Vec3(0, 0, 0));
        ice.break_joints(world, 0);
    }
    ASSERT_EQ(ice.breaks().size(), 1u);
    world.step();
    EXPECT_LT(world.contact_force(a).x(), 0);
    EXPECT_GT(world.contact_force(b).x(), 0);
}

// Of a 2 x 2 floe one joint fails: the floe still hangs together, and its elements still do not touch.
TEST(IceBreaking, LeavesAConnectedFloeOnePiece) {
    Scenario scenario = scenario_of(2, 2);
    scenario.ice.compressive_strength = 50.0 / (0.2 * 0.033);  // 50 N
    World world = weightless_world();
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
    const BodyId a = ice.elements()[0].body;
    const BodyId b = ice.elements()[1].body;
    const auto squeeze = [&](double force) {
        load_joint(world, a, b, {0.1, 0, 0}, {-force, 0, 0}, Vec3::Zero());
        world.step();
        ice.break_joints(world, 0);
    };
    for (int step = 0; step < 2000 && ice.breaks().empty(); ++step) squeeze(0.2 * step);
    ASSERT_EQ(ice.breaks().size(), 1u);
    ASSERT_EQ(ice.breaks().front().joint, 0);
    for (int step = 0; step < 20; ++step) {
        squeeze(1);
        for (const IceElement& element : ice.elements()) {
            EXPECT_EQ(element.piece, 0);
            EXPECT_EQ(world.contact_force(element.body), Vec3(0, 0, 0));
        }
    }
    EXPECT_EQ(ice.elements()[0].exposed_edges, edge_minus_x | edge_minus_z | edge_plus_x);
}

}  // namespace breaking_test
}  // namespace floes::test
