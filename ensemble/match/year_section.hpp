#pragma once
// The loads of a year for people and programs.

#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "match/year.hpp"
#include "tables/section.hpp"
#include "tables/units.hpp"

namespace floes {

/// How far beyond the time run the intervals were tried (docs/year.md); farther, the output says so.
inline constexpr double tried_beyond = 1e7;

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
/// the user typed it. Without a title.
Section year_next(const Evidence& evidence, const Year& year, const std::string& program);

}  // namespace floes
