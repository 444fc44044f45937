// Measures of order against closed forms.

#include "arrangement/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "core/random.hpp"

namespace floes {
namespace order_test {

constexpr double eighth = std::numbers::pi / 4;

TEST(LocalOrder, IsOneWhereAllAreParallelOrAtRightAngles) {
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 30; ++i) poses.push_back({0.7 * i, 0.3 * (i % 4), 0.2 + 2 * eighth * (i % 3)});
    EXPECT_NEAR(local_order(poses), 1, 1e-14);
}

// Inside, all four nearest are turned: -1. On an edge three of them and the nearest diagonal: (-3 + 1) / 4. In a corner
// two, one diagonal, and one two sites away.
TEST(LocalOrder, OfACheckerboardOfZeroAnd45Degrees) {
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) poses.push_back({1.0 * i, 1.0 * j, (i + j) % 2 * eighth});
    EXPECT_NEAR(local_order(poses), (-64 - 0.5 * 32) / 100, 1e-14);
    EXPECT_NEAR(fourfold_order(poses), 0, 1e-14);
}

TEST(LocalOrder, OfRandomYawsIsAboutZero) {
    RandomStream random(1, 0, StreamId::scattering, 0);
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 2000; ++i)
        poses.push_back({random.uniform(0, 50), random.uniform(0, 50), random.uniform(-4, 4)});
    EXPECT_NEAR(local_order(poses), 0, 0.06);
}

// Five floes are equally far from the middle one; (3, 4) alone is turned, and of the four nearest of every other.
TEST(LocalOrder, TakesEquallyNearFloesInTheirOrder) {
    const PlanarPose turned{3, 4, eighth};
    std::vector<PlanarPose> poses{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {-5, 0, 0}, {0, -5, 0}, turned};
    EXPECT_NEAR(local_order(poses), (1 + 4 * 0.5 - 1) / 6, 1e-14);
    poses.pop_back();
    poses.insert(poses.begin() + 1, turned);
    EXPECT_NEAR(local_order(poses), (0.5 + 4 * 0.5 - 1) / 6, 1e-14);
}

/// local_order() by looking at every pair.
double order_of_all_pairs(const std::vector<PlanarPose>& poses) {
    double sum = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        std::vector<std::pair<double, std::size_t>> others;
        for (std::size_t j = 0; j < poses.size(); ++j) {
            if (j != i) others.emplace_back(std::hypot(poses[j].x - poses[i].x, poses[j].z - poses[i].z), j);
        }
        std::ranges::sort(others);
        for (std::size_t k = 0; k < 4; ++k) sum += std::cos(4 * (poses[others[k].second].yaw - poses[i].yaw)) / 4;
    }
    return sum / static_cast<double>(poses.size());
}

// Two dense fields far apart, a row, and floes on their own: some have their four nearest far off.
TEST(LocalOrder, FindsTheFourNearestHoweverFarTheyAre) {
    RandomStream random(3, 0, StreamId::scattering, 0);
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 300; ++i) {
        const double from = i % 2 == 0 ? 0 : 400;
        poses.push_back({from + random.uniform(0, 3), random.uniform(0, 3), random.uniform(-0.4, 0.4)});
    }
    for (int i = 0; i < 9; ++i) poses.push_back({50.0 * i, -20, random.uniform(-0.4, 0.4)});
    EXPECT_NEAR(local_order(poses), order_of_all_pairs(poses), 1e-12);
}

TEST(LocalOrder, OfFewFloesTakesAllOthers) {
    EXPECT_EQ(local_order(std::vector<PlanarPose>{{3, 1, 0.7}}), 1);
    EXPECT_NEAR(local_order(std::vector<PlanarPose>{{0, 0, 0.1}, {1, 0, 0.2}}), std::cos(0.4), 1e-14);
    EXPECT_NEAR(local_order(std::vector<PlanarPose>{{0, 0, 0}, {1, 0, 0.1}, {9, 0, 0.3}}),
                (std::cos(0.4) + std::cos(0.8) + std::cos(1.2)) / 3, 1e-14);
}

TEST(Coverage, OfAStripByOneTurnedFloe) {
    const std::vector<Rectangle> square{{0.5, 0.5}};
    const double tip = std::sqrt(0.5);
    const double half = 0.4;  // of the strip: cuts off both tips
    EXPECT_NEAR(coverage({-3, -half, 10, 2 * half}, square, std::vector<PlanarPose>{{1, 0, eighth}}),
                (1 - 2 * (tip - half) * (tip - half)) / (10 * 2 * half), 1e-14);
    // A line through its middle halves a rectangle at any angle.
    const std::vector<Rectangle> oblong{{1, 0.25}};
    const std::vector<PlanarPose> turned{{2, 1, 0.3}};
    EXPECT_NEAR(coverage({-3, 1, 10, 4}, oblong, turned), 0.5 / 40, 1e-14);
    EXPECT_NEAR(coverage({-3, -3, 10, 4}, oblong, turned), 0.5 / 40, 1e-14);
    EXPECT_NEAR(coverage({2, -3, 5, 8}, oblong, turned), 0.5 / 40, 1e-14);
    EXPECT_NEAR(coverage({-3, -3, 5, 8}, oblong, turned), 0.5 / 40, 1e-14);
    EXPECT_EQ(coverage({4, 0, 5, 8}, oblong, turned), 0);
}

TEST(Coverage, OfATiledAreaIsFull) {
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) poses.push_back({0.5 * i, 0.5 * j, 2 * eighth * (i % 4)});
    EXPECT_NEAR(coverage({0.1, 0.3, 2.7, 1.9}, std::vector<Rectangle>(64, {0.25, 0.25}), poses), 1, 1e-13);
}

TEST(CoverageAhead, IsOfThePathAndOfNothingBesideIt) {
    Scenario scenario;
    const double radius = scenario.structure.shape.waterline_radius();
    ASSERT_NEAR(radius, 0.614, 0.2);
    const double path = 18.9 * 2 * radius;
    EXPECT_NEAR(coverage_ahead(scenario, floes_at(scenario, std::vector<PlanarPose>{{10, 0, 0}})), 0.36 / path, 1e-12);
    EXPECT_NEAR(coverage_ahead(scenario, floes_at(scenario, std::vector<PlanarPose>{{10, -radius, 0}})), 0.18 / path,
                1e-12);
    EXPECT_EQ(coverage_ahead(scenario, floes_at(scenario, std::vector<PlanarPose>{{10, radius + 0.31, 0}})), 0);
    Scenario turning = scenario;
    turning.path.legs = {{0.1, 0.1, 10, 0}};
    EXPECT_TRUE(std::isnan(coverage_ahead(turning, floes_at(turning, std::vector<PlanarPose>{{10, 0, 0}}))));
    // A structure wider than the field sweeps all of it.
    scenario.field.half_width = 0.9 * radius;
    scenario.field.floes = 20;
    scenario.field.concentration = 0.4;
    scenario.arrangement.method = ArrangementMethod::scattered;
    EXPECT_NEAR(make_arrangement(scenario, 1, 0).coverage_ahead, 0.4, 1e-12);
}

TEST(Order, IsMeasuredWhateverTheMethod) {
    Scenario scenario;
    scenario.arrangement.sweeps = 10;
    for (const ArrangementMethod method :
         {ArrangementMethod::monte_carlo, ArrangementMethod::lattice, ArrangementMethod::scattered}) {
        scenario.arrangement.method = method;
        const Arrangement made = make_arrangement(scenario, 1, 0);
        EXPECT_EQ(made.psi4, fourfold_order(made.poses()));
        EXPECT_EQ(made.local_order, local_order(made.poses()));
        EXPECT_EQ(made.coverage_ahead, coverage_ahead(scenario, made));
        EXPECT_NEAR(coverage(field_walls(scenario), rectangles(made), made.poses()), 0.75, 1e-12);
    }
}

}  // namespace order_test
}  // namespace floes
