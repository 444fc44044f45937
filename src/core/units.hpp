#pragma once
// Plain SI doubles inside, other units only at input and output: value_in_SI = value_in_unit * unit.

#include <numbers>

namespace floes::unit {

inline constexpr double one = 1.0;
inline constexpr double millimetre = 1e-3;
inline constexpr double kilopascal = 1e3;
inline constexpr double megapascal = 1e6;
inline constexpr double kilonewton = 1e3;
inline constexpr double tonne = 1e3;
inline constexpr double percent = 0.01;
inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double hour = 3600;

}  // namespace floes::unit
