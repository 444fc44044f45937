#pragma once
// How many floes of which size: number densities over the diameter D, the side of the square with the floe's area, cut
// off at the smallest and the largest. A law that is stated for the share of the area is turned into that of numbers: a
// floe covers D², so the number density is the density of the area over D².

#include "laws/factor_law.hpp"

namespace floes {

/// Of diameters, between low and high (m), 0 < low < high.
struct SizeBounds {
    double low = 0;
    double high = 0;
};

/// Density in proportion to D^-exponent: the D (m) that a share u (0 to 1) of the floes is smaller than.
double power_law_at(double u, double exponent, const SizeBounds& bounds);

/// Mean of D^power (m^power) of that law.
double power_law_moment(double power, double exponent, const SizeBounds& bounds);

/// Lognormal with this mean (m) and standard deviation over mean before it is cut off.
struct LognormalSizes {
    double mean = 0;
    double cov = 0;
};

/// The law of numbers where `of_area` says what share of the area floes below a diameter have: lognormal as well, its
/// median smaller by the factor exp(-2 s²), s² = ln(1 + cov²).
LognormalSizes number_law(const LognormalSizes& of_area);

/// The law between the bounds, as factors on its mean.
Factors cut_off(const LognormalSizes& law, const SizeBounds& bounds);

}  // namespace floes
