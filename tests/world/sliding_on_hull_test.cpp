// Ice that slides on the structure with a face flush to it, and is pressed off its middle: it neither sinks in nor
// turns, however long it slides, since it bears on all of the face and not on the corner that is deepest at a time.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "scene.hpp"
#include "support/crushing_ice.hpp"

namespace floes::test {
namespace sliding_on_hull_test {

constexpr double pi = std::numbers::pi;
constexpr double speed = 0.1;
constexpr double time_step = 0.02;
constexpr int steps = 1000;
constexpr int settled = 50;

WorldDefinition crushing() {
    WorldDefinition made = weightless();
    made.solver = SolverKind::direct;
    made.iterations = 500;
    made.tolerance = 1e-6;
    made.contact = crushing_ice(46e3, 0, 0);
    return made;
}

struct Scene {
    std::vector<ConvexSolid> structure;
    Pose ice;                 ///< at rest on it
    Vec3 inwards;             ///< normal of the contact, into the structure
    Vec3 off;                 ///< where the force acts, from the ice's middle
    Vec3 way = Vec3::Zero();  ///< of the structure, m/s
    double turning = 0;       ///< or about its axis, rad/s; then it is pressed towards the axis, wherever it comes to
};

/// The turn about the axis that takes one place to the azimuth of another.
Quat round_to(const Vec3& from, const Vec3& to) {
    return turned(std::atan2(from.z(), from.x()) - std::atan2(to.z(), to.x()), Vec3::UnitY());
}

/// Twenty seconds under 5 N: how deep its middle goes after the first one, and how its face turns from the structure's.
void expect_stays(const Scene& scene) {
    World world(crushing());
    const BodyId structure = world.add_structure(scene.structure, {Vec3::Zero()});
    const BodyId ice = world.add_element(element_at(scene.ice.position, scene.ice.orientation));
    double deep = 0;
    Vec3 lies = Vec3::Zero();
    double sum = 0;
    for (int step = 1; step <= steps; ++step) {
        const double time = time_step * step;
        world.move_structure({scene.way * time, turned(scene.turning * time, Vec3::UnitY())});
        const Quat round =
            scene.turning == 0 ? Quat::Identity() : round_to(scene.ice.position, world.state(ice).position);
        const Vec3 inwards = round * scene.inwards;
        const Vec3 force = 5 * inwards;
        world.apply(ice, {force, (round * scene.off).cross(force)});
        world.step();
        const BodyState state = world.state(ice);
        const double at = (state.position - round * scene.ice.position).dot(inwards);
        const Vec3 turned_to = state.rotation.transpose() * inwards;
        if (step == settled) {
            deep = at;
            lies = turned_to;
        }
        if (step <= settled) continue;
        sum += world.contact_force(structure).dot(inwards);
        ASSERT_LT(std::abs(at - deep), 2e-5) << time;
        ASSERT_GT(turned_to.dot(lies), std::cos(1e-3)) << time;
    }
    EXPECT_NEAR(sum / (steps - settled), 5, 0.01);
}

constexpr double half_thickness = element_thickness / 2;

TEST(SlidingOnHull, FlatOnAPlate) {
    expect_stays({.structure = {ConvexSolid(block({-5, -1, -1}, {5, 0, 1}))},
                  .ice = {{0, half_thickness, 0}},
                  .inwards = -Vec3::UnitY(),
                  .off = {0.06, 0, 0.04},
                  .way = {speed, 0, 0}});
}

TEST(SlidingOnHull, FlatBelowAKeelThatIsRound) {
    expect_stays({.structure = {Frustum{0, 3, 1, 3}},
                  .ice = {{0, -half_thickness, 0}},
                  .inwards = Vec3::UnitY(),
                  .off = {0.06, 0, 0.04},
                  .way = {speed, 0, 0}});
}

TEST(SlidingOnHull, FlatOnAConeOfFortyFiveDegrees) {
    const Vec3 inwards = -Vec3(1, 1, 0).normalized();
    expect_stays({.structure = {Frustum{-2, 3, 0.5, 0.5}},
                  .ice = {Vec3(1, 0, 0) - half_thickness * inwards, turned(-pi / 4, Vec3::UnitZ())},
                  .inwards = inwards,
                  .off = Vec3(1, -1, 0) * 0.04,
                  .turning = speed});
}

TEST(SlidingOnHull, ItsSideOnADrum) {
    expect_stays({.structure = {Frustum{-1, 1, 1, 1}},
                  .ice = {{1 + element_side / 2, 0, 0}},
                  .inwards = -Vec3::UnitX(),
                  .off = {0, 0.01, 0},
                  .turning = speed});
}

/// What holds an element in its place along x and its turn about z, as others would that it lies among.
Wrench held(const BodyState& state, const Pose& at) {
    const Eigen::AngleAxisd turn(state.rotation * at.orientation.conjugate().toRotationMatrix());
    return {Vec3(-60 * (state.position.x() - at.position.x()) - 5 * state.velocity.x(), 0, 0),
            Vec3(0, 0, -2 * turn.angle() * turn.axis().z() - 0.08 * state.angular_velocity.z())};
}

/// Twenty seconds under 5 N, off the middle of the line on which it lies, on a structure that slides along the line;
/// how deep the line goes.
double sunk_on_line(const Polyhedron& solid, const Pose& at, const Vec3& line) {
    World world(crushing());
    world.add_structure(std::vector<ConvexSolid>{ConvexSolid(solid)}, {Vec3::Zero()});
    const BodyId ice = world.add_element(element_at(at.position, at.orientation));
    double start = 0;
    double height = 0;
    for (int step = 1; step <= steps; ++step) {
        world.move_structure({Vec3(0, 0, speed * time_step * step)});
        const BodyState state = world.state(ice);
        const Vec3 to_line = state.rotation * line;
        const Vec3 force(0, -5, 0);
        Wrench wrench = held(state, at);
        wrench.force += force;
        wrench.moment += (to_line + Vec3(0, 0, 0.05)).cross(force);
        world.apply(ice, wrench);
        world.step();
        height = (world.state(ice).position + world.state(ice).rotation * line).y();
        if (step == settled) start = height;
    }
    return start - height;
}

TEST(SlidingOnHull, ItsEdgeOnAPlate) {
    const Vec3 edge(-element_side / 2, -half_thickness, 0);
    const Quat turn = turned(0.5, Vec3::UnitZ());
    EXPECT_LT(std::abs(sunk_on_line(block({-1, -1, -5}, {1, 0, 5}), {-(turn * edge), turn}, edge)), 2e-5);
}

TEST(SlidingOnHull, FlatOnAnEdge) {
    const std::vector<Vec3> roof{{-1, -1, -5}, {1, -1, -5}, {0, 0, -5}, {-1, -1, 5}, {1, -1, 5}, {0, 0, 5}};
    EXPECT_LT(std::abs(sunk_on_line(convex_hull(roof), {Vec3(0, half_thickness, 0)}, Vec3::Zero())), 2e-5);
}

// Ice on ice is no different.
TEST(SlidingOnIce, FlatOnASheet) {
    World world(crushing());
    const BodyId sheet =
        world.add_sliding_box({.half_extents = {5, 0.02, 1}, .position = {0, -0.02, 0}, .mass = 1e6, .axis = 0});
    BodyState moving = world.state(sheet);
    moving.velocity = {speed, 0, 0};
    world.place(sheet, moving);
    for (const bool hexagon : {false, true}) {
        ElementDefinition made = hexagon ? hexagon_at({-1, half_thickness, 0}) : element_at({1, half_thickness, 0});
        const BodyId ice = world.add_element(made);
        Vec3 start = Vec3::Zero();
        for (int step = 1; step <= steps; ++step) {
            const Vec3 force(0, -5, 0);
            world.apply(ice, {force, Vec3(0.05, 0, 0.04).cross(force)});
            world.step();
            if (step == settled) start = world.state(ice).position;
            if (step > settled) {
                ASSERT_NEAR(world.state(ice).position.y(), start.y(), 2e-5) << step;
            }
        }
        world.take_out(ice);
    }
}

}  // namespace sliding_on_hull_test
}  // namespace floes::test
