#include "theory/rubble.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace floes {
namespace rubble_test {

constexpr PiledIce pile{.porosity = 0.4, .angle = 30 * unit::degree, .ice_density = 926, .water_density = 1010};
constexpr double upright = std::numbers::pi / 2;

// By slices: the triangle between wall and slope holds what floats.
TEST(Keel, HoldsTheShareOfTheIceThatFloats) {
    for (const double wall : {upright, 60 * unit::degree}) {
        const double ice = 0.7;
        const double depth = keel_depth(pile, ice, wall);
        double volume = 0;
        constexpr int slices = 1000;
        for (int i = 0; i < slices; ++i) {
            const double above = depth * (1 - (i + 0.5) / slices);  // of the foot of the pile
            volume += above * (1 / std::tan(pile.angle) - 1 / std::tan(wall)) * depth / slices;
        }
        const double under_water = volume * (1 - pile.porosity);
        EXPECT_NEAR(under_water * pile.water_density, ice * pile.ice_density, 1e-9 * ice * pile.ice_density);
        EXPECT_NEAR(length_until_grounded(pile, 0.05, depth, wall), ice / 0.05, 1e-9);
    }
    EXPECT_THROW(keel_depth(pile, 1, 20 * unit::degree), InputError);
}

// Without friction it is a liquid; with it the two limits lie as far apart as tan⁴(45° + φ/2).
TEST(RubblePressure, IsThatOfALiquidWithoutFriction) {
    const RubblePressure liquid = rubble_pressure(pile, 2, 0.3, 0);
    EXPECT_NEAR(liquid.active, 0.5 * (pile.lift() * 4 + pile.weight() * 0.09), 1e-9);
    EXPECT_NEAR(liquid.passive, liquid.active, 1e-9);
    EXPECT_NEAR(pile.lift(), 0.6 * 84 * 9.81, 1e-9);
    const RubblePressure rough = rubble_pressure(pile, 2, 0.3, 30 * unit::degree);
    EXPECT_NEAR(rough.active, liquid.active / 3, 1e-9);
    EXPECT_NEAR(rough.passive, liquid.active * 3, 1e-9);
}

}  // namespace rubble_test
}  // namespace floes
