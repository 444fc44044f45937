// Blows of ice that crushes, in steps longer and shorter than the blow: what it exerts, and how far it has crushed the
// edge. An edge whose area grows as c / p per depth is a spring c until the bodies stand: with the mass m that meets
// the contact at the speed v it is crushed by v √(m / c), and yields from then on at v √(m c), the peak of the blow. So
// a load that is put on slowly moves it from there on, and not before.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene.hpp"

namespace floes::test {
namespace blows_test {

constexpr double strength = 145.6e3;  // compressive, Table 1
constexpr double speed = 0.01;        // slow, so that nothing turns far in a blow: the law is linear
constexpr double time_steps[] = {0.04, 0.02, 0.01, 0.005};
const double pi = std::acos(-1.0);
const double inertia_upright = element_mass * element_side * element_side / 6;
const double inertia_across = element_mass * (element_side * element_side + element_thickness * element_thickness) / 12;

/// The default's contacts, without friction.
WorldDefinition world_of(double time_step, double tolerance = 0) {
    return {.time_step = time_step,
            .iterations = 500,
            .tolerance = tolerance,
            .gravity = 0,
            .contact = {.ice_ice_friction = 0,
                        .ice_structure_friction = 0,
                        .split_impulse = false,
                        .friction = Friction::cone,
                        .normal = NormalLaw::crushing,
                        .crushing_pressure = strength,
                        .internal_edges = false},
            .solver = SolverKind::direct};
}

/// An element, turned, flies along x at a wall.
struct Scene {
    Quat of_box = Quat::Identity();
    Vec3 vertex = Vec3::Zero();  ///< where it meets the wall, from its centre in its own axes

    static Vec3 normal() { return -Vec3::UnitX(); }
    Vec3 lever() const { return of_box * vertex; }
    /// That meets the contact: 1/m + (r x n) . I^-1 (r x n).
    double mass() const {
        const Vec3 arm = of_box.inverse() * lever().cross(normal());
        return 1 / (1 / element_mass + (arm.x() * arm.x() + arm.z() * arm.z()) / inertia_across +
                    arm.y() * arm.y() / inertia_upright);
    }

    /// Of an edge along the axis of the element that lies in the wall: p length / (the two other cosines).
    double stiffness() const {
        const Vec3 cosines = (of_box.inverse() * normal()).cwiseAbs();
        const Vec3 size(element_side, element_thickness, element_side);
        for (int k = 0; k < 3; ++k)
            if (cosines[k] < 1e-9) return strength * size[k] / (cosines[(k + 1) % 3] * cosines[(k + 2) % 3]);
        return 0;
    }
};

Scene upright_edge(double yaw) {
    return {.of_box = turned(yaw, Vec3::UnitY()), .vertex = Vec3(element_side, 0, element_side) / 2};
}

struct Blow {
    double impulse = 0;    ///< N s, along the normal
    double yields_at = 0;  ///< N, afterwards
};

/// Share: of a step's way that is left to go when a step begins.
Blow blow(const Scene& scene, double time_step, double share) {
    World world(world_of(time_step));
    world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
    const Vec3 start = share * time_step * speed * scene.normal() - scene.lever();
    const BodyId body = world.add_element(element_at(start, scene.of_box));
    BodyState state = world.state(body);
    state.velocity = Vec3(speed, 0, 0);
    world.place(body, state);
    Blow found;
    for (double force = 0; force > 0 || found.impulse == 0; found.impulse += force * time_step) {
        world.step();
        force = world.contact_force(body).dot(scene.normal());
        if (force < 1e-9) force = 0;
    }
    const BodyState after = world.state(body);
    const Vec3 turning = after.rotation.transpose() * after.angular_velocity;
    const Vec3 momentum = Vec3(inertia_across, inertia_upright, inertia_across).cwiseProduct(turning);
    world.apply(body, {-element_mass / time_step * after.velocity, after.rotation * -momentum / time_step});
    world.step();
    const double expected = speed * std::sqrt(scene.mass() * scene.stiffness());
    for (found.yields_at = 0.9 * expected; found.yields_at < 3 * expected; found.yields_at += 0.005 * expected) {
        const BodyState now = world.state(body);
        const Vec3 force = -found.yields_at * scene.normal();
        world.apply(body, {force, (now.rotation * scene.vertex).cross(force)});
        world.step();
        const BodyState then = world.state(body);
        const Vec3 at_wall = then.velocity + then.angular_velocity.cross(then.rotation * scene.vertex);
        if (-at_wall.dot(scene.normal()) > 1e-4 * speed) break;
    }
    return found;
}

class Blows : public testing::TestWithParam<double> {};

TEST_P(Blows, HaveTheirImpulseAndTheirPeakInAnyStep) {
    for (const double yaw : {0.25 * pi, 0.15 * pi, 0.4 * pi}) {
        const Scene scene = upright_edge(yaw);
        const double impulse = scene.mass() * speed;
        const double peak = speed * std::sqrt(scene.mass() * scene.stiffness());
        for (const double share : {0.1, 0.5, 0.9}) {
            const Blow found = blow(scene, GetParam(), share);
            EXPECT_NEAR(found.impulse, impulse, 0.01 * impulse) << yaw << " " << share;
            EXPECT_NEAR(found.yields_at, peak, 0.03 * peak) << yaw << " " << share;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, Blows, testing::ValuesIn(time_steps));

// Steps that are short beside the blow have the mean of v √(m c) sin(ω t) each, ω = √(c / m), and nothing after a
// quarter of its period.
TEST(Blow, IsAQuarterOfASine) {
    const Scene scene = upright_edge(0.25 * pi);
    const double frequency = std::sqrt(scene.stiffness() / element_mass);
    const double time_step = 0.5 * pi / frequency / 20.5;
    World world(world_of(time_step));
    world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
    const BodyId body = world.add_element(element_at(-scene.lever() - Vec3(1e-9, 0, 0), scene.of_box));
    BodyState state = world.state(body);
    state.velocity = Vec3(speed, 0, 0);
    world.place(body, state);
    world.step();  // in which they meet
    const double peak = speed * std::sqrt(element_mass * scene.stiffness());
    for (int i = 0; i < 30; ++i) {
        world.step();
        const auto gone = [&](int steps) { return std::cos(std::min(steps * time_step * frequency, 0.5 * pi)); };
        const double mean = peak * (gone(i) - gone(i + 1)) / (frequency * time_step);
        EXPECT_NEAR(-world.contact_force(body).x(), mean, 0.05 * peak) << i;
    }
}

/// Elements that are joined as one stiff floe, `across` of them side by side and flush with x = 0 ahead of them.
std::vector<BodyId> flush_floe(World& world, int across, double x, double velocity, int piece) {
    std::vector<BodyId> floe;
    const JointSpring stiff{.force = {1e9, 1e9, 1e9}, .moment = {1e6, 1e6, 1e6}, .damping_ratio = 1};
    for (int i = 0; i < across; ++i) {
        const Vec3 at(x, 0, element_side * i);
        floe.push_back(world.add_element(element_at(at, Quat::Identity(), piece)));
        BodyState state = world.state(floe.back());
        state.velocity = Vec3(velocity, 0, 0);
        world.place(floe.back(), state);
        if (i == 0) continue;
        world.add_joint({.a = floe[floe.size() - 2],
                         .b = floe.back(),
                         .pivot = at - Vec3(0, 0, element_side / 2),
                         .frame = turned(-0.5 * pi, Vec3::UnitY()),
                         .spring = stiff});
    }
    return floe;
}

// A face has four points an element. Sweeps leave less than their tolerance of speed, and without one nothing.
TEST(FlushBlow, DoesNotRebound) {
    for (const double time_step : time_steps) {
        for (const double tolerance : {1e-3, 0.0}) {
            for (const bool on_ice : {false, true}) {
                World world(world_of(time_step, tolerance));
                const double velocity = on_ice ? 0.035 : 0.07;
                const double mass = 3 * element_mass;
                const std::vector<BodyId> floe = flush_floe(world, 3, -element_side / 2 - 1e-4, velocity, 1);
                if (on_ice)
                    flush_floe(world, 3, element_side / 2 + 1e-4, -velocity, 2);
                else
                    world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
                double impulse = 0;
                for (double time = 0; time < 0.5; time += time_step) {
                    world.step();
                    for (const BodyId element : floe) impulse -= world.contact_force(element).x() * time_step;
                }
                double momentum = 0;
                for (const BodyId element : floe) momentum += element_mass * world.state(element).velocity.x();
                EXPECT_NEAR(momentum / mass, 0, std::max(tolerance, 1e-6)) << time_step << on_ice;
                EXPECT_NEAR(impulse, mass * velocity - momentum, 1e-9 * impulse) << time_step << on_ice;
            }
        }
    }
}

// An upright edge hits the side of a free element that is as heavy: half the mass, at the speed of the two together.
TEST(BlowOfTwo, CrushesTheEdgeByTheirMotionTowardsEachOther) {
    const double c = strength * 2 * element_thickness;
    const double peak = speed * std::sqrt(0.5 * element_mass * c);
    for (const double time_step : time_steps) {
        for (const double share : {0.1, 0.5, 0.9}) {
            World world(world_of(time_step));
            const double apart = element_side / std::sqrt(2.0) + share * time_step * speed;
            const BodyId a = world.add_element(element_at(Vec3(-apart, 0, 0), turned(0.25 * pi, Vec3::UnitY())));
            const BodyId b = world.add_element(element_at(Vec3(element_side / 2, 0, 0)));
            BodyState state = world.state(a);
            state.velocity = Vec3(0.75 * speed, 0, 0);
            world.place(a, state);
            state = world.state(b);
            state.velocity = Vec3(-0.25 * speed, 0, 0);
            world.place(b, state);
            double impulse = 0;
            for (double time = 0; time < 0.4; time += time_step) {
                world.step();
                impulse += world.contact_force(b).x() * time_step;
            }
            EXPECT_NEAR(impulse, 0.5 * element_mass * speed, 1e-6 * impulse) << time_step;
            const double common = 0.25 * speed;
            EXPECT_NEAR(world.state(a).velocity.x(), common, 1e-6 * speed);
            EXPECT_NEAR(world.state(b).velocity.x(), common, 1e-6 * speed);
            double load = 0.9 * peak;
            for (; load < 3 * peak; load += 0.005 * peak) {
                world.apply(a, {Vec3(load, 0, 0), Vec3::Zero()});
                world.apply(b, {Vec3(-load, 0, 0), Vec3::Zero()});
                world.step();
                if ((world.state(a).velocity - world.state(b).velocity).norm() > 1e-6) break;
            }
            EXPECT_NEAR(load, peak, 0.03 * peak) << time_step << " " << share;
        }
    }
}

}  // namespace blows_test
}  // namespace floes::test
