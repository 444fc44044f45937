#pragma once
// How rare high peaks are: the rate of peaks above a level x, fitted to the declustered peaks above a threshold u.
//   Pareto:   λ(x) = λ_u (1 + ξ (x - u)/σ)^(-1/ξ)              peaks over a threshold; ξ = 0: λ_u exp(-(x - u)/σ)
//   Weibull:  λ(x) = λ_u exp(((u - b)/a)^c - ((x - b)/a)^c)    the tail of average exceedance rates (ACER)
// The first is the limit of the excess over ever higher thresholds: S. Coles, An Introduction to Statistical Modeling
// of Extreme Values, Springer 2001, chapter 4. The second is the form that A. Naess and O. Gaidai fit to rates below
// the limit, Structural Safety 31 (2009) 325-334, Eq. (26), here with b given: for a Gaussian process it is exact with
// b its mean and c = 2, for exponential peaks with c = 1. Each has two parameters, found by maximum likelihood from the
// same peaks, so their likelihoods compare.
//
// Peaks so far apart are taken as a Poisson process: the largest in a time T is below x with probability exp(-T λ(x)).

#include <span>

namespace floes {

enum class TailKind { pareto, weibull };

struct Tail {
    TailKind kind = TailKind::pareto;
    double threshold = 0;  ///< u, N
    double rate = 0;       ///< λ_u, peaks above the threshold per s
    double origin = 0;     ///< b, N; Weibull only
    double scale = 0;      ///< σ or a, N, > 0
    double shape = 0;      ///< ξ or c
    double log_likelihood = 0;

    bool valid() const { return scale > 0; }
};

/// Fewest peaks above the threshold that are fitted.
inline constexpr std::size_t fewest_peaks = 20;

/// The tail of peaks that exceed `threshold` by `excesses`, N, all positive, in `time` s. `weights`: how
/// many events each peak stands for (hidden_peaks.hpp), one for each excess. Pareto with -1/2 <= ξ <= 1, in which range
/// maximum likelihood is regular and the mean exists; Weibull with 0.2 <= c <= 8 and `origin` below the threshold.
/// Invalid (scale NaN) for fewer than fewest_peaks or if all are equal.
Tail fit_tail(TailKind kind, std::span<const double> excesses, std::span<const double> weights, double threshold,
              double origin, double time);

/// λ(x), per s; the rate at the threshold for x below it.
double rate_above(const Tail& tail, double x);
/// The level that peaks exceed at `rate`, per s; the threshold where that many exceed it anyway.
double level_at(const Tail& tail, double rate);

/// The load that the largest peak in `exposure`, s, stays below with probability p, 0 < p < 1.
double quantile_of_largest(const Tail& tail, double exposure, double p);
/// The mean of the largest peak in `exposure`, s.
double expected_largest(const Tail& tail, double exposure);

}  // namespace floes
