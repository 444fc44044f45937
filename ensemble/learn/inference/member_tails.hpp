#pragma once
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

#include <span>
#include <vector>

#include "inference/random_walk.hpp"
#include "inference/tails.hpp"

namespace floes {

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

/// Log of the probability that the largest peak in `members` windows, each of its own arrangement, stays below x.
double log_below(const UnlikeTail& tail, double window, double members, double x);

/// The load that it stays below with log probability `log_p` < 0.
double largest_at(const UnlikeTail& tail, double window, double members, double log_p);

/// The mean of the largest.
double mean_largest(const UnlikeTail& tail, double window, double members);

}  // namespace floes
