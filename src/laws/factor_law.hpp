#pragma once
// Laws of a positive number that is 1 on average: what a property of single floes is multiplied by. A law is cut off at
// two bounds, and what is left keeps its proportions.

#include <memory>

namespace floes {

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

}  // namespace floes
