#include "arrangement/crowd.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/random.hpp"

namespace floes {
namespace cells_test {

/// Points on an area and beyond its edges, 40 of them at one place.
std::vector<Resident> scattered_points() {
    RandomStream random(1, 0, StreamId::scattering, 0);
    std::vector<Resident> points;
    for (int i = 0; i < 400; ++i) {
        points.push_back({i % 10 == 0 ? 3.0 : random.uniform(-1, 9), i % 10 == 0 ? 2.0 : random.uniform(-1, 6), {}, i});
    }
    return points;
}

std::set<int> found_near(const Cells& cells, const Resident& point, double reach) {
    std::set<int> found;
    cells.for_each_near(point.x, point.z, [&](const Resident& other) {
        const double dx = other.x - point.x;
        const double dz = other.z - point.z;
        if (dx * dx + dz * dz > reach * reach) return;
        EXPECT_TRUE(found.insert(other.floe).second) << other.floe;
    });
    return found;
}

std::set<int> all_near(const std::vector<Resident>& points, const Resident& point, double reach) {
    std::set<int> found;
    for (const Resident& other : points) {
        const double dx = other.x - point.x;
        const double dz = other.z - point.z;
        if (dx * dx + dz * dz <= reach * reach) found.insert(other.floe);
    }
    return found;
}

TEST(Cells, FindAllWithinReachOnce) {
    const std::vector<Resident> points = scattered_points();
    for (const double reach : {0.1, 0.5, 1.0, 2.0, 20.0}) {
        Cells cells({0, 0, 8, 5}, reach, points.size());
        for (const Resident& point : points) cells.insert(point);
        for (const Resident& point : points) EXPECT_EQ(found_near(cells, point, reach), all_near(points, point, reach));
    }
}

TEST(Cells, FindAllAfterMoves) {
    const double reach = 0.7;
    std::vector<Resident> points = scattered_points();
    Cells cells({0, 0, 8, 5}, reach, points.size());
    for (const Resident& point : points) cells.insert(point);
    RandomStream random(2, 0, StreamId::scattering, 0);
    for (Resident& point : points) {
        point.x += random.uniform(-2, 2);
        point.z += random.uniform(-2, 2);
        cells.move(point);
    }
    for (const Resident& point : points) EXPECT_EQ(found_near(cells, point, reach), all_near(points, point, reach));
}

TEST(Cells, OfPointsAtOnePlaceAreOne) {
    Cells cells({3, 2, 0, 0}, 0, 40);
    for (int i = 0; i < 40; ++i) cells.insert({3, 2, {}, i});
    EXPECT_EQ(found_near(cells, {3, 2, {}, 0}, 0).size(), 40u);
}

}  // namespace cells_test
}  // namespace floes
