// A structure of convex pieces: which of them is touched, and where its faces are.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene.hpp"
#include "shapes/shape.hpp"

namespace floes::test {
namespace hull_test {

constexpr double speed = 0.07;
constexpr double time_step = 0.02;
/// From the axis to the middle of an element at a face 0.5 m ahead: contacts are found between the structure at the end
/// of a step and ice at its beginning.
constexpr double touching = 0.5 + element_side / 2 + speed * time_step;

struct Rest {
    double at;  ///< distance from the axis
    Vec3 load;  ///< on the structure
    int solid;  ///< that is touched
};

/// Of an element that is held against the moving structure by 5 N.
Rest rest(const std::vector<ConvexSolid>& solids) {
    World world(weightless());
    const BodyId structure = world.add_structure(solids, {Vec3::Zero()});
    const BodyId body = world.add_element(element_at({0.65, 0, 0.03}));
    Vec3 sum = Vec3::Zero();
    const int count = 1000;
    std::vector<ContactForce> contacts;
    for (int step = 0; step < 2 * count; ++step) {
        world.move_structure({{speed * time_step * (step + 1), 0, 0}});
        world.apply(body, {Vec3(-5, 0, 0), Vec3::Zero()});
        world.step();
        if (step >= count) sum += world.contact_force(structure);
    }
    world.read_contacts(contacts, structure);
    return {world.state(body).position.x() - world.state(structure).position.x(), sum / count,
            contacts.empty() ? -1 : contacts.front().solid};
}

// The face lies exactly where it is drawn: the core is smaller by the margin that Bullet adds.
TEST(WorldHull, ABlockCarriesTheForceAtItsFace) {
    const std::vector<ConvexSolid> hull{ConvexSolid(block({-2, -1, -1}, {-1, 1, 1}), 0),
                                        ConvexSolid(block({-1, -1, -1}, {0.5, 1, 1}), 1)};
    const auto [at, load, solid] = rest(hull);
    EXPECT_NEAR(load.x(), -5, 1e-3);
    EXPECT_NEAR(load.z(), 0, 1e-3);
    EXPECT_NEAR(at, touching, 2e-4);
    EXPECT_EQ(solid, 1) << "it is at the second solid";
}

// A frustum that is moved aside is the same frustum there.
TEST(WorldHull, ALegStandsWhereItIsPlaced) {
    const std::vector<ConvexSolid> legs{ConvexSolid(Frustum{-1, 0.3, 1, 0.3}, Vec3(-0.8, 0, 0.7), 0),
                                        ConvexSolid(Frustum{-1, 0.3, 1, 0.3}, Vec3(0.2, 0, 0.03), 1)};
    const auto [at, load, solid] = rest(legs);
    EXPECT_NEAR(load.x(), -5, 1e-3);
    EXPECT_NEAR(at, touching, 2e-4);
    EXPECT_EQ(solid, 1);
}

// The drum of a polygon with many sides is the drum.
TEST(WorldHull, AManySidedPrismIsNearlyRound) {
    std::vector<Vec3> corners;
    for (int side = 0; side < 64; ++side)
        for (const double y : {-1.0, 1.0})
            corners.emplace_back(0.5 * std::cos(side * std::acos(-1.0) / 32), y,
                                 0.03 + 0.5 * std::sin(side * std::acos(-1.0) / 32));
    const auto [at, load, solid] = rest({ConvexSolid(convex_hull(corners))});
    EXPECT_NEAR(load.x(), -5, 1e-3);
    EXPECT_NEAR(at, touching, 2e-3);
}

}  // namespace hull_test
}  // namespace floes::test
