#pragma once
// The largest load in a year of several regimes, each with hours and a tail of its own. It stays below x with
// probability
//   exp(-Σ T_i λ_i(x))
// for members that are alike, with λ_i(x) the rate of peaks above x of regime i and T_i its time in a year; of members
// that differ, exp(-T λ) is (mean over their scales of exp(-w λ))^(T/w), as in member_tails.hpp. Regimes follow one
// another and a year has many passages through each, so what one brings says nothing of the others.
//
// What is not known are the tails: each source (a case, or a design that is interpolated) has its posterior draws.
// Sources are independent, so a draw of the year takes one of each.

#include <cstddef>
#include <span>
#include <vector>

#include "inference/posterior_load.hpp"

namespace floes {

/// The tail of a regime: that of a source, times a factor.
struct YearRegime {
    std::size_t source = 0;
    double time = 0;       ///< s in a year
    double factor = 1;     ///< of the source's loads
    double factor_sd = 0;  ///< standard uncertainty of the factor, relative; of one sign in all regimes of a source
};

struct YearFigure {
    double value = 0;  ///< median of the draws, N; NaN where a year has no ice to speak of
    Limits interval{};
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

    /// The load that a year's largest exceeds with this probability, 0 < p < 1.
    YearFigure load(double probability) const;
    /// The share of each regime in that load, over the draws.
    std::vector<YearShare> shares(double probability) const;
    /// The part of the variance of the logarithm of that load that would go if the source were known: Sobol's
    /// first-order index (sobol_indices.hpp), of each source.
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
