#pragma once
// Distributions of segment maxima: fits, goodness of fit, and loads for longer exposure.
//
// z = (x - location) / scale.
//   Gumbel:  F(x) = exp(-exp(-z))
//   GEV:     F(x) = exp(-(1 + ξ z)^(-1/ξ)), 1 + ξ z > 0; ξ = 0 is Gumbel, ξ < 0 has an upper bound, ξ > 0 a heavy tail.
// scipy: gumbel_r(location, scale), genextreme(c = -ξ, location, scale).
// S. Coles, An Introduction to Statistical Modeling of Extreme Values, Springer 2001, chapter 3.

#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

/// A fitted distribution of maxima; Gumbel has shape 0. All NaN if it could not be fitted.
struct ExtremeFit {
    double location = 0;  ///< unit of the maxima
    double scale = 0;     ///< the same, > 0
    double shape = 0;     ///< ξ
    double log_likelihood = 0;

    bool valid() const { return scale > 0; }
};

enum class ExtremeKind { gumbel, gev };

/// Fewest maxima that are fitted.
inline constexpr std::size_t fewest_maxima = 10;

/// From L-moments: J. R. M. Hosking, J. R. Stat. Soc. B 52 (1990) 105-124; the shape by the approximation of J. R. M.
/// Hosking, J. R. Wallis and E. F. Wood, Technometrics 27 (1985) 251-261. Invalid if all `maxima` are equal.
ExtremeFit fit_by_l_moments(std::span<const double> maxima, ExtremeKind kind);

/// Maximum likelihood, started from L-moments: Gumbel's scale is the root of its likelihood equation, GEV's three
/// parameters are found by the Nelder-Mead simplex of NLopt with -1 < ξ < 1 (below -1 the likelihood has no maximum).
/// Invalid for fewer than `fewest_maxima`, if all are equal, or where the shape ends at -1 or 1. `start`: another
/// starting point, for resamples, whose shape may end there.
ExtremeFit fit_maxima(std::span<const double> maxima, ExtremeKind kind, const ExtremeFit* start = nullptr);

/// log likelihood of the maxima; -∞ where one lies outside the distribution's range.
double log_likelihood(const ExtremeFit& fit, std::span<const double> maxima);

double extreme_cdf(const ExtremeFit& fit, double x);
/// 0 < p < 1.
double extreme_quantile(const ExtremeFit& fit, double p);

/// The maximum that one segment in `segments` exceeds on average: the quantile at 1 - 1/segments; `segments` > 1.
double return_level(const ExtremeFit& fit, double segments);

/// Distances between the fit and the data: Anderson-Darling A², which weighs the tails, and Kolmogorov-Smirnov D.
struct Distances {
    double anderson_darling;
    double kolmogorov_smirnov;
};
Distances distances(const ExtremeFit& fit, std::span<const double> maxima);

/// Share of `samples` samples, drawn from the fit and refitted, that lie at least as far from their fit as the data
/// from theirs (parametric bootstrap). A small value means a poor fit. Treats the maxima as independent.
struct GoodnessOfFit {
    Distances found;
    double anderson_darling_p;
    double kolmogorov_smirnov_p;
};
GoodnessOfFit goodness_of_fit(const ExtremeFit& fit, ExtremeKind kind, std::span<const double> maxima, int samples = 0);

/// Empirical probability that a segment's maximum exceeds a load: of n sorted maxima the i-th largest is exceeded with
/// probability i / (n + 1) (Weibull's plotting position).
struct ExceedancePoint {
    double load;
    double probability;
};
std::vector<ExceedancePoint> exceedance_curve(std::vector<double> maxima);

/// A fit, and how well it fits. It has no intervals: those by bootstrap over arrangements hold far less often than they
/// say, because maxima are few and their distribution is not known (docs/design_load.md).
struct FittedExtreme {
    ExtremeKind kind = ExtremeKind::gumbel;
    ExtremeFit fit;
    GoodnessOfFit goodness{};
};

/// Fits the maxima of all arrangements together. Everything is NaN if there are too few.
FittedExtreme fit_extremes(std::span<const double> maxima, ExtremeKind kind);

}  // namespace floes
