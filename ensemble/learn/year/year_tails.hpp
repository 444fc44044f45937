#pragma once
// The tails that regimes have. For this room only.

#include <memory>
#include <vector>

#include "inference/posterior_load.hpp"
#include "year/year.hpp"

namespace floes {

struct YearTails {
    std::vector<TailSource> sources;
    std::vector<std::unique_ptr<const PosteriorLoad>> posteriors;  ///< one a source
    std::vector<YearRegimeRow> regimes;
};

/// Throws as find_year() does.
YearTails year_tails(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request);

}  // namespace floes
