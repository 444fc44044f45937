// Bodies that carry water: closed forms by direction, what is conserved, and who refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "solver/lane_width.hpp"
#include "world/lanes_scene.hpp"

namespace floes::test {
namespace carried_water_test {

/// Water that lies off the middle, different in every direction.
constexpr CarriedWater lopsided{
    .in_plane = 0.4, .yaw = 0.003, .normal = 5.0, .x = 0.11, .z = -0.07, .xx = 0.02, .xz = 0.002, .zz = 0.015};

Vec3 ice_inertia() {
    const double thin = element_thickness * element_thickness;
    const double broad = element_side * element_side;
    return element_mass / 12 * Vec3(thin + broad, 2 * broad, thin + broad);
}

/// Momentum of body and water, and angular momentum about the origin, world axes.
struct Momenta {
    Vec3 linear, angular;
    double energy;
};

Momenta momenta(const BodyState& state, const CarriedWater& water) {
    const Vec3 v = state.rotation.transpose() * state.velocity;
    const Vec3 w = state.rotation.transpose() * state.angular_velocity;
    const Vec3 p(water.in_plane * v.x(), water.normal * v.y() - water.z * w.x() + water.x * w.z(),
                 water.in_plane * v.z());
    const Vec3 l(water.zz * w.x() - water.z * v.y() - water.xz * w.z(), water.yaw * w.y(),
                 water.x * v.y() - water.xz * w.x() + water.xx * w.z());
    const Vec3 linear = state.rotation * (p + element_mass * v);
    const Vec3 spin = l + Vec3(ice_inertia().array() * w.array());
    return {linear, state.rotation * spin + state.position.cross(linear),
            0.5 * (v.dot(p) + element_mass * v.squaredNorm() + w.dot(spin))};
}

TEST(CarriedWater, AddsItsMassByDirection) {
    World world(weightless(SolverKind::direct));
    const CarriedWater water{.in_plane = 0.4, .yaw = 0.003, .normal = 5.0, .xx = 0.02, .zz = 0.015};
    const Quat turn = turned(0.7, Vec3(1, 2, -1));
    const BodyId element = world.add_element(element_at(Vec3::Zero(), turn));
    world.set_water(element, water);
    world.apply(element, {turn * Vec3(1, 2, 3), turn * Vec3(0.1, 0.2, 0.3)});
    world.step();
    const Vec3 v = turn.inverse() * world.state(element).velocity / 0.02;
    const Vec3 w = turn.inverse() * world.state(element).angular_velocity / 0.02;
    EXPECT_NEAR(v.x(), 1 / (element_mass + 0.4), 1e-12);
    EXPECT_NEAR(v.y(), 2 / (element_mass + 5.0), 1e-12);
    EXPECT_NEAR(v.z(), 3 / (element_mass + 0.4), 1e-12);
    EXPECT_NEAR(w.x(), 0.1 / (ice_inertia().x() + 0.015), 1e-11);
    EXPECT_NEAR(w.y(), 0.2 / (ice_inertia().y() + 0.003), 1e-11);
    EXPECT_NEAR(w.z(), 0.3 / (ice_inertia().z() + 0.02), 1e-11);
}

// A force beside the centre of the water turns the body, as it would one whose mass lies there.
TEST(CarriedWater, LiesWhereItsFirstMomentsSay) {
    World world(weightless(SolverKind::direct));
    const BodyId element = world.add_element(element_at(Vec3::Zero()));
    const double heavy = 1e6;
    world.set_water(element, {.normal = heavy, .x = heavy * 0.03, .xx = heavy * 0.03 * 0.03});
    world.apply(element, {Vec3(0, 1, 0), Vec3::Zero()});
    world.step();
    const BodyState state = world.state(element);
    // The water at x = 0.03 m hardly moves: the body swings about it.
    EXPECT_NEAR(state.velocity.y() + 0.03 * state.angular_velocity.z(), 0, 1e-6);
    EXPECT_NEAR(state.velocity.y(), 0.02 * 0.0009 / (ice_inertia().z() + element_mass * 0.0009), 1e-7);
}

/// What a body adrift has lost of its momenta and its energy after half a second of tumbling, as shares.
Momenta lost(double time_step) {
    WorldDefinition definition = weightless(SolverKind::direct);
    definition.time_step = time_step;
    World world(definition);
    const BodyId element = world.add_element(element_at({0.1, 0.2, -0.3}));
    world.set_water(element, lopsided);
    const BodyState state = set_moving(world, element, {0.3, -0.2, 0.1}, {0.9, 0.5, -0.7});
    const Momenta before = momenta(state, lopsided);
    for (int i = 0; i < static_cast<int>(std::lround(0.5 / time_step)); ++i) world.step();
    const Momenta after = momenta(world.state(element), lopsided);
    return {(after.linear - before.linear) / before.linear.norm(),
            (after.angular - before.angular) / before.angular.norm(), after.energy / before.energy - 1};
}

// Kirchhoff's equations keep momentum, moment of momentum and energy; steps lose them in the first order of Δt.
TEST(CarriedWater, KeepsMomentumAndEnergyAsItTumbles) {
    const Momenta coarse = lost(0.0005);
    const Momenta fine = lost(0.00025);
    EXPECT_LT(fine.linear.norm(), 2e-3);
    EXPECT_LT(fine.angular.norm(), 2e-3);
    EXPECT_LT(std::abs(fine.energy), 2e-3);
    EXPECT_NEAR(coarse.linear.norm() / fine.linear.norm(), 2, 0.1);
    EXPECT_NEAR(coarse.angular.norm() / fine.angular.norm(), 2, 0.1);
    EXPECT_NEAR(coarse.energy / fine.energy, 2, 0.1);
}

JointSpring stiff() {
    return {.force = {1e6, 1e5, 1e6}, .moment = {1e3, 1e4, 1e3}, .damping_ratio = 1};
}

// A piece that falls and spins turns by radians a step, where a step that looks ahead gains energy without end.
TEST(CarriedWater, DoesNotRunAwayWithABodyThatSpinsFast) {
    World world(weightless(SolverKind::direct));
    const BodyId element = world.add_element(element_at(Vec3::Zero()));
    world.set_water(element, lopsided);
    const double before = momenta(set_moving(world, element, {1, 2, -0.5}, {40, -20, 30}), lopsided).energy;
    for (int step = 0; step < 1000; ++step) {
        world.step();
        ASSERT_LT(momenta(world.state(element), lopsided).energy, 1.1 * before) << step;
    }
}

// Two elements held together move as one body with the water of both.
TEST(CarriedWater, OfAPieceIsThatOfItsElements) {
    World world(weightless(SolverKind::direct));
    const BodyId a = world.add_element(element_at({-0.1, 0, 0}, Quat::Identity(), 0));
    const BodyId b = world.add_element(element_at({0.1, 0, 0}, Quat::Identity(), 0));
    world.add_joint({.a = a, .b = b, .spring = stiff()});
    world.set_water(a, {.normal = 2.0, .x = 0.05, .xx = 0.01});
    world.set_water(b, {.normal = 3.0, .x = -0.06, .xx = 0.02});
    for (int i = 0; i < 200; ++i) {
        world.apply(a, {Vec3(0, 0.001, 0), Vec3::Zero()});
        world.apply(b, {Vec3(0, 0.001, 0), Vec3(0, 0, 1e-4)});
        world.step();
    }
    const double mass = 2 * element_mass + 5;
    const double first = 0.05 - 0.06 + 0.1 * (3.0 - 2.0);
    const double inertia =
        2 * (ice_inertia().z() + element_mass * 0.01) + 0.01 + 0.02 + 0.01 * 5 - 2 * 0.1 * 0.05 + 2 * 0.1 * -0.06;
    // [mass first; first inertia] (a_y, alpha) = (0.002 N, 1e-4 N m), for 4 s.
    const double determinant = mass * inertia - first * first;
    const double lift = 4 * (inertia * 0.002 - first * 1e-4) / determinant;
    const double turn = 4 * (mass * 1e-4 - first * 0.002) / determinant;
    const Vec3 mean = (world.state(a).velocity + world.state(b).velocity) / 2;
    EXPECT_NEAR(mean.y(), lift, 1e-3 * lift);
    EXPECT_NEAR(world.state(a).angular_velocity.z(), turn, 1e-3 * turn);
}

// An impact feels the water: the impulse that stops a body and its water is their momentum.
TEST(CarriedWater, IsStoppedByContacts) {
    WorldDefinition definition = weightless(SolverKind::direct);
    definition.contact.erp = 0;
    definition.iterations = 500;
    World world(definition);
    const BodyId element = world.add_element(element_at({0, 0.05, 0}));
    world.add_fixed_box({.half_extents = {1, 0.01, 1}, .pose = {.position = {0, 0, 0}}});
    world.set_water(element, {.normal = 5.0});
    set_moving(world, element, {0, -0.5, 0});
    double impulse = 0;
    for (int i = 0; i < 10; ++i) {
        world.step();
        impulse += world.contact_force(element).y() * 0.02;
    }
    EXPECT_NEAR(world.state(element).velocity.y(), 0, 1e-9);
    EXPECT_NEAR(impulse, 0.5 * (element_mass + 5.0), 1e-6);
}

TEST(CarriedWater, HasTheSameBitsAtEveryWidth) {
    std::vector<LanesScene> scenes;
    for (const int width : lane_widths()) {
        LanesScene& scene = scenes.emplace_back(solved_by(SolverKind::direct, width));
        for (const BodyId element : scene.elements) scene.world.set_water(element, lopsided);
        for (int i = 0; i < 40; ++i) {
            if (i == 20) scene.break_joints(7);
            scene.step();
        }
        for (std::size_t i = 0; i < scene.elements.size(); ++i) {
            EXPECT_TRUE(same_bits(scene.world.state(scene.elements[i]), scenes[0].world.state(scene.elements[i])));
        }
    }
}

// Lengths in a unit of the world's own are the same water (FroudeUnits, world/world.cpp).
TEST(CarriedWater, IsTheSameInEveryUnitOfLength) {
    std::vector<BodyState> ends;
    for (const double unit : {1.0, 3.0}) {
        WorldDefinition definition = weightless(SolverKind::direct);
        definition.length_unit = unit;
        World world(definition);
        const BodyId element = world.add_element(element_at(Vec3::Zero()));
        world.set_water(element, lopsided);
        for (int i = 0; i < 20; ++i) {
            world.apply(element, {Vec3(0.1, 0.2, 0.3), Vec3(0.01, 0.02, 0.03)});
            world.step();
        }
        ends.push_back(world.state(element));
    }
    EXPECT_LT((ends[0].velocity - ends[1].velocity).norm(), 1e-12);
    EXPECT_LT((ends[0].angular_velocity - ends[1].angular_velocity).norm(), 1e-12);
}

TEST(CarriedWater, IsRefusedBySweepsAndWhereItCannotBe) {
    for (const SolverKind solver : {SolverKind::stock, SolverKind::lanes}) {
        World world(solved_by(solver));
        const BodyId element = world.add_element(element_at(Vec3::Zero()));
        EXPECT_THROW(world.set_water(element, {.normal = 1}), InputError);
    }
    World world(weightless(SolverKind::direct));
    const BodyId element = world.add_element(element_at(Vec3::Zero()));
    EXPECT_THROW(world.set_water(element, {.normal = -1}), InputError);
    EXPECT_THROW(world.set_water(element, {.yaw = NAN}), InputError);
    EXPECT_THROW(world.set_water(element, {.normal = 1, .x = 0.2, .xx = 0.01}), InputError);
}

}  // namespace carried_water_test
}  // namespace floes::test
