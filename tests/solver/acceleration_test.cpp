// Sweeps over contacts that carry a thrust through many bodies (solver/direct_contacts.hpp), by closed form.

#include <gtest/gtest.h>

#include <vector>

#include "solver/lane_system.hpp"
#include "solver/lane_width.hpp"

namespace floes {
namespace acceleration_test {

constexpr double heavy = 200;  // kg
constexpr double speed = 0.1;  // m/s
constexpr int bodies = 12;
constexpr Sweeps enough{500, 1e-4};

struct Row {
    std::vector<SolverContact> contacts;
    std::vector<double> velocities;
    int sweeps;
};

/// A heavy body that comes against a row of bodies of 1 kg, each touching the next and the last one a wall.
Row pressed_row(int width, double friction) {
    std::vector<SolverBody> parts{SolverBody{}};
    for (int i = 1; i <= bodies; ++i) parts.push_back({i < bodies ? 1.0 : 1 / heavy, {2, 2, 2}});
    LaneSystem system(parts, {}, width, SolverKind::direct);
    Row row;
    for (std::uint32_t i = 0; i <= bodies; ++i) {
        SolverState state;
        state.position = {0.2 * i, 0, 0};
        if (i == bodies) state.velocity = {-speed, 0, 0};
        system.set_state(i, state);
        if (i == 0) continue;
        const std::array<double, 3> point{0.2 * i - 0.1, 0, 0};
        row.contacts.push_back(
            {.a = i, .b = i - 1, .on_a = point, .on_b = point, .normal = {1, 0, 0}, .friction = friction});
    }
    system.prepare(0.02);
    row.sweeps = system.solve(row.contacts,
                              {.split_impulse = false, .friction = Friction::cone, .normal = NormalLaw::rigid}, enough);
    system.advance();
    for (std::uint32_t i = 1; i <= bodies; ++i) row.velocities.push_back(system.state(i).velocity[0]);
    return row;
}

// Everything ends at rest, so each contact has passed on the momentum of the heavy body. 178 sweeps; Gauss-Seidel
// alone, which moves on some 1 kg x 0.1 m/s of 20 N s in each, takes 11,600 to the same tolerance.
TEST(Acceleration, CarriesAThrustThroughARowToTheWall) {
    const Row row = pressed_row(lane_widths().back(), 0.3);
    EXPECT_LT(row.sweeps, enough.most);
    for (const SolverContact& contact : row.contacts) EXPECT_NEAR(contact.impulse, heavy * speed, 0.01 * heavy * speed);
    for (const double velocity : row.velocities) EXPECT_NEAR(velocity, 0, 0.01 * speed);
}

// When it starts anew is decided by sums over contacts, which lanes must not reorder.
TEST(Acceleration, HasTheSameBitsAtEveryLaneWidth) {
    const Row one = pressed_row(1, 0.3);
    for (const int width : lane_widths()) {
        const Row other = pressed_row(width, 0.3);
        EXPECT_EQ(other.sweeps, one.sweeps) << width;
        EXPECT_EQ(other.velocities, one.velocities) << width;
        for (std::size_t i = 0; i < one.contacts.size(); ++i)
            EXPECT_EQ(other.contacts[i].impulse, one.contacts[i].impulse) << width << " lanes, contact " << i;
    }
}

}  // namespace acceleration_test
}  // namespace floes
