// Prisms: their inertia, contact with the structure, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "scene.hpp"
#include "shapes/shape.hpp"

namespace floes::test {
namespace prism_test {

WorldDefinition direct() {
    WorldDefinition definition = weightless();
    definition.solver = SolverKind::direct;
    definition.contact.friction = Friction::cone;
    definition.contact.normal = NormalLaw::crushing;
    definition.contact.crushing_pressure = 145e3;
    definition.contact.internal_edges = false;
    return definition;
}

TEST(WorldPrism, TurnsByItsOwnInertia) {
    World world(direct());
    const BodyId body = world.add_element(hexagon_at(Vec3::Zero()));
    const Measures of = measures_of(hexagon_at(Vec3::Zero()).corners);
    world.apply(body, {Vec3::Zero(), {0.01, 0.02, 0}});
    world.step();
    const double step = direct().time_step;
    const double flat = 1.2 * (of.zz / of.area + element_thickness * element_thickness / 12);
    EXPECT_NEAR(world.state(body).angular_velocity.x(), 0.01 * step / flat, 1e-9);
    EXPECT_NEAR(world.state(body).angular_velocity.y(), 0.02 * step / (1.2 * (of.xx + of.zz) / of.area), 1e-9);
}

TEST(WorldPrism, IsPushedByTheStructure) {
    World world(direct());
    const Shape shape({{-0.5, 0.3}, {0.5, 0.3}});
    world.add_structure(shape.solids(), {{0, 0, 0}});
    const BodyId body = world.add_element(hexagon_at({0.45, 0, 0}));
    for (int step = 1; step <= 200; ++step) {
        world.move_structure({{0.1 * 0.02 * step, 0, 0}});
        world.step();
    }
    EXPECT_NEAR(world.state(body).velocity.x(), 0.1, 0.02);
    EXPECT_GT(world.state(body).position.x() - 0.4, 0.3 + 0.12 * std::sqrt(0.75) - 0.01);
}

TEST(WorldPrism, RefusesWhatIsNone) {
    World world(direct());
    ElementDefinition dented = hexagon_at(Vec3::Zero());
    dented.corners[1] = {0, 0.01};
    EXPECT_THAT([&] { world.add_element(dented); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("not convex")));
    ElementDefinition aside = hexagon_at(Vec3::Zero());
    for (Corner& one : aside.corners) one.x += 0.05;
    EXPECT_THROW(world.add_element(aside), InputError);
}

}  // namespace prism_test
}  // namespace floes::test
