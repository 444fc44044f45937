#include "arrangement/sampler.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/periodic_box.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"

namespace floes {
namespace sampler_test {

HardFloes<Walls> papers_channel() {
    const Scenario scenario;
    const double clearance = scenario.arrangement.clearance;
    const FloeSet floes = floes_of(scenario);
    return {field_walls(scenario).shrunk(clearance), outlines_of(floes), clearance,
            lattice_start(field_walls(scenario), rectangles(floes).front(), clearance, scenario.field.floes)};
}

std::string digest(const std::vector<PlanarPose>& poses) {
    std::string text;
    for (const PlanarPose& pose : poses) text += fmt::format("{:a} {:a} {:a}\n", pose.x, pose.z, pose.yaw);
    return digest_hex(text);
}

TEST(Sampler, TakesThreeDrawsAFloe) {
    HardFloes floes = papers_channel();
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    floes.sweep({0.05, 0.1}, random);
    EXPECT_EQ(random.draws(), 3u * 189);
    tune(floes, random);
    EXPECT_EQ(random.draws(), 3u * 189 * 1001);
}

TEST(Sampler, IsTunedToTheAcceptanceAskedFor) {
    HardFloes floes = papers_channel();
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    const Step step = tune(floes, random);
    int accepted = 0;
    for (int i = 0; i < 1000; ++i) accepted += floes.sweep(step, random);
    EXPECT_GT(accepted, 0.40 * 189'000);
    EXPECT_LT(accepted, 0.50 * 189'000);
}

TEST(Sampler, StepStaysBelowTheFloeWhereEverythingIsAccepted) {
    const Rectangle square{0.5, 0.5};
    HardFloes floes(PeriodicBox{0, 0, 50, 50}, std::vector(4, corners_of(0.5, 0.5)), 0,
                    lattice_start({0, 0, 50, 50}, square, 0, 4));
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    EXPECT_EQ(tune(floes, random).shift, square.half_diagonal());
}

// A square alone between walls: where its centre may be depends on its yaw, and every allowed pose is equally likely.
// So the density of yaws is proportional to the room that each leaves.
TEST(Sampler, GivesALoneFloeEveryPoseEquallyOften) {
    HardFloes floes(Walls{0, 0, 2, 2}, std::vector<Outline>{corners_of(0.5, 0.5)}, 0,
                    std::vector<PlanarPose>{{1, 1, 0}});
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    constexpr int samples = 200'000;
    double order = 0, order_expected = 0, normal = 0, spread = 0, spread_expected = 0;
    for (int i = 0; i < samples; ++i) {
        for (int j = 0; j < 10; ++j) floes.sweep({0.7, 0.7}, random);
        order += std::cos(4 * floes.poses()[0].yaw) / samples;
        spread += std::pow(floes.poses()[0].x - 1, 2) / samples;
    }
    constexpr int steps = 100'000;
    for (int i = 0; i < steps; ++i) {
        const double yaw = (i + 0.5) / steps * std::numbers::pi / 2;
        const double room = 2 - std::cos(yaw) - std::sin(yaw);
        normal += room * room;
        order_expected += room * room * std::cos(4 * yaw);
        spread_expected += room * room * room * room / 12;
    }
    EXPECT_NEAR(order, order_expected / normal, 0.01);
    EXPECT_NEAR(spread, spread_expected / normal, 0.001);
}

TEST(Sampler, KeepsPeriodicFloesApartAcrossTheSeam) {
    const Rectangle square{0.5, 0.5};
    const double side = std::sqrt(100 / 0.7);
    HardFloes floes(PeriodicBox{-3, 5, side, side}, std::vector(100, corners_of(0.5, 0.5)), 0.01,
                    lattice_start({-3, 5, side, side}, square, 0.01, 100));
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    for (int i = 0; i < 2000; ++i) floes.sweep({0.1, 0.1}, random);
    const std::vector<PlanarPose>& poses = floes.poses();
    const Rectangle grown = square.grown(0.005 - 1e-9);
    int across = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        ASSERT_TRUE(poses[i].x >= -3 && poses[i].x < -3 + side && poses[i].z >= 5 && poses[i].z < 5 + side);
        for (std::size_t j = 0; j < poses.size(); ++j) {
            for (const double image_x : {-side, 0.0, side}) {
                for (const double image_z : {-side, 0.0, side}) {
                    const double dx = poses[j].x + image_x - poses[i].x;
                    const double dz = poses[j].z + image_z - poses[i].z;
                    if (i == j && image_x == 0 && image_z == 0) continue;
                    EXPECT_FALSE(overlap({grown, turn_of(poses[i].yaw)}, {grown, turn_of(poses[j].yaw)}, dx, dz));
                    across += (image_x != 0 || image_z != 0) && std::hypot(dx, dz) < 1.3;
                }
            }
        }
    }
    EXPECT_GT(across, 40);  // pairs that only the seam makes neighbours
}

TEST(Sampler, RefusesAPeriodicBoxTooSmallForItsFloes) {
    const std::vector<Outline> shapes{corners_of(0.5, 0.5)};
    const std::vector<PlanarPose> poses{{1, 1, 0}};
    EXPECT_THROW(HardFloes(PeriodicBox{0, 0, 4, 4}, shapes, 0, poses), InputError);
}

// The same bits on every machine: stored once, compared for ever.
TEST(Arrangement, HasTheStoredDigest) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
    scenario.arrangement.sweeps = 500;
    EXPECT_EQ(digest(make_arrangement(scenario, 20240, 7).poses()), "b4ba3864167742f8d214136e85468625");
    scenario.arrangement.start = ArrangementStart::stripes;
    EXPECT_EQ(digest(make_arrangement(scenario, 20240, 7).poses()), "646c13899eb15c71396b1eb10858691a");
    scenario.arrangement.method = ArrangementMethod::lattice;
    scenario.arrangement.jitter = 0.03;
    scenario.arrangement.jitter_angle = 0.05;
    EXPECT_EQ(digest(make_arrangement(scenario, 20240, 7).poses()), "d33f432ee6a9914b7aa357ddc7e7876f");
    scenario.arrangement = {};
    scenario.arrangement.method = ArrangementMethod::scattered;
    EXPECT_EQ(digest(make_arrangement(scenario, 20240, 7).poses()), "3e215cd846c867a0b2f8607843aac4a8");
    scenario.arrangement.ordering_sweeps = 100;
    EXPECT_EQ(digest(make_arrangement(scenario, 20240, 7).poses()), "cdeb0868c0f3b55b048f4a7667d8d1ee");
}

}  // namespace sampler_test
}  // namespace floes
