#pragma once
// Means over members, each with the interval that fits its values, and the columns that show them.

#include <string>
#include <vector>

#include "campaign_file/sample.hpp"
#include "inference/interval.hpp"
#include "member/quantity.hpp"
#include "tables/results.hpp"

namespace floes {

/// Fewest arrangements whose interval is printed: of two, Student's t makes it 13 standard errors wide on either side.
inline constexpr int fewest_for_interval = 3;

/// What values can be, which decides their interval and whether it says something.
struct Kind {
    double least = no_least;
    double most = no_most;
    bool positive = false;  ///< above 0 in any run: the range of one further run is taken on a logarithmic scale
    bool load = false;      ///< members may be of two kinds, as where ice jams in some: the interval of a mixture
};

/// The kind of a quantity of members.
Kind kind_of(const Quantity& quantity);

/// The mean of the finite ones among the values with the interval of their kind: Student's t or a mixture's, cut to the
/// range that values can have.
Interval mean_over(std::vector<double> values, const Kind& kind = {});
/// The mean of a quantity over members.
Interval mean_over(const Sample& sample, const Members& members, const Quantity& quantity);

/// Whether the 95 % limits of an estimate over `runs` arrangements say something: at least three runs, which differ,
/// and limits no further apart than four times the estimate, or than what values of the kind can have.
bool says_something(double estimate, Limits limits, int runs, const Kind& kind = {});

/// As one cell of a table.
Estimate estimate(const Interval& found, int runs, const Kind& kind = {});
/// The mean of a quantity over members as one cell.
Estimate over(const Sample& sample, const Members& members, const Quantity& quantity);
/// The mean of the finite ones among the values as one cell.
Estimate over(std::vector<double> values, const Kind& kind = {});

/// Its column: key, words and unit as the quantity has them.
ResultColumn column_of(const Quantity& quantity, ResultColumn::Holds holds = ResultColumn::Holds::estimates);
/// Its unit as Units takes it: "share" of a ratio.
std::string unit_of(const Quantity& quantity);

/// "+5.4 N (+2.1 to +8.7)": a change of a load in a sentence.
std::string change_text(const Estimate& change, const Units& units);

/// A column of values with their intervals.
ResultColumn estimates(std::string key, std::string words, std::string unit = "1");

}  // namespace floes
