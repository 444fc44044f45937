// Coulomb's cone (contact.friction = "cone") against closed forms, at any azimuth: docs/convergence.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "collision_of_many.hpp"
#include "core/error.hpp"
#include "scene.hpp"

namespace floes::test {
namespace cone_test {

const double pi = std::acos(-1.0);
const std::vector<double> azimuths{0.0, 0.3, 1.0, 0.25 * pi, 0.5 * pi, 2.0, pi, 4.4, 5.9};

WorldDefinition with(Friction friction, double coefficient, double gravity = 9.81) {
    return {.gravity = gravity,
            .contact = {.erp = 0, .ice_ice_friction = coefficient, .friction = friction},
            .solver = SolverKind::lanes};
}

// ---- A box pressed on a base, loaded by two others that touch it: P along, Q across.

constexpr double mass = 2.5;
constexpr double across = 2;  // Q, N

/// Metres a second along Q, over 2 s. The base can hold 0.3 * 20 N = 6 N.
double creep(Friction friction, const Quat& turn) {
    World world(with(friction, 0.3, 0));
    ElementDefinition box = element_at(Vec3::Zero(), turn);
    box.mass = mass;
    // The base and those that push are narrower than the box, so that they touch nothing else.
    world.add_fixed_box({Vec3(0.09, 0.1, 0.09), {turn * Vec3(0, -0.2 + 1e-4, 0), turn}});
    const auto add = [&](const Vec3& half_extents, const Vec3& at) {
        box.corners = corners_of(half_extents.x(), half_extents.z());
        box.half_thickness = half_extents.y();
        box.pose.position = turn * at;
        return world.add_element(box);
    };
    const BodyId held = add({0.1, 0.1, 0.1}, Vec3::Zero());
    const BodyId pushes_along = add({0.1, 0.08, 0.08}, {-0.2 + 1e-4, 0, 0});
    const BodyId pushes_across = add({0.08, 0.08, 0.1}, {0, 0, -0.2 + 1e-4});
    for (int step = 0; step < 150; ++step) {
        world.apply(held, {turn * Vec3(0, -20, 0), Vec3::Zero()});
        world.apply(pushes_along, {turn * Vec3(4, 0, 0), Vec3::Zero()});
        world.apply(pushes_across, {turn * Vec3(0, 0, across), Vec3::Zero()});
        world.step();
        if (step == 49) box.pose.position = world.state(held).position;
    }
    return (world.state(held).position - box.pose.position).dot(turn * Vec3::UnitZ()) / 2;
}

TEST(Cone, HoldsABoxUnderALoadAcross) {
    for (const double azimuth : azimuths) {
        const Quat turn = turned(0.7, Vec3(1, 0.2, 0.5)) * turned(azimuth, Vec3::UnitY());
        EXPECT_LT(std::abs(creep(Friction::cone, turn)), 1e-12) << azimuth;
    }
}

// In a step in which the row does not lie along Q, Q moves the box and the one that pushes it: Q dt / 2 m. In the next
// the row lies along that velocity, and stops it.
TEST(Cone, OneDirectionLetsTheSameBoxCreep) {
    const double fastest = across * WorldDefinition{}.time_step / (2 * mass);
    for (const double azimuth : azimuths) {
        const double speed = creep(Friction::one_direction, turned(azimuth, Vec3::UnitY()));
        EXPECT_GT(speed, 0.25 * fastest) << azimuth;
        EXPECT_LT(speed, fastest) << azimuth;
    }
}

// ---- A block on a slope that rises to any azimuth, itself turned at will.

struct Slide {
    Vec3 settling;  ///< in the first steps, in which the impulses build up
    Vec3 way;       ///< from then on
    double speed;   ///< down the slope, gained from then on
};

constexpr int settling = 100;

Slide slide(double coefficient, double angle, double azimuth, double yaw, int steps) {
    World world(with(Friction::cone, coefficient));
    const Quat tilt = turned(angle, Vec3(std::sin(azimuth), 0, -std::cos(azimuth)));
    const Vec3 start = tilt * Vec3(0, element_thickness / 2 - 1e-4, 0);
    world.add_fixed_box({Vec3(5, 0.5, 5), {tilt * Vec3(0, -0.5, 0), tilt}});
    const BodyId body = world.add_element(element_at(start, tilt * turned(yaw, Vec3::UnitY())));
    for (int step = 0; step < settling; ++step) world.step();
    const BodyState settled = world.state(body);
    for (int step = 0; step < steps; ++step) world.step();
    const Vec3 normal = tilt * Vec3::UnitY();
    const Vec3 down = (normal * normal.y() - Vec3::UnitY()).normalized();
    const BodyState end = world.state(body);
    return {settled.position - start, end.position - settled.position, (end.velocity - settled.velocity).dot(down)};
}

TEST(Cone, HoldsOnASlopeBelowTheAngleOfFriction) {
    for (const double azimuth : azimuths) {
        for (const double yaw : {0.0, 0.4}) {
            const Slide held = slide(0.3, std::atan(0.999 * 0.3), azimuth, yaw, 250);
            EXPECT_LT(held.settling.norm(), 1e-4) << azimuth << " " << yaw;
            EXPECT_LT(held.way.norm(), 1e-9) << azimuth << " " << yaw;
        }
    }
}

TEST(Cone, SlidesOnASlopeAboveTheAngleOfFriction) {
    for (const double azimuth : azimuths) {
        for (const double excess : {1.001, 1.01}) {
            const double angle = std::atan(excess * 0.3);
            const double acceleration = 9.81 * (std::sin(angle) - 0.3 * std::cos(angle));
            const int steps = std::min(400, static_cast<int>(0.1 / acceleration / 0.02) - settling);
            const double speed = acceleration * steps * 0.02;
            EXPECT_NEAR(slide(0.3, angle, azimuth, 0.4, steps).speed, speed, 0.005 * speed) << azimuth << " " << excess;
        }
    }
}

// ---- A block that slides on a level floor.

/// Friction on the body over its weight: direction and size, as a vector.
Vec3 friction_on(const World& world, BodyId body) {
    const Vec3 force = world.contact_force(body);
    return Vec3(force.x(), 0, force.z()) / force.y();
}

TEST(Cone, FrictionOpposesTheVelocityOfABlockThatIsPushedSideways) {
    constexpr double coefficient = 0.02;
    for (const double azimuth : azimuths) {
        const Quat turn = turned(azimuth, Vec3::UnitY());
        World world(with(Friction::cone, coefficient));
        world.add_fixed_box({Vec3(5, 0.5, 5), {Vec3(0, -0.5, 0), Quat::Identity()}});
        const Vec3 start(0, element_thickness / 2 - 1e-4, 0);
        const BodyId body = world.add_element(element_at(start, turn));
        set_moving(world, body, turn * Vec3(0.1, 0, 0));
        for (int step = 0; step < 20; ++step) {
            world.apply(body, {turn * Vec3(0, 0, 0.1), Vec3::Zero()});
            world.step();
            const Vec3 velocity = world.state(body).velocity;
            const Vec3 against = -coefficient * Vec3(velocity.x(), 0, velocity.z()).normalized();
            EXPECT_LT((friction_on(world, body) - against).norm(), 0.005 * coefficient) << azimuth << " " << step;
        }
        const Vec3 end = turn.inverse() * world.state(body).velocity;
        EXPECT_GT(end.z(), 0.2 * end.x()) << "the push must have turned it";
    }
}

// ---- Several bodies.

// Not turned against each other: of the eight points where two turned squares touch Bullet keeps four, not always the
// same ones.
double speed_of_a_stack(Friction friction) {
    WorldDefinition definition = with(friction, 0.3);
    definition.contact.erp = 0.2;
    World world(definition);
    world.add_fixed_box({Vec3(1, 0.5, 1), {Vec3(0, -0.5, 0), Quat::Identity()}});
    std::vector<BodyId> stack;
    for (int i = 0; i < 3; ++i) {
        const double height = (i + 0.5) * element_thickness - (i + 1) * 1e-4;
        stack.push_back(world.add_element(element_at({0.01 * i, height, -0.02 * i})));
    }
    for (int step = 0; step < 400; ++step) world.step();
    double fastest = 0;
    for (const BodyId body : stack) fastest = std::max(fastest, world.state(body).velocity.norm());
    return fastest;
}

TEST(Cone, AStackAtRestStaysAtRest) {
    EXPECT_LT(speed_of_a_stack(Friction::cone), 1e-12);
    EXPECT_GT(speed_of_a_stack(Friction::one_direction), 1e-6) << "it creeps";
}

TEST(Cone, ACollisionOfManyNeverGainsEnergy) {
    expect_a_collision_that_never_gains_energy(with(Friction::cone, 0.7, 0), 3);
}

TEST(Cone, StockRefusesIt) {
    WorldDefinition definition = with(Friction::cone, 0.3);
    definition.solver = SolverKind::stock;
    EXPECT_THROW(World{definition}, InputError);
}

}  // namespace cone_test
}  // namespace floes::test
