#pragma once
// The loads of a year: which are exceeded with given probabilities a year, over all regimes of ice, what each regime
// has of that, and of which the answer is least certain.

#include <optional>
#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "inference/year_load.hpp"
#include "match/waves.hpp"
#include "year/regimes.hpp"

namespace floes {

/// What is asked for, at full scale.
struct YearRequest {
    /// Averaging time, scale, share of the peaks, and whether loads that rise are taken as they are; exposure and
    /// quantiles are not used.
    DesignLoadRequest load;
    /// Each in (0, 1), falling: ISO 19906 has 10^-2 for its extreme level and 10^-4 for its abnormal level.
    std::vector<double> per_year{1e-2, 1e-4};
};

/// What the tails of regimes come from: a case, or a design whose points are interpolated.
struct TailSource {
    std::string name;                    ///< of the case; of a design its [[case]], which may be empty
    std::optional<std::size_t> of_case;  ///< none: interpolated
    std::vector<int> members;            ///< with a result
    std::size_t arrangements = 0;        ///< of the case; of a design of the point with the fewest
    double time_run = 0;                 ///< s, at the scale of the campaign
    UnlikeMembers unlike;

    /// "case thin", "the design", "the design's case E60".
    std::string words() const;
};

struct YearRegimeRow {
    Regime regime;
    YearRegime tail;  ///< time at the scale of the campaign; its source is one of Year::sources
};

struct YearLevel {
    double per_year = 0;
    YearFigure load;                  ///< N, at the scale of the campaign
    std::vector<YearShare> shares;    ///< one a regime
    std::vector<double> uncertainty;  ///< one a source: YearLoad::uncertainty()
    /// The longest time that a regime with a tenth of the load's peaks or more would have to last for one of them, over
    /// the time run of its source.
    double beyond_run = 0;
};

struct YearCurvePoint {
    double per_year = 0;
    YearFigure all;
    std::vector<double> alone;  ///< of each regime as if there were no other; NaN where it is not exceeded so often
};

struct Year {
    std::vector<TailSource> sources;
    std::vector<YearRegimeRow> regimes;
    std::vector<YearLevel> levels;      ///< as asked for
    std::vector<YearCurvePoint> curve;  ///< per_year falling
};

/// Throws InputError, one sentence, where a regime has no case or lies outside of the design's ranges, where a source
/// has too few members or peaks or a load that rises, and as averaging_time() and match_axes() do.
Year find_year(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request);

}  // namespace floes
