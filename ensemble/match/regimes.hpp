#pragma once
// The regimes of a year: which ice comes by, for how many hours.

#include <string>
#include <string_view>
#include <vector>

#include "keys/document.hpp"

namespace floes {

struct Regime {
    std::string name;
    double time = 0;            ///< s in a year, above 0, at full scale
    std::string case_name;      ///< of the campaign; of a design, with values, its [[case]]; may be empty then
    std::vector<Entry> values;  ///< of a design's axes: path and number; empty: it is the case itself
    std::string where;          ///< "year.toml:12"
};

/// Hours of a year with its share of a leap day. Hours are taken as they stand: of regimes that fill a year of 365
/// days, or a leap year, the loads are those of that year.
inline constexpr double year_hours = 8766;
inline constexpr double leap_year_hours = 8784;
inline constexpr double rounding_of_hours = 1e-9;  ///< relative, of a sum of regimes

/// Reads the [[regime]] tables of a TOML text; `file` names it in messages.
///
///     [[regime]]
///     name = "thin, slow"
///     hours_per_year = 300
///     case = "thin"                # a case of the campaign file; or, where it has a design, values of its axes:
///     ice.thickness_m = 0.5
///
/// Regimes of 0 hours are left out. Throws InputError, one sentence, for other keys (naming the nearest), a regime
/// without hours, or with neither case nor values, two regimes of one name or one place, more hours than a leap year
/// has, and a text without regimes.
std::vector<Regime> read_regimes(std::string_view text, const std::string& file);

/// The same of a scatter diagram, CSV (RFC 4180): a header line with the columns hours_per_year, and case or axes, and
/// perhaps regime (the name; otherwise made of the others); then a line for each regime. Empty cells are not given.
std::vector<Regime> read_regime_table(std::string_view text, const std::string& file);

}  // namespace floes
