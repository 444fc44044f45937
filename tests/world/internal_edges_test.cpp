// Faces and rims that lie inside a body (contact.internal_edges): docs/convergence.md.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "scene.hpp"
#include "shapes/shape.hpp"

namespace floes::test {
namespace internal_edges_test {

WorldDefinition with(bool internal_edges, NormalLaw law) {
    return {.time_step = 0.01,
            .gravity = 0,
            .contact = {.erp = 0,
                        .ice_ice_friction = 0,
                        .ice_structure_friction = 0,
                        .normal = law,
                        .crushing_pressure = 145.6e3,
                        .internal_edges = internal_edges},
            .solver = SolverKind::lanes};
}

/// Two elements of a floe side by side along z, and a third one whose corner is 2 mm inside the face of the first and
/// slides on, past the boundary between them. What is left of its speed. `removed` of the joints do not hold any more.
double slides_on(bool internal_edges, NormalLaw law, int joints, int removed = 0, bool asleep = false) {
    constexpr double speed = 0.1;
    World world(with(internal_edges, law));
    const BodyId first = world.add_element(element_at({0, 0, -element_side / 2}, Quat::Identity(), 0));
    const BodyId second = world.add_element(element_at({0, 0, element_side / 2}, Quat::Identity(), 0));
    // The joint's x axis points from the first to the second.
    std::vector<JointId> all;
    for (int k = 0; k < joints; ++k)
        all.push_back(
            world.add_joint({first, second, Vec3::Zero(), turned(-std::acos(0.0), Vec3::UnitY()), 1e-10, 0.8}));
    for (int k = 0; k < removed; ++k) world.remove_joint(all[static_cast<std::size_t>(k)]);
    for (const BodyId of_floe : {first, second}) world.set_asleep(of_floe, asleep);
    const double corner = element_side / std::sqrt(2.0);
    const Vec3 at(element_side / 2 + corner - 0.002, 0, -0.01);
    const BodyId body = world.add_element(element_at(at, turned(std::acos(0.0) / 2, Vec3::UnitY())));
    set_moving(world, body, Vec3(0, 0, speed));
    for (int step = 0; step < 30; ++step) world.step();
    return world.state(body).velocity.z() / speed;
}

TEST(InternalEdges, ACornerSlidesPastTheBoundaryOfTwoElements) {
    for (const NormalLaw law : {NormalLaw::rigid, NormalLaw::crushing}) {
        EXPECT_NEAR(slides_on(false, law, 1), 1, 1e-9);
        EXPECT_LT(slides_on(true, law, 1), 0.9) << "as in Bullet it is stopped by a face inside the floe";
        EXPECT_LT(slides_on(false, law, 1, 1), 0.9) << "without the joint the face is outside";
        EXPECT_NEAR(slides_on(false, law, 2, 1), 1, 1e-9) << "one joint is enough, as that of a place used again";
        EXPECT_NEAR(slides_on(false, law, 1, 0, true), 1, 1e-9) << "a floe that rests, too";
        EXPECT_LT(slides_on(false, law, 1, 1, true), 0.9);
    }
}

// A level floe is pressed flat on a waist, deep enough to meet the rim of the lower solid.
Vec3 force_of_a_waist(const std::vector<ConvexSolid>& solids) {
    World world(with(false, NormalLaw::crushing));
    const BodyId structure = world.add_structure(solids, {Vec3::Zero()});
    const BodyId body = world.add_element(element_at({0.614 + element_side / 2, 0.002 - element_thickness / 2, 0}));
    set_moving(world, body, Vec3(-0.05, 0, 0));
    Vec3 most = Vec3::Zero();
    for (int step = 0; step < 20; ++step) {
        world.step();
        const Vec3 force = world.contact_force(structure);
        if (std::abs(force.x()) > std::abs(most.x())) most = force;
    }
    return most;
}

TEST(InternalEdges, AWaistPushesAlongTheNormalsOfItsWalls) {
    const Shape shape({{-0.443, 0.499}, {0, 0.614}, {0.122, 0.736}});
    const double lower = 0.115 / 0.443;  // rise of the force over its thrust at the lower wall; 1 at the upper
    const Vec3 overlapping = force_of_a_waist(shape.overlapping_solids());
    EXPECT_LT(overlapping.x(), -0.1);
    EXPECT_GE(overlapping.y() / -overlapping.x(), 0.99 * lower);
    const Vec3 rim = force_of_a_waist(shape.solids());
    EXPECT_LT(rim.y() / -rim.x(), 0.8 * lower) << "a rim between solids pushes as it likes";
}

TEST(InternalEdges, StockRefusesToLeaveThemOut) {
    WorldDefinition definition = with(false, NormalLaw::rigid);
    definition.solver = SolverKind::stock;
    EXPECT_THROW(World{definition}, InputError);
}

}  // namespace internal_edges_test
}  // namespace floes::test
