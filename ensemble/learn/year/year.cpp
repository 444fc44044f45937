#include "year/year.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "year/year_tails.hpp"

namespace floes {
namespace {

constexpr double counts_from = 0.1;  // of the peaks: a regime that has them decides the load

/// Of the curve: nine in ten years, then two to a power of ten, down to the rarest asked for.
std::vector<double> curve_probabilities(const std::vector<double>& asked) {
    std::vector<double> made{0.9, 0.63, 0.3};
    const double rarest = std::ranges::min(asked);
    for (double p = 0.1; p > rarest * 0.99; p /= std::sqrt(10.0)) made.push_back(p);
    return made;
}

YearLevel level_of(const YearLoad& load, double per_year, const YearTails& tails) {
    YearLevel level{per_year, load.load(per_year), {}, {}, 0};
    if (!std::isfinite(level.load.value)) return level;
    level.shares = load.shares(per_year);
    level.uncertainty = load.uncertainty(per_year);
    for (std::size_t k = 0; k < tails.regimes.size(); ++k)
        if (level.shares[k].value >= counts_from)
            level.beyond_run = std::max(level.beyond_run, level.shares[k].exceeded_once_in /
                                                              tails.sources[tails.regimes[k].tail.source].time_run);
    return level;
}

}  // namespace

Year find_year(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request) {
    YearTails tails = year_tails(campaign, regimes, request);
    std::vector<const PosteriorLoad*> posteriors;
    for (const auto& one : tails.posteriors) posteriors.push_back(one.get());
    std::vector<YearRegime> parts;
    for (const YearRegimeRow& row : tails.regimes) parts.push_back(row.tail);
    const YearLoad load(posteriors, parts);
    Year year;
    for (const double per_year : request.per_year) year.levels.push_back(level_of(load, per_year, tails));
    std::vector<YearLoad> alone;
    for (const YearRegime& part : parts)
        alone.push_back(YearLoad({&posteriors[part.source], 1}, {{0, part.time, part.factor, part.factor_sd}}));
    for (const double per_year : curve_probabilities(request.per_year)) {
        YearCurvePoint& point = year.curve.emplace_back(YearCurvePoint{per_year, load.load(per_year), {}});
        for (const YearLoad& one : alone) point.alone.push_back(one.load(per_year).value);
    }
    year.sources = std::move(tails.sources);
    year.regimes = std::move(tails.regimes);
    return year;
}

}  // namespace floes
