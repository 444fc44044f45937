#include "theory/level_ice.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace pressure_area_test {

// 7.40 A^-0.70 MPa up to 10 m², where it meets 1.48 MPa to two digits.
TEST(PressureOfArea, FallsToTenSquareMetres) {
    EXPECT_DOUBLE_EQ(pressure_of_area(1), 7.40e6);
    EXPECT_NEAR(pressure_of_area(0.1), 37.1e6, 0.05e6);
    EXPECT_NEAR(pressure_of_area(4) / pressure_of_area(2), std::exp2(-0.70), 1e-12);
    EXPECT_NEAR(pressure_of_area(10), pressure_of_area(11), 0.005e6);
    EXPECT_EQ(pressure_of_area(11), 1.48e6);
    EXPECT_EQ(pressure_of_area(1000), 1.48e6);
}

}  // namespace pressure_area_test
}  // namespace floes
