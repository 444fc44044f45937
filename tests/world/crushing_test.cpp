// Edges that crush (contact.law = "crushing") against closed forms: docs/convergence.md.

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_of_many.hpp"
#include "core/error.hpp"
#include "scene.hpp"

namespace floes::test {
namespace crushing_test {

constexpr double strength = 145.6e3;  // compressive, Table 1
constexpr double speed = 0.07;
const double pi = std::acos(-1.0);

WorldDefinition crushing(double pressure, double time_step) {
    return {.time_step = time_step,
            .gravity = 0,
            .contact = {.ice_ice_friction = 0,
                        .ice_structure_friction = 0,
                        .normal = NormalLaw::crushing,
                        .crushing_pressure = pressure},
            .solver = SolverKind::lanes};
}

/// A box flies at a wall whose normal points against it. Positions are those of the box's first vertex.
struct Impact {
    double peak = 0;   ///< of the force on the wall, N
    double force = 0;  ///< mean over the contact, N
    double depth = 0;  ///< in the end, m
    double speed = 0;  ///< along the normal in the end, away from the wall, m/s
    double lasts = 0;  ///< s
};

struct Scene {
    Vec3 half_extents = Vec3(element_side, element_thickness, element_side) / 2;
    Quat of_box = Quat::Identity();
    Quat of_wall = Quat::Identity();  ///< turns the wall's normal away from -x
};

Impact impact(const Scene& scene, WorldDefinition definition, double duration) {
    World world(definition);
    const Vec3 normal = scene.of_wall * -Vec3::UnitX();
    world.add_fixed_box({Vec3(1, 1, 1), {-normal, scene.of_wall}});
    Vec3 first = Vec3::Zero();  // of the box's vertices or, of some equally near, the middle
    const Vec3 along = scene.of_box.inverse() * normal;
    for (int k = 0; k < 3; ++k)
        first[k] = std::abs(along[k]) < 1e-9 ? 0 : -std::copysign(scene.half_extents[k], along[k]);
    ElementDefinition box = element_at(scene.of_box * -first, scene.of_box);
    box.corners = corners_of(scene.half_extents.x(), scene.half_extents.z());
    box.half_thickness = scene.half_extents.y();
    const double gap = 0.3 * speed * definition.time_step;
    box.pose.position += gap * normal;
    const BodyId body = world.add_element(box);
    const BodyState state = set_moving(world, body, Vec3(speed, 0, 0));
    Impact found;
    double impulse = 0;
    for (double time = 0; time < duration; time += definition.time_step) {
        world.step();
        const double force = world.contact_force(body).dot(normal);
        found.peak = std::max(found.peak, force);
        impulse += force * definition.time_step;
        if (force > 0) found.lasts = time + definition.time_step;
    }
    found.force = impulse / found.lasts;
    found.depth = -(world.state(body).position - state.position).dot(normal) - gap;
    found.speed = world.state(body).velocity.dot(normal);
    return found;
}

/// Errors of `value` at 2.5, 5 and 10 steps a contact: falling, and at most 3 % in the end.
template <class Value>
void expect_converges(const Scene& scene, double pressure, double contact_time, double expected, const Value& value) {
    double last = 1;
    for (const int steps : {3, 5, 10}) {
        const Impact found = impact(scene, crushing(pressure, contact_time / steps), 4 * contact_time);
        const double error = std::abs(value(found) / expected - 1);
        EXPECT_LE(error, std::max(last, 1e-6)) << steps << " steps";
        EXPECT_LT(std::abs(found.speed), 1e-9) << "crushed ice does not push back";
        last = error;
    }
    EXPECT_LT(last, 0.03);
}

double peak_of(const Impact& impact) {
    return impact.peak;
}

// F = p b h until the box stands. Weak ice, so that it goes deeper than a face is uneven.
TEST(Crushing, AFlushImpactHasTheForceOfPressureOnTheFaceUntilItStands) {
    constexpr double pressure = 20;
    const double force = pressure * element_side * element_thickness;
    const double contact_time = element_mass * speed / force;
    expect_converges({}, pressure, contact_time, force, peak_of);
    // The step in which it arrives is over before the wall acts: up to half a step's way more, or less.
    for (const int steps : {3, 5, 10, 30}) {
        const double time_step = contact_time / steps;
        const double depth = impact({}, crushing(pressure, time_step), 3 * contact_time).depth;
        EXPECT_NEAR(depth, element_mass * speed * speed / (2 * force), 0.5 * speed * time_step) << steps;
    }
}

// The area of a corner's edge grows as 2 T depth: a spring c, of which the box goes through a quarter
// period.
TEST(Crushing, AnUprightEdgeActsAsASpringUntilItStands) {
    const double c = strength * 2 * element_thickness;
    const double contact_time = 0.5 * pi * std::sqrt(element_mass / c);
    const Scene scene{.of_box = turned(0.25 * pi, Vec3::UnitY())};
    expect_converges(scene, strength, contact_time, speed * std::sqrt(element_mass * c), peak_of);
    expect_converges(scene, strength, contact_time, speed * std::sqrt(element_mass / c),
                     [](const Impact& found) { return found.depth; });
}

TEST(Crushing, AnEdgeOnAnInclinedWallDoesLikewise) {
    for (const double slope : {0.25 * pi, 0.15 * pi, 0.35 * pi}) {
        const Scene scene{.of_wall = turned(-slope, Vec3::UnitZ())};
        const Vec3 normal = scene.of_wall * -Vec3::UnitX();
        const double c = strength * element_side / (std::abs(normal.x()) * std::abs(normal.y()));
        const Vec3 edge(element_side / 2, -std::copysign(element_thickness / 2, normal.y()), 0);
        const double lever = edge.cross(normal).z();
        const double inertia = (element_side * element_side + element_thickness * element_thickness) / 12;
        const double mass = element_mass / (1 + lever * lever / inertia);
        const double contact_time = 0.5 * pi * std::sqrt(mass / c);
        double last = 1;
        for (const int steps : {3, 5, 10}) {
            // It turns away afterwards, and slides along the wall: only the force is compared.
            const Impact found = impact(scene, crushing(strength, contact_time / steps), 1.5 * contact_time);
            const double error = std::abs(found.peak / (speed * -normal.x() * std::sqrt(mass * c)) - 1);
            EXPECT_LT(error, last) << slope << " " << steps;
            last = error;
        }
        EXPECT_LT(last, 0.03) << slope;
    }
}

// A = 3 √3 d² / 2, so that m v² / 2 = p √3 d³ / 2.
TEST(Crushing, ACubesVertexSinksUntilThePressureHasTakenItsEnergy) {
    const Quat upright(Eigen::Quaterniond::FromTwoVectors(Vec3(1, 1, 1), Vec3::UnitX()));
    const Scene cube{.half_extents = Vec3(0.1, 0.1, 0.1), .of_box = upright};
    const double depth = std::cbrt(element_mass * speed * speed / (std::sqrt(3.0) * strength));
    expect_converges(cube, strength, 1.5 * depth / speed, depth, [](const Impact& found) { return found.depth; });
}

TEST(Crushing, IceThatIsVeryStrongIsRigid) {
    const Scene scenes[] = {{}, {.of_box = turned(0.6, Vec3::UnitY())}, {.of_wall = turned(0.7, Vec3::UnitZ())}};
    for (const Scene& scene : scenes) {
        WorldDefinition definition = crushing(1e18, 0.02);
        const Impact crushed = impact(scene, definition, 0.2);
        definition.contact = {.erp = 0, .ice_ice_friction = 0, .ice_structure_friction = 0};
        const Impact rigid = impact(scene, definition, 0.2);
        EXPECT_EQ(crushed.peak, rigid.peak);
        EXPECT_EQ(crushed.speed, rigid.speed);
        EXPECT_GT(rigid.peak, 1);
    }
}

// Loaded at once an edge sinks to twice the depth at which pressure balances the load, and stays there.
TEST(Crushing, ALoadedEdgeSinksOnceAndHolds) {
    constexpr double load = 5;
    const double depth = 2 * load / (strength * 2 * element_thickness);
    World world(crushing(strength, 0.002));
    world.add_fixed_box({Vec3(1, 1, 1), {Vec3(1, 0, 0), Quat::Identity()}});
    const Vec3 start(-element_side / std::sqrt(2.0), 0, 0);
    const BodyId body = world.add_element(element_at(start, turned(0.25 * pi, Vec3::UnitY())));
    const auto go = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            world.apply(body, {Vec3(load, 0, 0), Vec3::Zero()});
            world.step();
        }
        return world.state(body).position.x() - start.x();
    };
    const double sunk = go(100);
    EXPECT_NEAR(sunk, depth, 0.03 * depth);
    EXPECT_NEAR(go(2000), sunk, 1e-6 * sunk);
    EXPECT_NEAR(world.contact_force(body).x(), -load, 1e-9 * load);
}

TEST(Crushing, ACollisionOfManyNeverGainsEnergy) {
    for (const double coefficient : {0.7, 0.0}) {
        for (const double time_step : {0.02, 0.002}) {
            WorldDefinition definition = crushing(strength, time_step);
            definition.contact.friction = coefficient > 0 ? Friction::cone : Friction::one_direction;
            definition.contact.ice_ice_friction = coefficient;
            definition.contact.ice_structure_friction = coefficient;
            expect_a_collision_that_never_gains_energy(definition, 2);
        }
    }
}

TEST(Crushing, StockRefusesIt) {
    WorldDefinition definition = crushing(strength, 0.02);
    definition.solver = SolverKind::stock;
    EXPECT_THROW(World{definition}, InputError);
}

TEST(Crushing, NeedsAPressure) {
    EXPECT_THROW(World{crushing(0, 0.02)}, InputError);
}

}  // namespace crushing_test
}  // namespace floes::test
