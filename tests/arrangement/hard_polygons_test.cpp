// Monte Carlo of hard polygons: against that of squares, and against places drawn at random until none overlap.

#include "arrangement/sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "scattered_scenario.hpp"
#include "shapes/drawn.hpp"

namespace floes {
namespace hard_polygons_test {

/// A square whose corners begin elsewhere than those of corners_of(), so that it is taken for any polygon.
Outline square(double half) {
    return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

TEST(HardPolygons, OverlapWhereTheirSeparationIsNegative) {
    RandomStream random(5, 0, StreamId::polygons, 0);
    int overlaps = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto one = [&] {
            const Outline outline = polygon_about(1, random.uniform(0.5, 1), 3 + i % 7, 0.8, random);
            return on_water(outline, {random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), random.uniform(-3, 3)});
        };
        const Outline a = one();
        const Outline b = one();
        ASSERT_EQ(overlap(a, b, {}), separation(a, b) < 0) << i;
        overlaps += overlap(a, b, {}) ? 1 : 0;
    }
    EXPECT_GT(overlaps, 30'000);
    EXPECT_LT(overlaps, 70'000);
}

TEST(HardPolygons, ThatAreSquaresTakeTheStepsOfSquares) {
    const Walls walls{2, -2, 6, 4};
    const double clearance = 0.002;
    const std::vector<Outline> squares(48, corners_of(0.3, 0.3));
    const std::vector<Outline> outlines(48, square(0.3));
    const std::vector<PlanarPose> start = lattice_start(walls, {0.3, 0.3}, clearance, 48);
    HardFloes one(walls.shrunk(clearance), squares, clearance, start);
    HardFloes other(walls.shrunk(clearance), outlines, clearance, start);
    RandomStream first(1, 0, StreamId::monte_carlo, 0);
    RandomStream second(1, 0, StreamId::monte_carlo, 0);
    int accepted = 0;
    for (int sweep = 0; sweep < 500; ++sweep) {
        const int here = one.sweep({0.05, 0.1}, first);
        ASSERT_EQ(here, other.sweep({0.05, 0.1}, second)) << sweep;
        accepted += here;
    }
    EXPECT_GT(accepted, 0.1 * 500 * 48);
    EXPECT_LT(accepted, 0.9 * 500 * 48);
    for (std::size_t i = 0; i < start.size(); ++i) {
        EXPECT_EQ(one.poses()[i].x, other.poses()[i].x);
        EXPECT_EQ(one.poses()[i].z, other.poses()[i].z);
        EXPECT_EQ(one.poses()[i].yaw, other.poses()[i].yaw);
    }
}

/// Of two polygons: the distance of their centroids, how far the first is from the middle, and how both are turned.
std::vector<double> figures(const std::vector<PlanarPose>& poses) {
    const PlanarPose& a = poses[0];
    const PlanarPose& b = poses[1];
    return {std::hypot(a.x - b.x, a.z - b.z), std::abs(a.x), std::cos(a.yaw), std::cos(3 * (a.yaw - b.yaw)),
            a.x * b.x + a.z * b.z};
}

/// Means of independent samples, or of blocks of dependent ones.
Figures by_figure(const std::vector<std::vector<double>>& samples) {
    Figures found(samples.front().size());
    for (const std::vector<double>& one : samples)
        for (std::size_t i = 0; i < one.size(); ++i) found[i].push_back(one[i]);
    return found;
}

// All arrangements without overlap are equally likely: so are those of them that places drawn at random give.
TEST(HardPolygons, TwoInABoxLieAsPlacesDrawnAtRandomThatDoNotOverlap) {
    const Walls box{-0.45, -0.4, 0.9, 0.8};  // in which both can turn
    RandomStream shapes(3, 0, StreamId::polygons, 0);
    const std::vector<Outline> outlines{polygon_about(0.3, 0.2, 3, 0.5, shapes),
                                        polygon_about(0.25, 0.22, 5, 0.5, shapes)};
    RandomStream random(4, 0, StreamId::scattering, 0);
    std::vector<std::vector<double>> drawn;
    std::vector<PlanarPose> start;
    while (drawn.size() < 20'000) {
        std::vector<PlanarPose> poses;
        std::vector<Outline> laid;
        bool inside = true;
        for (const Outline& one : outlines) {
            poses.push_back({random.uniform(-0.45, 0.45), random.uniform(-0.4, 0.4),
                             random.uniform(-std::numbers::pi, std::numbers::pi)});
            laid.push_back(on_water(one, poses.back()));
            for (const Corner& corner : laid.back())
                inside = inside && std::abs(corner.x) <= 0.45 && std::abs(corner.z) <= 0.4;
        }
        if (!inside || separation(laid[0], laid[1]) < 0) continue;
        if (start.empty()) start = poses;
        drawn.push_back(figures(poses));
    }
    HardFloes chain(box, outlines, 0, start);
    RandomStream moves(5, 0, StreamId::monte_carlo, 0);
    constexpr int blocks = 200, sweeps = 2500;
    std::vector<std::vector<double>> means;
    for (int block = 0; block < blocks; ++block) {
        std::vector<double> mean(5, 0);
        for (int i = 0; i < sweeps; ++i) {
            chain.sweep({0.15, 1.2}, moves);
            const std::vector<double> now = figures(chain.poses());
            for (std::size_t k = 0; k < now.size(); ++k) mean[k] += now[k] / sweeps;
        }
        means.push_back(mean);
    }
    const Figures of_chain = by_figure(means);
    const Figures of_draws = by_figure(drawn);
    for (std::size_t i = 0; i < of_chain.size(); ++i) {
        const double error = std::hypot(error_of_mean(of_chain[i]), error_of_mean(of_draws[i]));
        EXPECT_LT(error, 0.01) << i;
        EXPECT_NEAR(mean(of_chain[i]), mean(of_draws[i]), 4 * error) << i;
    }
}

TEST(HardPolygons, OfAnArrangementLieApart) {
    for (const auto& [kind, concentration] : {std::pair(ShapeKind::polygon, 0.7), {ShapeKind::voronoi, 0.85}}) {
        Scenario scenario = polygon_scenario(kind, concentration, 40);
        const Arrangement before = make_arrangement(scenario, 1, 0);
        scenario.arrangement.ordering_sweeps = 100;
        const Arrangement ordered = make_arrangement(scenario, 1, 0);
        EXPECT_EQ(find_fault(scenario, ordered), std::nullopt);
        EXPECT_EQ(ordered.shapes, before.shapes) << "the same floes";
        double moved = 0;
        for (std::size_t i = 0; i < ordered.size(); ++i)
            moved += std::hypot(ordered.floes[i].pose.x - before.floes[i].pose.x,
                                ordered.floes[i].pose.z - before.floes[i].pose.z) /
                     static_cast<double>(ordered.size());
        EXPECT_GT(moved, 0.01);
        scenario.arrangement.ordering_sweeps = 0;
        scenario.arrangement.method = ArrangementMethod::monte_carlo;
        scenario.arrangement.sweeps = 100;
        const Arrangement chain = make_arrangement(scenario, 1, 0);
        EXPECT_EQ(find_fault(scenario, chain), std::nullopt);
        EXPECT_EQ(chain.floes.front().pose.x, make_arrangement(scenario, 1, 0).floes.front().pose.x);
    }
}

}  // namespace hard_polygons_test
}  // namespace floes
