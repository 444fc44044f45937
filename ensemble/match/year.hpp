#pragma once
// The loads of a year, found and told.

#include <optional>
#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "findings/evidence.hpp"
#include "inference/posterior_load.hpp"
#include "match/matching.hpp"
#include "match/regimes.hpp"
#include "match/waves.hpp"
#include "tables/section.hpp"
#include "tables/units.hpp"

namespace floes {

/// "10^-2", "0.005".
std::string per_year_text(double per_year);

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
    const char* interpolation = "";  ///< of a design: the form of what is between its points; empty of a case
    std::string simpler = {};        ///< Emulator::simpler() of that

    /// "case thin", "the design", "the design's case E60".
    std::string words() const;
};

struct YearRegimeRow {
    Regime regime;
    YearRegime tail;  ///< time at the scale of the campaign; its source is one of Year::sources
};

struct YearLevel {
    double per_year = 0;
    LoadFigure load;                  ///< N, at the scale of the campaign
    std::vector<YearShare> shares;    ///< one a regime
    std::vector<double> uncertainty;  ///< one a source: YearLoad::uncertainty()
    /// The longest time that a regime with a tenth of the load's peaks or more would have to last for one of them, over
    /// the time run of its source.
    double beyond_run = 0;
};

struct YearCurvePoint {
    double per_year = 0;
    LoadFigure all;
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

// The loads of a year for people and programs.

/// That suit these loads at full scale.
Units year_units(const Year& year, const YearRequest& request);

/// Loads with their intervals; regimes and what each has of the loads; what the answer rests on; a figure. For programs
/// year/loads, year/regimes, year/sources and year/curve.
std::vector<Section> year_sections(const Evidence& evidence, const Year& year, const YearRequest& request);

/// Whether a load that was asked for is known: where its interval says nothing, people and programs get none.
bool says_some_load(const Year& year);

/// The exceedance curve with its interval, and that of each regime alone, as far as it is known; none where it is not.
std::optional<Figure> year_figure(const Year& year, const YearRequest& request);

/// The source of which the rarest load is least certain, and the command that runs as many members again; `program` as
/// the user typed it, `file` as it is typed, empty where there is not one. Without a title.
Section year_next(const Evidence& evidence, const Year& year, const std::string& program, const std::string& file);

}  // namespace floes
