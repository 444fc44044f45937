#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "theory/plate.hpp"

namespace floes {
namespace plate_test {

/// dP/dw0 (N/m) under a point load: 8 sqrt(k D).
double point_load_slope(const FloatingPlate& plate, double elastic_modulus) {
    return 8 * std::sqrt(plate.foundation() * plate.flexural_rigidity(elastic_modulus));
}

// scipy.special.kerp at the same arguments.
TEST(Kelvin, AgreesWithScipy) {
    EXPECT_NEAR(kelvin_ker_prime(0.3), -3.2198652535539383, 1e-13);
    EXPECT_NEAR(kelvin_ker_prime(2.0), -0.10660096588105275, 1e-14);
    EXPECT_NEAR(kelvin_ker_prime(8.0), -0.0008797240991814695, 1e-11);
}

TEST(Kelvin, RefusesWhatTheSeriesCannotReach) {
    EXPECT_THROW(kelvin_ker_prime(0), InputError);
    EXPECT_THROW(kelvin_ker_prime(8.1), InputError);
    EXPECT_THROW(kelvin_ker_prime(std::nan("")), InputError);
}

TEST(FloatingPlate, HasThePapersCharacteristicLength) {
    const FloatingPlate ice{.thickness = 0.033};
    EXPECT_NEAR(ice.characteristic_length(30e6), 0.317, 5e-4);
    EXPECT_NEAR(ice.characteristic_length(60e6), 0.377, 5e-4);  // the paper: approximately 0.38 m
    EXPECT_NEAR(ice.characteristic_length(200e6), 0.509, 5e-4);
}

TEST(FloatingPlate, InvertsThePointLoad) {
    const FloatingPlate ice{.thickness = 0.030};
    for (const double modulus : {30e6, 60e6, 200e6})
        EXPECT_NEAR(modulus_from_point_slope(ice, point_load_slope(ice, modulus)), modulus, 1e-6 * modulus);
}

TEST(FloatingPlate, InvertsThePatchLoad) {
    const FloatingPlate ice{.thickness = 0.030};
    const double radius = 0.2 / std::sqrt(std::numbers::pi);
    for (const double modulus : {0.5e6, 30e6, 60e6, 200e6, 2e9})
        EXPECT_NEAR(modulus_from_patch_slope(ice, patch_load_slope(ice, modulus, radius), radius), modulus,
                    1e-9 * modulus);
}

TEST(FloatingPlate, ASmallPatchIsAPoint) {
    const FloatingPlate ice{.thickness = 0.030};
    EXPECT_NEAR(patch_load_slope(ice, 60e6, 1e-4) / point_load_slope(ice, 60e6), 1, 1e-6);
}

TEST(FloatingPlate, OneElementUnderTheLoadStiffensByNinePercentAt60MPa) {
    // w0 is lower by 4.1 %, so the point-load formula reads E higher by 8.8 %.
    const FloatingPlate ice{.thickness = 0.030};
    const double slope = patch_load_slope(ice, 60e6, 0.2 / std::sqrt(std::numbers::pi));
    EXPECT_NEAR(modulus_from_point_slope(ice, slope) / 60e6, 1.088, 1e-3);
}

TEST(FloatingPlate, RefusesASlopeThatWaterAloneExceeds) {
    EXPECT_THROW(modulus_from_patch_slope({.thickness = 0.030}, 300, 0.1128), InputError);
}

TEST(FloatingCantilever, ReadsMoreThanTheStrength) {
    EXPECT_NEAR(floating_cantilever_factor(60e6, 0.4, 0.033, 9810), 1.13, 5e-3);
    EXPECT_NEAR(floating_cantilever_factor(60e6, 0.6, 0.033, 9810), 1.70, 5e-3);
    EXPECT_NEAR(floating_cantilever_factor(60e12, 0.4, 0.033, 9810), 1, 1e-6);
}

TEST(Cantilever, NominalStrengthIsSixPLOverBHSquared) {
    EXPECT_DOUBLE_EQ(nominal_flexural_strength(2.0, 0.5, 0.2, 0.1), 6 * 2.0 * 0.5 / (0.2 * 0.01));
}

}  // namespace plate_test
}  // namespace floes
