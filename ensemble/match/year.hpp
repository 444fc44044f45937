#pragma once
// Words of the loads of a year. For this module only.

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/units.hpp"
#include "findings/design_load.hpp"
#include "inference/posterior_load.hpp"
#include "inference/year_load.hpp"
#include "match/matching.hpp"
#include "match/regimes.hpp"
#include "match/waves.hpp"

namespace floes {

/// "10^-2", "0.005".
inline std::string per_year_text(double per_year) {
    const double exponent = std::log10(per_year);
    return std::abs(exponent - std::round(exponent)) < 1e-9 ? fmt::format("10^{:.0f}", exponent)
                                                            : fmt::format("{:g}", per_year);
}

/// In whole percent.
inline std::string percent_of(double share) {
    if (!std::isfinite(share)) return "–";
    return share > 0 && share < 0.005 ? "<1 %" : fmt::format("{:.0f} %", share / unit::percent);
}

// The loads of a year: which are exceeded with given probabilities a year, over all regimes of ice, what each regime
// has of that, and of which the answer is least certain.

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

// The tails that regimes have. For this module only.

struct YearTails {
    std::vector<TailSource> sources;
    std::vector<std::unique_ptr<const PosteriorLoad>> posteriors;  ///< one a source
    std::vector<YearRegimeRow> regimes;
};

/// Throws as find_year() does.
YearTails year_tails(const MatchWave& campaign, const std::vector<Regime>& regimes, const YearRequest& request);

// A design between its points: the emulated mean maximum at any place, and the runs of all points divided by it
// (match/predict_design_load.hpp). For this module only.

/// The [[case]] of the design that the regime means; "" where it has none. Throws InputError where the campaign has no
/// design, or several cases of which the regime names none.
std::string design_case(const MatchWave& campaign, const Regime& regime);

class InterpolatedDesign {
  public:
    /// Throws InputError as match_data() and averaging_time() do, and where the emulator fails its check.
    InterpolatedDesign(const MatchWave& campaign, const std::string& base, const DesignLoadRequest& request);

    const std::vector<PeakRow>& rows() const { return rows_; }  ///< divided by the mean maximum at their points
    const Measured& measured() const { return measured_; }
    const std::vector<int>& members() const { return members_; }
    std::size_t fewest_arrangements() const { return fewest_; }  ///< of a point

    /// The mean maximum there, N, with the variance of the emulator and of what all points share. Throws InputError for
    /// an axis without a value, a value of no axis, and one outside of the axis's range.
    Emulated at(const Regime& regime) const;

  private:
    MatchData data_;
    std::vector<EmulatedTarget> index_;  ///< one
    std::vector<PeakRow> rows_;
    Measured measured_;
    std::vector<int> members_;
    std::size_t fewest_ = 0;
};

}  // namespace floes
