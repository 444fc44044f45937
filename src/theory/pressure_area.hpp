#pragma once
// The usual pressure of ice over area, for local design: ISO 19906:2010 (A.8.2.5) for thick, massive ice, after D. M.
// Masterson, R. M. W. Frederking, B. Wright, T. Kärnä and W. P. Maddock, "A revised ice pressure-area curve", POAC
// 2007. Neither is open; the numbers are as the literature quotes them, and 7.40 A^-0.70 meets 1.48 at 10 m².
//
// It is a line above measurements at full scale (their mean and three standard deviations), most of multi-year ice that
// crushes, and says nothing of floes that bend or of model ice.

#include <cmath>

namespace floes {

/// Pa, of the pressure averaged over an area, m², above 0.
inline double pressure_of_area(double area) {
    constexpr double bend = 10;  // m²
    return area <= bend ? 7.40e6 * std::pow(area, -0.70) : 1.48e6;
}

}  // namespace floes
