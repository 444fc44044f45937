#pragma once
// The largest load in an exposure by both tails of members that differ: draws of Pareto and Weibull tails
// (tails.hpp) above several thresholds, put together. Pareto's tail is the limit of all, so it has two thirds
// of the weight before any peak is seen, and never less than a third of that after. Limits are 95 % by trials: so often
// they hold the truth of known sets (docs/design_load.md).

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "inference/interval.hpp"
#include "inference/tails.hpp"

namespace floes {

/// How the members of a case were measured.
struct Measured {
    double window = 0;      ///< length of each member's record, s
    double segment = 0;     ///< s
    double separation = 0;  ///< of the peaks, s
    double mean = 0;        ///< load, N: the origin of the Weibull tail
};

/// Shares of the peaks above which both tails are averaged: 2, 1 and 0.4 times `share`; `quick`: that alone.
std::vector<double> averaged_shares(double share, bool quick);

class PosteriorLoad {
  public:
    /// One tail; the weights of all draws add up to one.
    struct Draw {
        UnlikeTail tail;
        double weight;
    };

    /// `out`: rows that stand out, rising. `shares`: of the peaks, the highest, each a threshold; falling.
    PosteriorLoad(MemberPeakSpans peaks, const std::vector<std::size_t>& out, const Measured& measured,
                  const std::vector<double>& shares);

    /// Tails that are known.
    PosteriorLoad(double window, std::vector<Draw> draws) : window_(window), draws_(std::move(draws)) {}

    bool valid() const { return !draws_.empty(); }  ///< there are peaks enough

    /// The largest load in `exposure`, s, stays below it with probability p, 0 < p < 1.
    LoadFigure quantile(double exposure, double p) const;
    /// The mean of the largest load in `exposure`, s.
    LoadFigure expected(double exposure) const;

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

// The largest load in a year of several regimes, each with hours and a tail of its own. It stays below x with
// probability
//   exp(-Σ T_i λ_i(x))
// for members that are alike, with λ_i(x) the rate of peaks above x of regime i and T_i its time in a year; of members
// that differ, exp(-T λ) is (mean over their scales of exp(-w λ))^(T/w), as in tails.hpp. Regimes follow one
// another and a year has many passages through each, so what one brings says nothing of the others.
//
// What is not known are the tails: each source (a case, or a design that is interpolated) has its posterior draws.
// Sources are independent, so a draw of the year takes one of each.

/// The tail of a regime: that of a source, times a factor.
struct YearRegime {
    std::size_t source = 0;
    double time = 0;       ///< s in a year
    double factor = 1;     ///< of the source's loads
    double factor_sd = 0;  ///< standard uncertainty of the factor, relative; of one sign in all regimes of a source
};

/// What a regime has of the expected number of peaks above the load of a probability, 0-1.
struct YearShare {
    double value = 0;  ///< mean of the draws; those of all regimes add up to one
    Limits interval{};
    double exceeded_once_in = 0;  ///< s of this regime in which it has one such peak on average, by that mean
};

class YearLoad {
  public:
    /// `sources`: valid; each regime has one of them. They outlive this.
    YearLoad(std::span<const PosteriorLoad* const> sources, std::vector<YearRegime> regimes);

    /// The load that a year's largest exceeds with this probability, 0 < p < 1; NaN where a year has no ice to speak
    /// of.
    LoadFigure load(double probability) const;
    /// The share of each regime in that load, over the draws.
    std::vector<YearShare> shares(double probability) const;
    /// The part of the variance of the logarithm of that load that would go if the source were known: Sobol's
    /// first-order index (explained_variance.hpp), of each source.
    std::vector<double> uncertainty(double probability) const;

    /// Probability that a year's largest load exceeds x, of each draw.
    std::vector<double> exceeded(double x) const;

  private:
    /// For a source: one of its tails, and how far its factors are off in their standard uncertainties.
    struct Choice {
        const UnlikeTail* tail;
        double off;
    };
    using Year = std::vector<Choice>;  ///< one a source

    std::vector<Year> draw(std::size_t count, std::uint32_t number) const;
    /// Expected number of peaks above x in a year, of one regime.
    double expected_above(std::size_t regime, const Year& year, double x) const;
    double expected_above(const Year& year, double x) const;
    double load_of(const Year& year, double probability) const;
    std::vector<double> loads(double probability) const;

    std::vector<const PosteriorLoad*> sources_;
    std::vector<YearRegime> regimes_;
    std::vector<Year> years_;
};

}  // namespace floes
