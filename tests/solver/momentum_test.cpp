// Momentum and angular momentum of a solve: each body's change is what its contacts exerted on it, to rounding, when
// each impulse is counted where it acts on that body. Counted in the middle between the two surfaces, as forces are
// drawn, a body's angular momentum misses half of (overlap x friction).

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/vector.hpp"
#include "solver/lane_system.hpp"

namespace floes {
namespace momentum_test {

Vec3 vec(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

constexpr double mass = 1.2;
constexpr double time_step = 0.02;

struct Heap {
    std::vector<SolverBody> bodies;
    std::vector<SolverState> states;
    std::vector<SolverContact> contacts;
};

/// Boxes at rest but for their velocities, and contacts among them and with a fixed one at random places: what points
/// are given does not matter to momentum.
Heap random_heap() {
    std::mt19937 random(5);
    const auto number = [&] { return 2 * (static_cast<double>(random()) / 4294967296.0) - 1; };
    Heap heap;
    for (int i = 0; i < 12; ++i) {
        SolverBody body;
        if (i > 0) {
            body.inverse_mass = 1 / mass;
            body.inverse_inertia = {240, 120, 240};
        }
        body.half_extent = {0.1, 0.0165, 0.1};
        heap.bodies.push_back(body);
        SolverState state;
        state.position = {number(), number(), number()};
        if (i > 0) state.velocity = {number(), number(), number()};
        heap.states.push_back(state);
    }
    for (std::uint32_t b = 1; b < 12; ++b) {
        for (std::uint32_t a = 0; a < b; a += 3) {
            const Vec3 normal = Vec3(number(), number(), number()).normalized();
            const Vec3 place = 0.5 * (vec(heap.states[a].position) + vec(heap.states[b].position));
            const double distance = -0.005 * std::abs(number());
            SolverContact contact;
            contact.a = a;
            contact.b = b;
            for (Eigen::Index k = 0; k < 3; ++k) {
                const auto at = static_cast<std::size_t>(k);
                contact.normal[at] = normal[k];
                contact.on_b[at] = place[k];
                contact.on_a[at] = place[k] + distance * normal[k];
            }
            contact.distance = distance;
            contact.friction = 0.3;
            heap.contacts.push_back(contact);
        }
    }
    return heap;
}

struct Balance {
    double momentum = 0;    ///< largest error of a body, N s
    double own_points = 0;  ///< of its angular momentum about a far axis, N m s
    double middles = 0;     ///< the same with impulses between the two surfaces
    double together = 0;    ///< of all, less the couples of friction across the overlaps
    double couples = 0;     ///< these, N m s
    double largest = 0;     ///< impulse, N s
};

Balance balance_of(SolverKind solver) {
    Heap heap = random_heap();
    LaneSystem system(heap.bodies, {}, 1, solver);
    for (std::size_t i = 0; i < heap.states.size(); ++i) system.set_state(i, heap.states[i]);
    ContactLaw law;
    law.friction = Friction::cone;
    law.normal = NormalLaw::rigid;
    law.split_impulse = false;
    system.prepare(time_step);
    system.solve(heap.contacts, law, {30, 0});
    system.advance();
    const Vec3 axis(7, -3, 4);
    std::vector<Vec3> linear(12, Vec3::Zero()), own(12, Vec3::Zero()), middle(12, Vec3::Zero());
    Balance found;
    Vec3 couples = Vec3::Zero();
    for (const SolverContact& one : heap.contacts) {
        const Vec3 impulse = vec(one.normal) * one.impulse + vec(one.slide) * one.friction_impulse;
        found.largest = std::max(found.largest, impulse.norm());
        const Vec3 between = 0.5 * (vec(one.on_a) + vec(one.on_b)) - axis;
        for (const auto& [body, sign, point] : {std::tuple(one.a, 1.0, vec(one.on_a)), {one.b, -1.0, vec(one.on_b)}}) {
            linear[body] += sign * impulse;
            own[body] += (point - axis).cross(sign * impulse);
            middle[body] += between.cross(sign * impulse);
        }
        if (one.a != 0) couples += (vec(one.on_a) - vec(one.on_b)).cross(impulse);
    }
    Vec3 sum = Vec3::Zero();
    Vec3 from_outside = Vec3::Zero();
    for (std::size_t i = 1; i < 12; ++i) {
        const SolverState end = system.state(i);
        const Vec3 faster = mass * (vec(end.velocity) - vec(heap.states[i].velocity));
        const Vec3 turning = Vec3(1 / 240.0, 1 / 120.0, 1 / 240.0).cwiseProduct(vec(end.angular_velocity));
        const Vec3 change = (vec(heap.states[i].position) - axis).cross(faster) + turning;
        found.momentum = std::max(found.momentum, (faster - linear[i]).norm());
        found.own_points = std::max(found.own_points, (change - own[i]).norm());
        found.middles = std::max(found.middles, (change - middle[i]).norm());
        sum += change;
    }
    for (const SolverContact& one : heap.contacts) {
        if (one.a != 0) continue;  // of the fixed body, on b
        const Vec3 impulse = vec(one.normal) * one.impulse + vec(one.slide) * one.friction_impulse;
        from_outside -= (vec(one.on_b) - axis).cross(impulse);
    }
    found.together = (sum - from_outside - couples).norm();
    found.couples = couples.norm();
    return found;
}

TEST(Momentum, OfEachBodyIsWhatItsContactsExertWhereTheyActOnIt) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        const Balance found = balance_of(solver);
        ASSERT_GT(found.largest, 0.2);
        EXPECT_LT(found.momentum, 1e-13);
        EXPECT_LT(found.own_points, 1e-12);
        EXPECT_GT(found.middles, 1e-5) << "the middles would do as well, and this test could not fail";
    }
}

// Friction acts on the two bodies at points that an overlap apart, as Bullet has it: a couple of overlap x friction is
// all that the system's angular momentum changes by from within.
TEST(Momentum, OfAllChangesFromWithinOnlyByFrictionAcrossOverlaps) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        const Balance found = balance_of(solver);
        EXPECT_LT(found.together, 1e-12);
        EXPECT_GT(found.couples, 1e-5);
        EXPECT_LT(found.couples, 44 * 0.005 * 0.3 * found.largest);
    }
}

}  // namespace momentum_test
}  // namespace floes
