#pragma once
// Segment maxima of each case, averaged over the time of the headlines: fits, return levels, exceedance; and how long
// loads exceed given levels.

#include <cstddef>
#include <vector>

#include "findings/summary.hpp"
#include "inference/extremes.hpp"

namespace floes {

/// Extremes of one case, from the segment maxima of all its done members.
struct CaseExtremes {
    std::size_t case_index = 0;
    double averaging = 0;  ///< time that the maxima are averaged over, s; 0: of single steps
    double segment = 0;    ///< length of a segment, s
    std::size_t maxima = 0;
    FittedExtreme gumbel;
    FittedExtreme gev;
    std::vector<ExceedancePoint> exceedance;
};

/// All cases in file order; fits are invalid with fewer than `fewest_maxima` maxima.
std::vector<CaseExtremes> find_extremes(const Sample& sample);

Section extremes_section(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// The empirical exceedance curve of the maxima with both fits: a CSV of its own, in JSON a part of the extremes. It
/// has no table, which would be too long to read.
Section exceedance_section(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// "Gumbel" or "GEV".
const char* name_of(ExtremeKind kind);

/// One level in one case.
struct LevelRow {
    std::size_t case_index = 0;
    double level = 0;        ///< N
    int runs = 0;            ///< done members that counted it
    Interval time_above{};   ///< share of the window's time steps with a surge load above it, 0-1
    Interval upcrossings{};  ///< upward crossings of the level, 1/s
};

/// Every level of every case with a done member that counted it, cases in file order, levels ascending.
std::vector<LevelRow> find_levels(const Sample& sample);

Section levels_section(const Summary& summary, const std::vector<LevelRow>& rows);

}  // namespace floes
