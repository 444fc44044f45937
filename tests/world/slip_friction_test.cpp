// A block that slides on a floor with friction that depends on its speed, against closed forms: docs/convergence.md.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "scene.hpp"
#include "shapes/convex_solid.hpp"

namespace floes::test {
namespace slip_friction_test {

constexpr double coefficient = 0.2;

WorldDefinition with(const SlipFriction& slip, double gravity, double time_step = 0.02) {
    return {.time_step = time_step,
            .gravity = gravity,
            .contact = {.erp = 0,
                        .ice_ice_friction = coefficient,
                        .ice_structure_friction = coefficient,
                        .slip = slip,
                        .friction = Friction::cone},
            .solver = SolverKind::lanes};
}

BodyId slides_at(World& world, double speed) {
    const BodyId body = world.add_element(element_at({0, element_thickness / 2 - 1e-4, 0}));
    set_moving(world, body, Vec3(speed, 0, 0));
    return body;
}

/// A block on a floor of ice, or on a structure that rests below it.
struct Floor {
    World world;
    BodyId block;

    Floor(const WorldDefinition& definition, double speed, bool structure)
        : world(definition), block((put_floor(structure), slides_at(world, speed))) {}

    void put_floor(bool structure) {
        const Vec3 half(20, 0.5, 5);
        if (!structure) return void(world.add_fixed_box({half, {Vec3(0, -0.5, 0), Quat::Identity()}}));
        std::vector<Vec3> corners;
        for (const double x : {-half.x(), half.x()})
            for (const double y : {-half.y(), half.y()})
                for (const double z : {-half.z(), half.z()}) corners.emplace_back(x, y, z);
        world.add_structure(std::vector{ConvexSolid(convex_hull(corners))}, {Vec3(0, -0.5, 0), Quat::Identity()});
    }

    double speed() const { return world.state(block).velocity.x(); }
    double friction() const {  ///< over the normal force
        const Vec3 force = world.contact_force(block);
        return -force.x() / force.y();
    }
};

constexpr double V = 0.1, n = 0.35;

SlipFriction power(bool structure) {
    return {.ice_ice = structure ? SlipEffect::constant : SlipEffect::power,
            .ice_structure = structure ? SlipEffect::power : SlipEffect::constant,
            .ice_structure_exponent = n,
            .speed = V,
            .least = 1e-3};
}

TEST(SlipFriction, EachKindOfSurfaceHasTheCoefficientOfItsSpeed) {
    for (const double unit : {0.25, 1.0, 30.0})  // of length, in which the world computes
        for (const bool structure : {false, true})
            for (const double speed : {0.05, 0.2, 0.6}) {
                WorldDefinition definition = with(power(structure), 9.81, 0.002);
                definition.length_unit = unit;
                Floor floor(definition, speed, structure);
                floor.world.step();
                const double expected = coefficient * std::pow(speed / V, -n);
                EXPECT_NEAR(floor.friction(), expected, 1e-9) << unit << " " << structure << " " << speed;
            }
}

// dv/dt = -f g (v / V)^-n: v^(1+n) = v0^(1+n) - (1+n) f g V^n t.
TEST(SlipFriction, ABlockSlowsByThePowerLaw) {
    constexpr double t = 0.2, v0 = 0.5;
    const double v = std::pow(std::pow(v0, 1 + n) - (1 + n) * coefficient * 9.81 * std::pow(V, n) * t, 1 / (1 + n));
    double errors[2];
    for (const int halved : {0, 1}) {
        const double step = 0.01 / (1 + halved);
        Floor floor(with(power(false), 9.81, step), v0, false);
        for (int i = 0; i < std::lround(t / step); ++i) floor.world.step();
        errors[halved] = std::abs(floor.speed() - v);
    }
    EXPECT_LT(errors[1], 0.01 * (v0 - v));
    EXPECT_LT(errors[1], 0.7 * errors[0]) << "first order";
}

// So little weight that the block keeps its speed. A push makes it ten times as fast.
TEST(SlipFriction, APushRaisesFrictionAtOnceAndLowersItWithTime) {
    constexpr double gravity = 1e-3;
    const SlipFriction slip{.ice_ice = SlipEffect::rate_and_state, .largest = 10};
    for (const double unit : {1.0, 30.0}) {
        WorldDefinition definition = with(slip, gravity);
        definition.length_unit = unit;
        Floor floor(definition, 0.01, false);
        for (int i = 0; i < 10; ++i) floor.world.step();
        const double slow = floor.friction();
        EXPECT_NEAR(slow, coefficient + 0.072 * std::log(10.0), 0.01) << unit;
        floor.world.apply(floor.block, {Vec3(element_mass * 0.09 / 0.02, 0, 0), Vec3::Zero()});
        floor.world.step();
        floor.world.step();
        EXPECT_NEAR(floor.friction() - slow, 0.31 * std::log(10.0), 0.02) << unit;
        for (int i = 0; i < 500; ++i) floor.world.step();
        EXPECT_NEAR(floor.friction(), coefficient + 0.382 * std::exp(-1.0) * std::log(10.0), 0.02) << unit;
    }
}

TEST(SlipFriction, StockRefusesIt) {
    WorldDefinition definition = with({.ice_ice = SlipEffect::power}, 9.81);
    definition.contact.friction = Friction::one_direction;
    definition.solver = SolverKind::stock;
    EXPECT_THROW(World{definition}, InputError);
}

TEST(SlipFriction, BoundsThatCrossAreRefused) {
    EXPECT_THROW(World{with({.ice_ice = SlipEffect::power, .least = 0.5, .largest = 0.4}, 9.81)}, InputError);
}

}  // namespace slip_friction_test
}  // namespace floes::test
