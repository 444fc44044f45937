// The cone at the level of rows: what an impulse starts from, that it stays in the cone, and the same bits at every
// lane width. What the law does to bodies: tests/world/cone_test.cpp.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "solver/bullet_scene.hpp"
#include "solver/lane_width.hpp"

namespace floes::testing {
namespace friction_cone_test {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector scaled(const Vector& a, double k) {
    return {a[0] * k, a[1] * k, a[2] * k};
}

Vector unit(const Vector& a) {
    return scaled(a, 1 / std::sqrt(dot(a, a)));
}

/// A floating box with one contact, solved in no sweeps: the impulses that it starts from come back.
SolverContact started(const Vector& normal, const Vector& friction, double impulse) {
    const SolverBody box{0.8, {2, 3, 4}};
    LaneSystem system(std::vector<SolverBody>{box, {}}, {}, 1);
    system.prepare(0.02);
    const double size = std::sqrt(dot(friction, friction));
    std::vector<SolverContact> contact{{.a = 0,
                                        .b = 1,
                                        .on_a = {0.1, 0.02, -0.3},
                                        .on_b = {0.1, 0.02, -0.3},
                                        .normal = normal,
                                        .friction = 0.5,
                                        .impulse = impulse,
                                        .slide = scaled(friction, 1 / size),
                                        .friction_impulse = size}};
    system.solve(contact, {.friction = Friction::cone}, {0});
    return contact[0];
}

// The impulse is carried in world axes: its part in the contact plane, whatever the plane, cut to the cone.
TEST(FrictionCone, StartsFromTheSameVectorWhateverTheNormal) {
    const Vector friction{0.3, -0.2, 0.1};
    for (const Vector& direction : std::vector<Vector>{{1, 0, 0},
                                                       {-1, 0, 1e-12},
                                                       {-1, 0, -1e-12},
                                                       {0, 0, 1},
                                                       {0, 0, -1},
                                                       {0, 1, 0},
                                                       {1, 2, 3},
                                                       {1, -2, -3},
                                                       {-3, 1, 0}}) {
        const Vector normal = unit(direction);
        const double lost = dot(friction, normal);
        const Vector expected{friction[0] - lost * normal[0], friction[1] - lost * normal[1],
                              friction[2] - lost * normal[2]};
        for (const double impulse : {10.0, 0.4, 0.0}) {
            const double size = std::sqrt(dot(expected, expected));
            const double cut = std::min(1.0, 0.5 * impulse / size);
            const SolverContact contact = started(normal, friction, impulse);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(contact.slide[k] * contact.friction_impulse, cut * expected[k], 1e-15);
            }
            EXPECT_NEAR(contact.impulse, impulse, 1e-15);
        }
    }
}

// A ball falls on a point beside its middle: one sweep. The normal row, inverse mass 0.5 + 2 * 0.3², makes the point
// slide by 2 * 0.3 * 0.4 an impulse; friction sees that, and the stiffest direction in the plane has inverse mass 1.
TEST(FrictionCone, SeesInTheSameSweepWhatTheNormalRowDid) {
    for (const bool along_x : {true, false}) {
        LaneSystem system(std::vector<SolverBody>{{0.5, {2, 2, 2}}, {}}, {}, 1);
        system.set_state(0, {.velocity = {0, 0, -1}});
        system.prepare(0.02);
        const Vector point{along_x ? 0.3 : 0, along_x ? 0 : 0.3, -0.4};
        std::vector<SolverContact> contact{
            {.a = 0, .b = 1, .on_a = point, .on_b = point, .normal = {0, 0, 1}, .friction = 5}};
        system.solve(contact, {.friction = Friction::cone}, {1});
        const double normal = 1 / 0.68;
        EXPECT_NEAR(contact[0].impulse, normal, 1e-14);
        const Vector friction = scaled(contact[0].slide, contact[0].friction_impulse);
        EXPECT_NEAR(friction[0], along_x ? -0.24 * normal : 0, 1e-14);
        EXPECT_NEAR(friction[1], along_x ? 0 : -0.24 * normal, 1e-14);
    }
}

/// Contacts of a packed scene, solved in lanes by the law at every tenth step.
std::vector<SolverContact> packed(Friction friction, int width) {
    BulletScene scene({});
    ContactLaw law = scene.law();
    law.friction = friction;
    std::vector<SolverContact> all;
    int steps = 0;
    scene.solver.before = [&](std::span<btPersistentManifold*> manifolds) {
        if (++steps % 10 != 0) return;
        LaneSystem system = scene.lane_system(width);
        std::vector<SolverContact> contacts = scene.contacts(manifolds);
        for (SolverContact& contact : contacts) {  // something to start from, more than the cone allows
            contact.slide = unit({1, 0.3, -0.5});
            contact.friction_impulse = contact.impulse;
        }
        system.solve(contacts, law, {BulletScene::iterations});
        all.insert(all.end(), contacts.begin(), contacts.end());
    };
    for (int i = 0; i < 100; ++i) scene.step();
    return all;
}

int beyond_the_cone(const std::vector<SolverContact>& contacts) {
    int count = 0;
    for (const SolverContact& contact : contacts) {
        count += std::abs(contact.friction_impulse) > contact.friction * contact.impulse * (1 + 1e-12);
    }
    return count;
}

TEST(FrictionCone, NoContactOfAPackedSceneExceedsIt) {
    const std::vector<SolverContact> contacts = packed(Friction::cone, lane_widths().back());
    EXPECT_EQ(beyond_the_cone(contacts), 0);
    int sliding = 0, sticking = 0;
    for (const SolverContact& contact : contacts) {
        const double bound = contact.friction * contact.impulse;
        sliding += bound > 0 && contact.friction_impulse > 0.999 * bound;
        sticking += bound > 0 && contact.friction_impulse < 0.9 * bound;
        EXPECT_LE(std::abs(dot(contact.slide, contact.normal)), 1e-12);
    }
    EXPECT_GT(sliding, 20);
    EXPECT_GT(sticking, 20);
    EXPECT_GT(beyond_the_cone(packed(Friction::one_direction, lane_widths().back())), 0)
        << "there friction keeps its impulse when the normal one is gone";
}

/// Speed at which contacts that stick slide nevertheless after so many sweeps, m/s: mean over the contacts of a packed
/// scene, weighted by their normal impulses. Friction starts from nothing, so this is the worst case: in a run it
/// starts from the step before.
double slip_of_sticking_contacts(int sweeps) {
    BulletScene scene({});
    ContactLaw law = scene.law();
    law.friction = Friction::cone;
    double slip = 0;
    double weight = 0;
    int steps = 0;
    scene.solver.before = [&](std::span<btPersistentManifold*> manifolds) {
        if (++steps % 10 != 0) return;
        LaneSystem system = scene.lane_system(lane_widths().back());
        std::vector<SolverContact> contacts = scene.contacts(manifolds);
        for (SolverContact& contact : contacts) contact.friction_impulse = 0;
        std::vector<SolverState> before;
        for (std::size_t i = 0; i < system.body_count(); ++i) before.push_back(system.state(i));
        system.solve(contacts, law, {sweeps});
        system.advance();
        const auto velocity = [&](std::uint32_t body, const Vector& point) {
            const auto [position, rotation, linear, angular_velocity] = system.state(body);
            const Vector& from = before[body].position;
            const Vector r{point[0] - from[0], point[1] - from[1], point[2] - from[2]};
            return Vector{linear[0] + angular_velocity[1] * r[2] - angular_velocity[2] * r[1],
                          linear[1] + angular_velocity[2] * r[0] - angular_velocity[0] * r[2],
                          linear[2] + angular_velocity[0] * r[1] - angular_velocity[1] * r[0]};
        };
        for (const SolverContact& contact : contacts) {
            if (!(contact.friction_impulse < 0.99 * contact.friction * contact.impulse)) continue;
            const Vector a = velocity(contact.a, contact.on_a);
            const Vector b = velocity(contact.b, contact.on_b);
            Vector u{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
            const double along = dot(u, contact.normal);
            for (std::size_t k = 0; k < 3; ++k) u[k] -= along * contact.normal[k];
            slip += contact.impulse * std::sqrt(dot(u, u));
            weight += contact.impulse;
        }
    };
    for (int i = 0; i < 100; ++i) scene.step();
    return slip / weight;
}

TEST(FrictionCone, ContactsThatStickSlideLessWithEverySweep) {
    const double first = slip_of_sticking_contacts(10);
    double last = first;
    for (const int sweeps : {20, 50, 100, 200, 400}) {
        const double slip = slip_of_sticking_contacts(sweeps);
        std::printf("%3d sweeps: sticking contacts slide at %.3g m/s\n", sweeps, slip);
        EXPECT_LT(slip, last) << sweeps;
        last = slip;
    }
    EXPECT_LT(last, 0.1 * first);
}

TEST(FrictionCone, EveryWidthGivesTheSameBits) {
    const std::vector<SolverContact> one = packed(Friction::cone, 1);
    for (const int width : lane_widths()) {
        const std::vector<SolverContact> other = packed(Friction::cone, width);
        ASSERT_EQ(other.size(), one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_EQ(other[i].impulse, one[i].impulse);
            EXPECT_EQ(other[i].friction_impulse, one[i].friction_impulse);
            EXPECT_EQ(other[i].slide, one[i].slide);
        }
    }
}

}  // namespace friction_cone_test
}  // namespace floes::testing
