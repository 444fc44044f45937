// Boxes that move along one axis only, with each solver: as a force moves them, and never otherwise.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "solver/lane_width.hpp"
#include "world/world.hpp"

namespace floes {
namespace sliding_box_test {

constexpr double step = 0.02;

WorldDefinition definition(SolverKind solver, int lanes = 0) {
    WorldDefinition d{.time_step = step, .iterations = 200, .solver = solver, .lanes = lanes};
    d.contact.ice_ice_friction = 0.3;
    d.contact.split_impulse = false;
    if (solver == SolverKind::direct) d.contact.friction = Friction::cone;
    return d;
}

constexpr SolverKind all_solvers[] = {SolverKind::stock, SolverKind::lanes, SolverKind::direct};

SlidingBoxDefinition sheet(double z) {
    return {.half_extents = {2, 0.0165, 0.5}, .position = {0, 0, z}, .mass = 120, .axis = 2};
}

/// Holds an element up, so that only forces in the plane act.
void float_up(World& world, BodyId body, double mass) {
    world.apply(body, {{0, mass * 9.81, 0}, Vec3::Zero()});
}

TEST(SlidingBox, MovesAsItsMassUnderAForceAlongItsAxisAndNotUnderAnyOther) {
    for (const SolverKind solver : all_solvers) {
        World world(definition(solver));
        const BodyId body = world.add_sliding_box(sheet(1));
        for (int i = 0; i < 50; ++i) {
            world.apply(body, {{500, -300, 24}, {10, 20, 30}});
            world.step();
        }
        const BodyState state = world.state(body);
        EXPECT_NEAR(state.velocity.z(), 24.0 / 120 * 1.0, 1e-9);
        EXPECT_NEAR(state.velocity.x(), 0, 1e-9);
        EXPECT_NEAR(state.velocity.y(), 0, 1e-9);
        EXPECT_NEAR(state.position.x(), 0, 1e-9);
        EXPECT_LT((state.rotation - Mat3::Identity()).norm(), 1e-9);
    }
}

/// A row of boxes between two sheets that press on it with 30 N each: every contact carries 30 N, and nothing moves.
TEST(SlidingBox, PressesARowOfBoxesWithItsForce) {
    for (const SolverKind solver : all_solvers) {
        World world(definition(solver));
        constexpr double mass = 1.2;
        std::vector<BodyId> row;
        for (int i = 0; i < 3; ++i) {
            row.push_back(world.add_element({.corners = corners_of(0.1, 0.1),
                                             .half_thickness = 0.0165,
                                             .mass = mass,
                                             .pose = {.position = {0, 0, -0.2 + 0.2 * i}}}));
        }
        const BodyId low = world.add_sliding_box(sheet(-0.8));
        const BodyId high = world.add_sliding_box(sheet(0.8));
        for (int i = 0; i < 400; ++i) {
            for (const BodyId body : row) float_up(world, body, mass);
            world.apply(low, {{0, 0, 30}, Vec3::Zero()});
            world.apply(high, {{0, 0, -30}, Vec3::Zero()});
            world.step();
        }
        EXPECT_NEAR(world.contact_force(low).z(), -30, 0.1) << static_cast<int>(solver);
        EXPECT_NEAR(world.contact_force(high).z(), 30, 0.1) << static_cast<int>(solver);
        EXPECT_NEAR(world.state(high).velocity.z(), 0, 1e-4);
        EXPECT_NEAR(world.state(row[1]).position.z(), 0, 1e-3);
    }
}

/// A sheet that touches the end of a box of mass m with a force F across takes it along at F/(M + m), light or heavy.
TEST(SlidingBox, CarriesWhatItPushesHoweverHeavy) {
    for (const SolverKind solver : all_solvers) {
        for (const double mass : {1.0, 120.0, 5000.0}) {
            World world(definition(solver));
            const BodyId box = world.add_element({.corners = corners_of(0.2, 0.2),
                                                  .half_thickness = 0.0165,
                                                  .mass = mass,
                                                  .pose = {.position = {0, 0, -0.2}}});
            const BodyId pushing = world.add_sliding_box(sheet(0.5));
            for (int i = 0; i < 100; ++i) {
                float_up(world, box, mass);
                world.apply(pushing, {{0, 0, -50}, Vec3::Zero()});
                world.step();
            }
            const double expected = -50 / (120 + mass) * 2;
            EXPECT_NEAR(world.state(box).velocity.z(), expected, 0.01 * std::abs(expected)) << mass;
            EXPECT_NEAR(world.state(pushing).velocity.z(), expected, 0.01 * std::abs(expected)) << mass;
        }
    }
}

/// A sheet pressed on a box with N holds it by friction along its edge: below μ N it sticks, above it slides. While it
/// slides, a face may lose a contact point for a step, whereupon box and sheets are driven apart and come back: with
/// other numbers of sweeps and other pulls the friction of such a second is mostly within 1 % of μ N, at worst 9 %
/// below it.
TEST(SlidingBox, HoldsByFrictionWithoutMovingAlong) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        for (const double pull : {5.0, 25.2, 30.0}) {
            WorldDefinition d = definition(solver);
            d.contact.friction = Friction::cone;
            if (solver == SolverKind::direct) d.tolerance = 1e-3;
            World world(d);
            constexpr double mass = 2;
            const BodyId box = world.add_element({.corners = corners_of(0.1, 0.1),
                                                  .half_thickness = 0.0165,
                                                  .mass = mass,
                                                  .pose = {.position = {0, 0, 0}}});
            const BodyId low = world.add_sliding_box(sheet(-0.6));
            const BodyId high = world.add_sliding_box(sheet(0.6));
            if (solver == SolverKind::lanes && pull > 26) continue;  // off the end of the sheets
            for (int i = 0; i < (solver == SolverKind::direct ? 60 : 100); ++i) {
                float_up(world, box, mass);
                world.apply(box, {{i < 20 ? 0 : pull, 0, 0}, Vec3::Zero()});
                world.apply(low, {{0, 0, 40}, Vec3::Zero()});
                world.apply(high, {{0, 0, -40}, Vec3::Zero()});
                world.step();
            }
            const double friction = 2 * 0.3 * 40;
            const double expected =
                pull < friction ? 0 : (pull - friction) / mass * (solver == SolverKind::direct ? 40 : 80) * step;
            EXPECT_NEAR(world.state(box).velocity.x(), expected, 0.02) << pull;
            EXPECT_NEAR(world.state(high).position.x(), 0, 1e-9);
        }
    }
}

TEST(SlidingBox, HasTheSameBitsAtEveryWidth) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        std::vector<Vec3> ends;
        for (const int lanes : lane_widths()) {
            World world(definition(solver, lanes));
            std::vector<BodyId> boxes;
            for (int i = 0; i < 9; ++i) {
                boxes.push_back(
                    world.add_element({.corners = corners_of(0.1, 0.1),
                                       .half_thickness = 0.0165,
                                       .mass = 1.2,
                                       .pose = {.position = {0.21 * (i % 3), 0, 0.203 * (i / 3)},
                                                .orientation = Quat(Eigen::AngleAxisd(0.07 * i, Vec3::UnitY()))}}));
            }
            const BodyId low = world.add_sliding_box(sheet(-0.64));
            const BodyId high = world.add_sliding_box(sheet(1.05));
            for (int i = 0; i < 100; ++i) {
                for (const BodyId body : boxes) float_up(world, body, 1.2);
                world.apply(low, {{0, 0, 40}, Vec3::Zero()});
                world.apply(high, {{0, 0, -40}, Vec3::Zero()});
                world.step();
            }
            ends.push_back(world.state(boxes[4]).position);
            EXPECT_EQ(ends.back(), ends.front()) << lanes;
        }
    }
}

TEST(SlidingBox, IsRefusedWithoutMass) {
    World world(definition(SolverKind::lanes));
    SlidingBoxDefinition box = sheet(1);
    box.mass = 0;
    EXPECT_THROW(world.add_sliding_box(box), InputError);
}

}  // namespace sliding_box_test
}  // namespace floes
