// Blows of ice that crushes, in steps longer and shorter than the blow: what they exert, and how far they crush the
// edge (docs/convergence.md). An edge whose area grows as c / p per depth is a spring c until the bodies stand: with
// the mass m that meets the contact at the speed v it is crushed by v √(m / c), and yields from then on at v √(m c),
// the peak of the blow. Impulses are right in any step; how deep the edge is and what it bears afterwards depend on it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "scene.hpp"
#include "support/crushing_ice.hpp"

namespace floes::test {
namespace blows_test {

constexpr double strength = 145.6e3;  // compressive, Table 1
constexpr double speed = 0.01;        // slow, so that nothing turns far in a blow: the law is linear

/// What the law does to edges in steps of that length, over what it would in short ones.
struct Bounds {
    double time_step;
    double deepest;  ///< depth that is left
    double weakest;  ///< load at which they yield afterwards

    friend void PrintTo(const Bounds& bounds, std::ostream* out) { *out << bounds.time_step << " s"; }
};
constexpr Bounds of_steps[] = {
    {0.04, 5.8, 0.24}, {0.02, 2.9, 0.36}, {0.01, 1.5, 0.68}, {0.005, 1.13, 0.89}, {0.0025, 1.04, 0.97}};
const double pi = std::acos(-1.0);

/// The default's contacts, without friction.
WorldDefinition world_of(double time_step, double tolerance = 0) {
    return {.time_step = time_step,
            .iterations = 500,
            .tolerance = tolerance,
            .gravity = 0,
            .contact = crushing_ice(strength, 0, 0),
            .solver = SolverKind::direct};
}

/// A box, turned, flies along x at a wall and meets it with a vertex or an edge.
struct Scene {
    Vec3 half_extent = Vec3(element_side, element_thickness, element_side) / 2;
    Quat of_box = Quat::Identity();
    Vec3 vertex = Vec3::Zero();  ///< that meets the wall, or middle of the edge, from its centre in its own axes

    static Vec3 normal() { return -Vec3::UnitX(); }
    Vec3 lever() const { return of_box * vertex; }
    Vec3 inertia() const {
        const Vec3 square = half_extent.cwiseAbs2();
        return Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y()) * (element_mass / 3);
    }
    /// That meets the contact: 1/m + (r x n) . I^-1 (r x n).
    double mass() const {
        const Vec3 arm = of_box.inverse() * lever().cross(normal());
        return 1 / (1 / element_mass + arm.cwiseAbs2().cwiseQuotient(inertia()).sum());
    }
    /// That the edge yields at once the pressure has taken the blow's energy, and how deep it is then. Of an edge p T d
    /// / (c1 c2) at the depth d, of a vertex p d² / (2 c1 c2 c3), c the cosines of the normal.
    struct Crushed {
        double load, depth;
    };
    Crushed crushed() const {
        const Vec3 cosines = (of_box.inverse() * normal()).cwiseAbs();
        const double energy = 0.5 * mass() * speed * speed;
        for (int k = 0; k < 3; ++k) {
            if (cosines[k] > 1e-9) continue;
            const double c = strength * 2 * half_extent[k] / (cosines[(k + 1) % 3] * cosines[(k + 2) % 3]);
            return {std::sqrt(2 * energy * c), std::sqrt(2 * energy / c)};
        }
        const double depth = std::cbrt(6 * energy * cosines.prod() / strength);
        return {3 * energy / depth, depth};
    }
};

Scene upright_edge(double yaw) {
    return {.of_box = turned(yaw, Vec3::UnitY()), .vertex = Vec3(element_side, 0, element_side) / 2};
}

Scene corner_of_cube() {
    return {.half_extent = Vec3(0.1, 0.1, 0.1),
            .of_box = Quat(Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitX())),
            .vertex = Vec3(0.1, 0.1, 0.1)};
}

struct Blow {
    double impulse = 0;    ///< N s, along the normal
    double speed = 0;      ///< m/s, of the vertex away from the wall, afterwards
    double depth = 0;      ///< m, afterwards
    double yields_at = 0;  ///< N, afterwards
};

double away(const BodyState& state, const Scene& scene) {
    return (state.velocity + state.angular_velocity.cross(state.rotation * scene.vertex)).dot(scene.normal());
}

/// Stops a box and puts a load on its edge that grows until the edge yields.
double yields_at(World& world, BodyId body, const Scene& scene, double time_step) {
    const BodyState after = world.state(body);
    const Vec3 momentum = scene.inertia().cwiseProduct(after.rotation.transpose() * after.angular_velocity);
    world.apply(body, {-element_mass / time_step * after.velocity, after.rotation * -momentum / time_step});
    world.step();
    const double expected = scene.crushed().load;
    double load = 0.02 * expected;
    for (; load < 10 * expected; load += 0.005 * expected) {
        const Vec3 force = -load * scene.normal();
        world.apply(body, {force, (world.state(body).rotation * scene.vertex).cross(force)});
        world.step();
        if (away(world.state(body), scene) < -1e-4 * speed) break;
    }
    return load;
}

/// Share: of a step's way that is left to go when a step begins.
Blow blow(const Scene& scene, double time_step, double share) {
    World world(world_of(time_step));
    world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
    ElementDefinition box = element_at(share * time_step * speed * scene.normal() - scene.lever(), scene.of_box);
    box.corners = corners_of(scene.half_extent.x(), scene.half_extent.z());
    box.half_thickness = scene.half_extent.y();
    const BodyId body = world.add_element(box);
    set_moving(world, body, Vec3(speed, 0, 0));
    Blow found;
    for (double force = 0; force > 0 || found.impulse == 0; found.impulse += force * time_step) {
        world.step();
        force = world.contact_force(body).dot(scene.normal());
        if (force < 1e-9) force = 0;
    }
    found.speed = away(world.state(body), scene);
    found.depth = world.state(body).position.x() + (world.state(body).rotation * scene.vertex).x();
    found.yields_at = yields_at(world, body, scene, time_step);
    return found;
}

class Blows : public testing::TestWithParam<Bounds> {};

// Whatever of a step's way is left to go when the step begins in which they meet.
TEST_P(Blows, HaveTheirImpulseAndCrushEdgesAtLeastAsDeepAsTheirEnergyDoes) {
    const auto [time_step, deepest, weakest] = GetParam();
    const Scene scenes[] = {upright_edge(0.25 * pi), upright_edge(0.15 * pi), upright_edge(0.4 * pi), corner_of_cube()};
    for (const Scene& scene : scenes) {
        const double impulse = scene.mass() * speed;
        const auto [load, depth] = scene.crushed();
        for (const double share : {0.02, 0.3, 0.6, 0.9, 0.98}) {
            const Blow found = blow(scene, time_step, share);
            EXPECT_NEAR(found.impulse, impulse, 0.002 * impulse) << share;
            EXPECT_LT(std::abs(found.speed), 0.005 * speed) << share;
            EXPECT_GT(found.depth, 0.99 * depth) << share;
            EXPECT_LT(found.depth, deepest * depth) << share;
            EXPECT_GT(found.yields_at, weakest * load) << share;
            EXPECT_LT(found.yields_at, 1.01 * load) << share;
        }
    }
}

// A hexagon's corner: p T 2 tan 60° per depth.
TEST_P(Blows, OfPrismsDoLikewise) {
    for (const double share : {0.02, 0.3, 0.6, 0.9}) {
        World world(world_of(GetParam().time_step));
        world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
        const double gap = share * GetParam().time_step * speed;
        const ElementDefinition prism = hexagon_at(Vec3(-0.12 - gap, 0, 0), pi / 6);
        const BodyId body = world.add_element(prism);
        set_moving(world, body, Vec3(speed, 0, 0));
        for (double time = 0; time < 0.4; time += GetParam().time_step) world.step();
        EXPECT_LT(world.state(body).velocity.norm(), 1e-9);
        const double depth = speed * std::sqrt(prism.mass / (strength * element_thickness * 2 * std::sqrt(3.0)));
        EXPECT_GT(world.state(body).position.x() + 0.12, 0.99 * depth) << share;
        EXPECT_LT(world.state(body).position.x() + 0.12, GetParam().deepest * depth) << share;
    }
}

// An upright edge hits the side of a free element that is as heavy: half the mass, at the speed of the two together.
TEST_P(Blows, OfTwoAreByTheirMotionTowardsEachOther) {
    const double time_step = GetParam().time_step;
    const double depth = speed * std::sqrt(0.5 * element_mass / (strength * 2 * element_thickness));
    for (const double share : {0.02, 0.3, 0.6, 0.9}) {
        World world(world_of(time_step));
        const double apart = element_side / std::sqrt(2.0) + share * time_step * speed;
        const BodyId a = world.add_element(element_at(Vec3(-apart, 0, 0), turned(0.25 * pi, Vec3::UnitY())));
        const BodyId b = world.add_element(element_at(Vec3(element_side / 2, 0, 0)));
        set_moving(world, a, Vec3(0.75 * speed, 0, 0));
        set_moving(world, b, Vec3(-0.25 * speed, 0, 0));
        double impulse = 0;
        for (double time = 0; time < 0.4; time += time_step) {
            world.step();
            impulse += world.contact_force(b).x() * time_step;
        }
        EXPECT_NEAR(impulse, 0.5 * element_mass * speed, 1e-6 * impulse) << share;
        EXPECT_NEAR(world.state(a).velocity.x(), 0.25 * speed, 1e-6 * speed) << share;
        EXPECT_NEAR(world.state(b).velocity.x(), 0.25 * speed, 1e-6 * speed) << share;
        const double between = world.state(b).position.x() - world.state(a).position.x();
        const double found = element_side / std::sqrt(2.0) + element_side / 2 - between;
        EXPECT_GT(found, 0.99 * depth) << share;
        EXPECT_LT(found, GetParam().deepest * depth) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, Blows, testing::ValuesIn(of_steps));

/// Elements that are joined as one stiff floe, `across` of them side by side and flush with x = 0 ahead of them.
std::vector<BodyId> flush_floe(World& world, int across, double x, double velocity, int piece) {
    std::vector<BodyId> floe;
    const JointSpring stiff{.force = {1e9, 1e9, 1e9}, .moment = {1e6, 1e6, 1e6}, .damping_ratio = 1};
    for (int i = 0; i < across; ++i) {
        const Vec3 at(x, 0, element_side * i);
        floe.push_back(world.add_element(element_at(at, Quat::Identity(), piece)));
        set_moving(world, floe.back(), Vec3(velocity, 0, 0));
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
    for (const double time_step : {0.04, 0.02, 0.01, 0.005, 0.0025}) {
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

}  // namespace blows_test
}  // namespace floes::test
