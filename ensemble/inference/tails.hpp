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
#include <vector>

#include "inference/numerics.hpp"

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
/// many events each peak stands for (events_per_peak()), one for each excess. Pareto with -1/2 <= ξ <= 1, in which
/// range maximum likelihood is regular and the mean exists; Weibull with 0.2 <= c <= 8 and `origin` below the
/// threshold. Invalid (scale NaN) for fewer than fewest_peaks or if all are equal.
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

// The tail of members that differ. Each member has a scale s of its own, log-normal over members, and peaks above x at
//   λ(x; s) = R exp(-H(x/s - u)),   Pareto: H(y) = log(1 + ξ y/σ)/ξ,   Weibull: H(y) = d/(c σ) ((1 + y/d)^c - 1)
// with d = u - b: the tails of tails.hpp, both written with σ, the mean excess just above the threshold u. The scale is
// integrated out of each member's likelihood. Members that stand out are a class of their own: the same tail, times a
// factor that is estimated, with a scatter of its own.
//
// The largest of N arrangements stays below x with probability (mean over s of exp(-w λ(x; s)))^N, w the window: a
// member with many high peaks counts once.
//
// Priors (docs/design_load.md argues them): flat for log R, log σ and the logarithm of the class's factor; ξ normal
// about 0 with SD 0.3 between -0.8 and 0.7; log c normal about log √2 with SD 0.5; the SD of log s in each class 0 with
// probability 1/2, else half-normal with 0.3; the class's share by Jeffreys' prior.

/// The peaks of one member above its class's threshold.
struct MemberPeaks {
    std::vector<double> peaks;    ///< N
    std::vector<double> weights;  ///< events that each stands for
    bool stands_out = false;
};

struct TailData {
    std::vector<MemberPeaks> members;
    double window = 0;         ///< s, of each
    double threshold = 0;      ///< u, N
    double out_threshold = 0;  ///< N, of members that stand out
    double origin = 0;         ///< b, N
};

/// One draw of a tail and of how members differ.
struct UnlikeTail {
    TailKind kind = TailKind::pareto;
    double threshold = 0;  ///< N
    double origin = 0;     ///< N
    double rate = 0;       ///< R, per s
    double scale = 0;      ///< σ, N
    double shape = 0;      ///< ξ or c
    double scatter = 0;    ///< SD of log s over members
    double out_share = 0;  ///< of members that stand out
    double out_factor = 1;
    double out_scatter = 0;
};

struct UnlikeTails {
    std::vector<UnlikeTail> draws;
    double log_evidence = 0;
};

/// Draws from the posterior; none if the data cannot be fitted.
UnlikeTails draw_tails(TailKind kind, const TailData& data, const WalkOptions& options);

/// Over which scales of members: to three standard deviations, or to six, where what is nearly never exceeded comes
/// from.
enum class Scales { usual, far };

/// Log of the probability that the largest peak in `members` windows, each of its own arrangement, stays below x.
double log_below(const UnlikeTail& tail, double window, double members, double x, Scales scales = Scales::usual);

/// The load that it stays below with log probability `log_p` < 0.
double largest_at(const UnlikeTail& tail, double window, double members, double log_p);

/// The mean of the largest.
double mean_largest(const UnlikeTail& tail, double window, double members);

// Peaks that a higher one nearby hides.
//
// Declustered peaks are at least a time s apart and taken from the highest down. So some independent events are lost,
// the lower they are the more. To take events in the order of height, and to leave out each that is closer than s to
// one taken before, is A. Rényi's parking problem (1958): cars of length s arrive in the order of height. Events at
// rate λ therefore give declustered peaks at rate θ(λ s)/s with
//   θ(u) = ∫ from 0 to u of exp(-2 ∫ from 0 to t of (1 - e^-v)/v dv) dt,
// and a share θ'(λ s) of the events of that height is seen. θ tends to 0.7476.

/// Events for each declustered peak at the height that `kept` declustered peaks exceed in one separation s, on average:
/// 1 / θ'(u) where θ(u) = kept. At least 1; for `kept` above θ(3) = 0.62, where hardly an event is seen, that at u = 3.
double events_per_peak(double kept);

}  // namespace floes
