// A Voronoi diagram without end: each of its cells as if all points had been known from the beginning.

#include "shapes/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace floes {
namespace endless_cells_test {

constexpr int points_in_strip = 20;
const WaterArea strip{2, -1, 4, 2};

std::vector<Corner> points_of(std::uint64_t number) {
    RandomStream random(7, 0, StreamId::voronoi, number);
    std::vector<Corner> points;
    for (int i = 0; i < points_in_strip; ++i) {
        const double x = random.uniform(0, strip.length);
        points.push_back({strip.low_x + static_cast<double>(number) * strip.length + x,
                          random.uniform(strip.low_z, strip.low_z + strip.breadth)});
    }
    return points;
}

/// The cells of so many strips at once, after Lloyd's steps, by the x of their centroids.
std::vector<Outline> at_once(std::uint64_t strips, int relaxations) {
    std::vector<Corner> points;
    for (std::uint64_t k = 0; k < strips; ++k) {
        const std::vector<Corner> more = points_of(k);
        points.insert(points.end(), more.begin(), more.end());
    }
    const WaterArea area{strip.low_x, strip.low_z, static_cast<double>(strips) * strip.length, strip.breadth};
    std::vector<Outline> cells;
    for (int step = 0; step <= relaxations; ++step) {
        std::ranges::sort(points);
        cells.clear();
        for (std::size_t i = 0; i < points.size(); ++i) cells.push_back(voronoi_cell(area, points, i));
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = measures_of(cells[i]).centroid;
    }
    std::ranges::sort(cells, {}, [](const Outline& one) { return measures_of(one).centroid; });
    return cells;
}

/// Largest distance of a corner of one from the nearest of the other.
double difference(Corners one, Corners other) {
    double largest = 0;
    for (const Corner& corner : one) {
        double nearest = 1e9;
        for (const Corner& to : other) nearest = std::min(nearest, dot(corner - to, corner - to));
        largest = std::max(largest, nearest);
    }
    return std::sqrt(largest);
}

TEST(EndlessCells, AreThoseOfAllPointsAtOnce) {
    for (const int relaxations : {0, 1, 2, 5}) {
        const std::vector<Outline> all = at_once(14, relaxations);
        EndlessCells cells(strip, relaxations);
        std::size_t found = 0;
        for (std::uint64_t k = 0; k < 14; ++k) {
            cells.add(points_of(k));
            // Some are taken now and some later.
            const std::size_t taken = cells.ready() - cells.ready() / 3;
            for (std::size_t i = 0; i < taken; ++i, ++found) {
                EXPECT_LT(difference(cells.cell(i), all[found]), 1e-5) << relaxations << ' ' << found;
                EXPECT_LT(difference(all[found], cells.cell(i)), 1e-5) << relaxations << ' ' << found;
            }
            cells.take(taken);
        }
        EXPECT_GT(found, 120u) << relaxations;
    }
}

// What is known lies some two cells behind for each step: a cell of this diagram is 0.63 m wide on average.
TEST(EndlessCells, AreCertainSomeCellsBehindTheLastPoints) {
    for (const int relaxations : {0, 2, 5}) {
        EndlessCells cells(strip, relaxations);
        for (std::uint64_t k = 0; k < 6; ++k) cells.add(points_of(k));
        const double behind = strip.low_x + 6 * strip.length - cells.middle_x(cells.ready() - 1);
        EXPECT_GT(behind, 0.3);
        EXPECT_LT(behind, 2.5 * 0.63 * (relaxations + 1)) << relaxations;
    }
}

TEST(EndlessCells, LeaveNothingBetweenThem) {
    EndlessCells cells(strip, 2);
    for (std::uint64_t k = 0; k < 8; ++k) cells.add(points_of(k));
    std::vector<Outline> laid;
    double front = 1e9;  // of the cells that are not laid
    for (std::size_t i = 0; i < cells.ready(); ++i) laid.push_back(cells.cell(i));
    for (std::uint64_t k = 8; k < 12; ++k) cells.add(points_of(k));
    for (std::size_t i = laid.size(); i < cells.ready(); ++i)
        for (const Corner& corner : cells.cell(i)) front = std::min(front, corner.x);
    int inside = 0;
    for (double x = strip.low_x + 0.05; x < front; x += 0.11)
        for (double z = -0.97; z < 1; z += 0.13, ++inside)
            EXPECT_EQ(std::ranges::count_if(laid,
                                            [&](const Outline& one) {
                                                return contains(one, {x, z});
                                            }),
                      1)
                << x << ' ' << z;
    EXPECT_GT(inside, 2000);
}

}  // namespace endless_cells_test
}  // namespace floes
