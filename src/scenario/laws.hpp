#pragma once
// Laws that floes differ by: ice from its brine, factors on a property, and sizes.

#include <memory>

namespace floes {

// Strength and stiffness of sea ice from its salinity and temperature, by way of the share of brine in it.

/// Volume of brine over that of the ice: S (49.185 / |T| + 0.532), S in parts, T in °C from -0.5 to -22.9. Frankenstein
/// and Garner, "Equations for determining the brine volume of sea ice from -0.5° to -22.9°C", J. Glaciology 6(48),
/// 1967.
double brine_volume(double salinity, double temperature);

/// Flexural strength, Pa: 1.76 MPa exp(-5.88 √ν_b). Timco and O'Brien, "Flexural strength equation for sea ice", Cold
/// Regions Science and Technology 22(3), 1994.
double flexural_strength(double brine);

/// Elastic modulus, Pa: 10 GPa - 35.1 GPa ν_b, which is 0 at 0.285. From memory, of Langleben
/// and Pounder (1963): of sound and small quick loads; ice that is loaded for seconds yields more.
double brine_modulus(double brine);

// Laws of a positive number that is 1 on average: what a property of single floes is multiplied by. A law is cut off at
// two bounds, and what is left keeps its proportions.

enum class LawKind { none, normal, lognormal, weibull, uniform };

struct FactorLaw {
    LawKind kind = LawKind::none;
    double cov = 0;   ///< standard deviation over mean, before it is cut off; above 0
    double low = 0;   ///< least factor, at least 0
    double high = 0;  ///< largest factor, above low
};

/// A law that is not `none`, ready to be drawn from.
class Factors {
  public:
    explicit Factors(const FactorLaw& law);

    /// Share of the law that its bounds leave, 0 to 1. Nothing can be drawn where it is 0.
    double mass() const { return above_low_ - below_low_; }

    /// The bounds within which the law has any mass.
    double low() const { return low_; }
    double high() const { return high_; }

    /// The factor that a share u of the law is below, 0 <= u < 1. It is rounded to single precision, so that it does
    /// not show that C libraries differ in the last bits of exp() and log().
    double at(double u) const;

  private:
    struct Law;  // Boost's headers stay out of this one, which nearly every file includes: they took half of the build
    std::shared_ptr<const Law> law_;
    double low_;
    double high_;
    double below_low_;  // cumulative probability at either bound
    double above_low_;
};

/// Shape of the Weibull law with this standard deviation over its mean (0.001 to 1): the k of
/// Γ(1 + 2/k) / Γ(1 + 1/k)² - 1 = cov².
double weibull_shape(double cov);

/// Standard normal distribution and its inverse. 0 < u < 1.
double normal_share(double z);
double normal_at(double u);

// How many floes of which size: number densities over the diameter D, the side of the square with the floe's area, cut
// off at the smallest and the largest. A law that is stated for the share of the area is turned into that of numbers: a
// floe covers D², so the number density is the density of the area over D².

/// A law of diameters, between low and high (m), 0 < low < high.
struct SizeBounds {
    double low = 0;
    double high = 0;
};

/// Density in proportion to D^-exponent: the D (m) that a share u (0 to 1) of the floes is smaller than.
double power_law_at(double u, double exponent, const SizeBounds& bounds);

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
