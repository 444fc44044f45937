// Elements on planes, the sea bed and walls: they lie, slide and come to rest as closed forms have it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "solver/lane_width.hpp"
#include "world/scene.hpp"

namespace floes::test {
namespace plane_test {

WorldDefinition definition(SolverKind solver, NormalLaw law = NormalLaw::rigid, int lanes = 0) {
    WorldDefinition made{.time_step = 0.01, .iterations = 200, .solver = solver, .lanes = lanes};
    made.contact.friction = Friction::cone;
    made.contact.split_impulse = false;
    made.contact.normal = law;
    if (law == NormalLaw::crushing) made.contact.crushing_pressure = 46e3;
    return made;
}

constexpr SolverKind ours[] = {SolverKind::lanes, SolverKind::direct};

/// Rises by `angle` along +x, through the origin.
PlaneDefinition slope(double angle, double friction) {
    return {.normal = {-std::sin(angle), std::cos(angle), 0}, .friction = friction};
}

/// An element that lies on it.
ElementDefinition on_slope(double angle, bool hexagon) {
    const Quat tilt = turned(angle, Vec3::UnitZ());
    const Vec3 place = tilt * Vec3(0, element_thickness / 2, 0);
    ElementDefinition made = hexagon ? hexagon_at(place) : element_at(place);
    made.pose.orientation = tilt;
    return made;
}

// For half a minute from the first second on, in which the first solve is not exact yet, where the direct solver's
// sweeps end by their tolerance as they do in a member.
TEST(Plane, HoldsBelowTheAngleOfFrictionWithoutCreep) {
    for (const SolverKind solver : ours)
        for (const bool hexagon : {false, true}) {
            const double friction = 0.3;
            const double angle = std::atan(0.99 * friction);
            WorldDefinition made = definition(solver);
            if (solver == SolverKind::direct) made.tolerance = 1e-3;
            World world(made);
            const BodyId plane = world.add_plane(slope(angle, friction));
            const ElementDefinition element = on_slope(angle, hexagon);
            const BodyId body = world.add_element(element);
            for (int step = 0; step < 100; ++step) world.step();
            const Vec3 before = world.state(body).position;
            EXPECT_LT((before - element.pose.position).norm(), 5e-4);
            for (int step = 0; step < 3000; ++step) world.step();
            EXPECT_LT((world.state(body).position - before).norm(), 1e-6);
            EXPECT_LT(world.state(body).velocity.norm(), 1e-9);
            EXPECT_LT((world.contact_force(plane) + Vec3(0, element.mass * 9.81, 0)).norm(), 1e-6);
        }
}

TEST(Plane, LetsSlideAboveIt) {
    for (const SolverKind solver : ours)
        for (const bool hexagon : {false, true}) {
            const double friction = 0.3;
            const double angle = std::atan(1.1 * friction);
            World world(definition(solver));
            world.add_plane(slope(angle, friction));
            const BodyId body = world.add_element(on_slope(angle, hexagon));
            const int steps = 100;
            for (int step = 0; step < steps; ++step) world.step();
            const double expected = 9.81 * (std::sin(angle) - friction * std::cos(angle)) * steps * 0.01;
            EXPECT_NEAR(-world.state(body).velocity.dot(Vec3(std::cos(angle), std::sin(angle), 0)), expected,
                        1e-3 * expected);
        }
}

double lowest_corner(const ElementDefinition& element, const Vec3& position, const Mat3& rotation) {
    double lowest = 1e9;
    for (const Corner& corner : element.corners)
        for (const double y : {-element.half_thickness, element.half_thickness})
            lowest = std::min(lowest, (position + rotation * Vec3(corner.x, y, corner.z)).y());
    return lowest;
}

/// Dropped from 2 cm on edge, on a corner and aslant: it comes to rest flat, and no corner is farther below than it
/// falls in a step.
TEST(Plane, IsNeverGoneThroughAndComesToRest) {
    for (const SolverKind solver : ours)
        for (const NormalLaw law : {NormalLaw::rigid, NormalLaw::crushing})
            for (const Vec3& axis : {Vec3(1, 0, 0.1), Vec3(1, 0, 1), Vec3(0, 0, 1)}) {
                World world(definition(solver, law));
                const BodyId plane = world.add_plane({.friction = 0.3});
                ElementDefinition element = hexagon_at({0, 0, 0});
                element.pose.orientation = turned(1.3, axis);
                element.pose.position.y() = 0.02 - lowest_corner(element, Vec3::Zero(), Mat3(element.pose.orientation));
                const BodyId body = world.add_element(element);
                double lowest = 0;
                double fastest = 0;  // of any corner
                for (int step = 0; step < 1500; ++step) {
                    world.step();
                    const BodyState state = world.state(body);
                    fastest = std::max(fastest, state.velocity.norm() + 0.13 * state.angular_velocity.norm());
                    lowest = std::min(lowest, lowest_corner(element, state.position, state.rotation));
                }
                EXPECT_GT(lowest, -0.01 * fastest);
                EXPECT_LT(world.state(body).velocity.norm(), 1e-6);
                EXPECT_NEAR(std::abs(world.state(body).rotation(1, 1)), 1, 1e-3);
                EXPECT_NEAR(world.contact_force(plane).y(), -element.mass * 9.81, 1e-3);
            }
}

/// A row between two walls without friction, pressed by 30 N.
TEST(Plane, IsAWall) {
    for (const SolverKind solver : ours) {
        WorldDefinition made = definition(solver);
        made.gravity = 0;
        World world(made);
        const BodyId left = world.add_plane({.point = {-0.301, 0, 0}, .normal = Vec3::UnitX()});
        const BodyId right = world.add_plane({.point = {0.301, 0, 0}, .normal = -Vec3::UnitX()});
        std::vector<BodyId> row;
        for (const double x : {-0.2, 0.0, 0.2}) row.push_back(world.add_element(element_at({x, 0, 0})));
        for (int step = 0; step < 300; ++step) {
            world.apply(row[1], {{30, 0, 0}, Vec3::Zero()});
            world.step();
        }
        EXPECT_NEAR(world.contact_force(right).x(), 30, 1e-3);
        EXPECT_NEAR(world.contact_force(left).x(), 0, 1e-3);
        EXPECT_LT((world.state(row[2]).position - Vec3(0.201, 0, 0)).norm(), 1e-4);
    }
}

World heap(int lanes) {
    World world(definition(SolverKind::direct, NormalLaw::crushing, lanes));
    world.add_plane({.friction = 0.3});
    for (int i = 0; i < 12; ++i) {
        ElementDefinition element = hexagon_at({0.03 * (i % 3), 0.1 + 0.06 * i, 0.02 * (i % 4)}, 0.4 * i);
        world.add_element(element);
    }
    return world;
}

TEST(Plane, GivesTheSameBitsAtEveryLaneWidthAndAfterItWasSaved) {
    World whole = heap(0);
    for (int step = 0; step < 300; ++step) whole.step();
    for (const int lanes : lane_widths()) {
        World other = heap(lanes);
        for (int step = 0; step < 150; ++step) other.step();
        StateArchive out;
        other.archive(out);
        const Bytes bytes = out.take();
        World set = heap(lanes);
        StateArchive in(bytes);
        set.archive(in);
        in.end();
        for (int step = 0; step < 150; ++step) set.step();
        for (std::size_t i = 1; i <= 12; ++i) EXPECT_TRUE(same_bits(set.state(BodyId(i)), whole.state(BodyId(i))));
    }
}

TEST(Plane, IsRefusedByBulletsOwnSolverAndWithoutANormal) {
    World stock({});
    EXPECT_THROW(stock.add_plane({}), InputError);
    World world(definition(SolverKind::lanes));
    EXPECT_THROW(world.add_plane({.normal = {0, 2, 0}}), InputError);
    EXPECT_THROW(world.add_plane({.friction = -1}), InputError);
}

}  // namespace plane_test
}  // namespace floes::test
