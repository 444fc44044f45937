#pragma once
// The largest load in an exposure by both tails of members that differ: draws of Pareto and Weibull tails
// (member_tails.hpp) above several thresholds, put together. Pareto's tail is the limit of all, so it has two thirds
// of the weight before any peak is seen, and never less than a third of that after.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "inference/bootstrap.hpp"
#include "inference/interval.hpp"
#include "inference/tails.hpp"

namespace floes {

/// How members of a case were measured, and above which thresholds their peaks are fitted.
struct PosteriorAsked {
    double window = 0;           ///< s, of each member
    double separation = 0;       ///< s, of peaks
    double mean = 0;             ///< load, N
    std::vector<double> shares;  ///< of the peaks, the highest, each a threshold
};

/// Shares of the peaks above which both tails are averaged: 2, 1 and 0.4 times `share`; `quick`: that alone.
std::vector<double> averaged_shares(double share, bool quick);

struct PosteriorFigure {
    double value;  ///< median, N
    Limits interval;
};

class PosteriorLoad {
  public:
    /// One tail; the weights of all draws add up to one.
    struct Draw {
        UnlikeTail tail;
        double weight;
    };

    /// `out`: rows that stand out, rising.
    PosteriorLoad(MemberPeakSpans peaks, const std::vector<std::size_t>& out, const PosteriorAsked& asked);

    /// Tails that are known.
    PosteriorLoad(double window, std::vector<Draw> draws) : window_(window), draws_(std::move(draws)) {}

    bool valid() const { return !draws_.empty(); }  ///< there are peaks enough

    /// The largest load in `exposure`, s, stays below it with probability p, 0 < p < 1.
    PosteriorFigure quantile(double exposure, double p) const;
    /// The mean of the largest load in `exposure`, s.
    PosteriorFigure expected(double exposure) const;

    const std::vector<Draw>& draws() const { return draws_; }
    double window() const { return window_; }  ///< s, of each member

    double weibull_weight() const;
    double scatter() const;  ///< median of the SD of log s over members that do not stand out
    double alike() const;    ///< probability that these do not differ at all

  private:
    void add(const TailData& data, std::uint32_t number);

    double window_;
    std::vector<Draw> draws_;
};

}  // namespace floes
