// Loads on parts of a hull, of contacts that are given.

#include "simulation/hull_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/barge.hpp"

namespace floes {
namespace hull_loads_test {

Scenario with_barge() {
    Scenario scenario;
    scenario.structure.shape = test::barge();
    scenario.structure.start = 0;
    return scenario;
}

// A bow at 45° is pressed on by F, which is F / √2 of surge and of heave, and rubbed on by friction, which is no
// pressure; two contacts that face each other on a side press with the sum of their forces.
TEST(HullLoads, PressesOnAPartAlongItsNormals) {
    const Scenario scenario = with_barge();
    const Shape& shape = scenario.structure.shape;
    HullLoads loads(shape, shape.overlapping_solids(), 4);
    const StructureMotion motion(scenario);
    const Vec3 at = motion.after().position;
    const BodyId hull(0);
    const BodyId floe(1);
    const double half = std::sqrt(0.5);
    const std::vector<double> forces{100, 300, 200, 0};
    for (const double force : forces) {
        const std::vector<ContactForce> contacts{
            {hull, floe, at + Vec3(30, 0, 2), force * Vec3(-half, half, 0), 0.1 * force * Vec3(half, half, 0), 0},
            {floe, hull, at + Vec3(5, 0, -10), force * Vec3(0, 0, -1), Vec3::Zero(), 0},
            {hull, floe, at + Vec3(-5, 0, -10), force * Vec3(half, 0, half), Vec3::Zero(), 0}};
        loads.add(contacts, hull, motion.after(), Vec3::Zero());
    }
    const std::vector<double> times{1, 2};
    const std::vector<PartLoad> parts =
        loads.parts({.time_step = 1, .segments = 1, .times = times, .peak_separation = 1});
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_NEAR(parts[0].normal_maximum[0], 300, 1e-9);
    EXPECT_NEAR(parts[0].normal_maximum[1], 250, 1e-9);
    EXPECT_NEAR(parts[0].maximum, (half - 0.1 * half) * 300, 1e-9);
    EXPECT_NEAR(parts[0].mean_heave, (half + 0.1 * half) * 150, 1e-9);
    EXPECT_NEAR(parts[2].normal_maximum[0], 600, 1e-9);  // port
    EXPECT_NEAR(parts[2].mean_sway, (1 + half) * 150, 1e-9);
    EXPECT_EQ(parts[3].normal_maximum, std::vector<double>(2, 0.0));
}

}  // namespace hull_loads_test
}  // namespace floes
