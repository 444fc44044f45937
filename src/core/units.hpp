#pragma once
// Plain SI doubles inside, other units only at input and output: value_in_SI = value_in_unit * unit.

#include <limits>
#include <numbers>

namespace floes {

/// A value that is not known or cannot be: NaN in files and arrays, an empty cell in tables.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace floes

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
inline constexpr double mebibyte = 1024 * 1024;

}  // namespace floes::unit
