#include "shapes/drawn.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes/polygon.hpp"

namespace floes {
namespace drawn_test {

const WaterArea channel{2, -1, 12, 2};

std::vector<Outline> cells(int relaxations, std::uint32_t number = 0, int count = 60) {
    RandomStream random(7, number, StreamId::voronoi, 0);
    return voronoi_cells(channel, count, relaxations, random);
}

double spread(const std::vector<Outline>& outlines) {
    double sum = 0;
    double squares = 0;
    for (const Outline& one : outlines) sum += area_of(one);
    const double mean = sum / static_cast<double>(outlines.size());
    for (const Outline& one : outlines) squares += std::pow(area_of(one) - mean, 2);
    return std::sqrt(squares / static_cast<double>(outlines.size())) / mean;
}

TEST(Drawn, VoronoiCellsTileTheWater) {
    for (const int relaxations : {0, 3}) {
        const std::vector<Outline> all = cells(relaxations);
        double sum = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            sum += area_of(all[i]);
            EXPECT_EQ(fault_of(all[i]), std::nullopt);
            for (std::size_t k = 0; k < i; ++k) EXPECT_GT(separation(all[i], all[k]), -1e-5);
        }
        EXPECT_NEAR(sum, channel.length * channel.breadth, 1e-4);
    }
}

/// The cell of a point holds what is nearer to it than to any other point.
TEST(Drawn, ACellIsWhatIsNearestToItsPoint) {
    const int count = 40;
    RandomStream random(7, 0, StreamId::voronoi, 0);
    std::vector<Corner> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(channel.low_x, channel.low_x + channel.length);
        points.push_back({x, random.uniform(channel.low_z, channel.low_z + channel.breadth)});
    }
    const std::vector<Outline> all = cells(0, 0, count);
    for (double x = 2.13; x < 14; x += 0.37)
        for (double z = -0.93; z < 1; z += 0.21) {
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const Corner here = Corner{x, z} - points[i];
                const Corner best = Corner{x, z} - points[nearest];
                if (dot(here, here) < dot(best, best)) nearest = i;
            }
            EXPECT_TRUE(contains(all[nearest], {x, z}));
        }
}

TEST(Drawn, RelaxedCellsAreMoreAlike) {
    EXPECT_GT(spread(cells(0)), 1.5 * spread(cells(2)));
    EXPECT_GT(spread(cells(2)), 1.5 * spread(cells(50)));
}

/// Of very many cells of random points the areas vary by 0.53 (0.529 by Hilhorst and others, from memory); the walls
/// raise it little.
TEST(Drawn, AreasOfRandomCellsVaryAsKnown) {
    EXPECT_NEAR(spread(cells(0, 3, 4000)), 0.53, 0.03);
}

TEST(Drawn, ArePureFunctionsOfTheirStream) {
    EXPECT_EQ(cells(2), cells(2));
    EXPECT_NE(cells(2), cells(2, 1));
}

TEST(Drawn, ShrunkToAnArea) {
    const std::vector<Outline> all = cells(2);
    const Shrunk less = shrunk_to(all, 0.8 * channel.length * channel.breadth);
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        sum += area_of(less.outlines[i]);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(distance_between(less.outlines[i], less.outlines[k]), 2 * less.offset - 1e-5);
    }
    EXPECT_NEAR(sum, 0.8 * channel.length * channel.breadth, 1e-9);
}

TEST(Drawn, PolygonsHaveTheirAreaAndCorners) {
    for (std::uint32_t number = 0; number < 40; ++number) {
        RandomStream random(1, number, StreamId::polygons, 0);
        const int corners = 3 + static_cast<int>(number % 10);
        const Outline one = polygon_about(0.8, 0.4, corners, 0.9, random);
        EXPECT_EQ(one.size(), static_cast<std::size_t>(corners));
        EXPECT_EQ(fault_of(one), std::nullopt);
        EXPECT_NEAR(area_of(one), 0.32, 1e-12);
    }
    RandomStream random(1, 0, StreamId::polygons, 0);
    const Outline regular = polygon_about(1, 1, 6, 0, random);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(edge_length(regular, k), std::sqrt(2 / std::sqrt(27.0)), 1e-12);
}

}  // namespace drawn_test
}  // namespace floes
