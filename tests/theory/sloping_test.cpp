// ISO 19906's level ice on a slope and by crushing: the figures that OpenFAST's module IceFloe printed for its example
// (modules/icefloe/test/GLA_proto_flex_ISO.log), and limits.

#include "theory/level_ice.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace floes {
namespace sloping_test {

const IceHull cone{
    .breadth = 5, .length = 5, .draught = 0, .stem_angle = 60 * unit::degree, .entrance_angle = 0, .friction = 0.15};
const LevelIce sheet{.thickness = 1,
                     .bending_strength = 700e3,
                     .elastic_modulus = 8e9,
                     .density = 916.2,
                     .water_density = 999.8,
                     .poisson_ratio = 0.3,
                     .gravity = 9.81};

TEST(Sloping, HasEveryPartOfTheWorkedExample) {
    const SlopingLoad load = sloping_load(cone, sheet, Rubble{});
    EXPECT_NEAR(load.pushing, 2242, 0.5);
    EXPECT_NEAR(load.lifting, 209678, 0.5);
    EXPECT_NEAR(load.turning, 42609, 0.5);
    EXPECT_NEAR(load.ride_up, 408262, 0.5);
    EXPECT_NEAR(load.breaking, 1.84414e6, 5);
    EXPECT_NEAR(load.total(), 2.65997e6, 5);
}

TEST(Crushing, IsThatOfTheWorkedExample) {
    EXPECT_NEAR(crushing_load(5, 1, 2.2e6), 8.50271e6, 5);
    // n = -0.4 at 0.5 m, -0.3 from 1 m on.
    EXPECT_NEAR(crushing_load(5, 0.5, 1e6) / 2.5e6, std::pow(0.5, -0.4) * std::pow(10, -0.16), 1e-12);
    EXPECT_NEAR(crushing_load(30, 2, 1e6) / 60e6, std::pow(2, -0.3) * std::pow(15, -0.16), 1e-12);
}

// Without rubble, what is left is breaking and turning: 0.68 tan α σ_f (ρ_w g h⁵/E)^¼ l_c without friction.
TEST(Sloping, WithoutRubbleAndFrictionIsBreakingAndTurning) {
    IceHull smooth = cone;
    smooth.friction = 0;
    smooth.stem_angle = 45 * unit::degree;
    const SlopingLoad load = sloping_load(smooth, sheet, {.height = 0});
    const double length = std::pow(8e9 / (12 * 999.8 * 9.81 * 0.91), 0.25);
    const double crack = 5 + M_PI * M_PI * length / 4;
    EXPECT_NEAR(load.breaking, 0.68 * 700e3 * std::pow(999.8 * 9.81 / 8e9, 0.25) * crack, 1e-6);
    EXPECT_NEAR(load.turning, 1.5 * 5 * 916.2 * 9.81, 1e-6);
    EXPECT_EQ(load.pushing + load.lifting + load.ride_up, 0);
    EXPECT_NEAR(load.thrust, 1 / (1 - load.breaking / (700e3 * crack)), 1e-12);
}

// A pile at the wall's own angle has no weight on it: only the layer of blocks goes up the wall.
TEST(Sloping, OfRubbleAsSteepAsTheWallIsALayerOfBlocks) {
    const SlopingLoad load = sloping_load(cone, sheet, {.height = 3, .angle = 60 * unit::degree});
    EXPECT_NEAR(load.pushing, 0, 1e-9);
    EXPECT_NEAR(load.lifting, 0, 1e-9);
    const double push = std::sin(60 * unit::degree) + 0.15 * std::cos(60 * unit::degree);
    const double slide = std::cos(60 * unit::degree) - 0.15 * std::sin(60 * unit::degree);
    EXPECT_NEAR(load.ride_up, 5 * 3 * 916.2 * 9.81 * push / std::sin(60 * unit::degree) / slide, 1e-6);
}

// Lengths times λ, strengths and modulus times λ: loads times λ³ (Froude).
TEST(Sloping, ScalesByFroude) {
    const double scale = 20;
    IceHull large = cone;
    large.breadth *= scale;
    LevelIce thick = sheet;
    thick.thickness *= scale;
    thick.bending_strength *= scale;
    thick.elastic_modulus *= scale;
    const SlopingLoad small = sloping_load(cone, sheet, {.cohesion = 500});
    const SlopingLoad full = sloping_load(large, thick, {.height = 3 * scale, .cohesion = 500 * scale});
    EXPECT_NEAR(full.total() / small.total(), 8000, 1e-8);
    EXPECT_NEAR(full.lifting / small.lifting, 8000, 1e-8);
}

TEST(Sloping, RefusesWhatHasNoLoad) {
    IceHull steep = cone;
    steep.stem_angle = 84 * unit::degree;
    EXPECT_THROW(sloping_load(steep, sheet, Rubble{}), InputError);
    IceHull flat = cone;
    flat.stem_angle = 5 * unit::degree;
    EXPECT_THROW(sloping_load(flat, sheet, {.angle = 4 * unit::degree}), InputError);
    LevelIce soft = sheet;
    soft.elastic_modulus = 1e3;
    EXPECT_THROW(sloping_load(cone, soft, Rubble{}), InputError);
    for (const Rubble& none :
         {Rubble{.height = -1}, Rubble{.porosity = 1}, Rubble{.angle = 61 * unit::degree}, Rubble{.angle = 0},
          Rubble{.friction_angle = 90 * unit::degree}, Rubble{.cohesion = -1}, Rubble{.ice_friction = -0.1}})
        EXPECT_THROW(sloping_load(cone, sheet, none), InputError);
}

}  // namespace sloping_test
}  // namespace floes
