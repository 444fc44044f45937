#pragma once
// The few figures that everybody asks for first: mean load, largest load over 1 s, broken floes. The same columns in
// every table that has room for only these.

#include <string>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

struct LoadColumn {
    Quantity quantity{};
    std::string words;  ///< "mean load"
    std::string unit;   ///< "N"
    double factor = 1;  ///< displayed value / stored value
    int decimals = 0;

    /// "mean load, N"
    std::string heading() const { return words + ", " + unit; }
    /// "23.4 ± 6.2"; "0.0 in all" where all runs gave the same; "23.4 ± –" where the interval says nothing otherwise;
    /// "–" without a result.
    std::string cell(const CaseSummary& row) const;
};

/// Mean load, largest load and broken floes, in the units that suit them.
std::vector<LoadColumn> load_columns(const Summary& summary);

/// The mean of the segments' maxima of the load averaged over 1 s; over the longest time that the members took unless
/// they took that; of single steps where they averaged nothing.
Quantity largest_load(const Summary& summary);

/// "largest over 1 s", "largest of a step"
std::string largest_words(const Quantity& largest);

/// What no interval has: kinds of member that none of the fewest arrangements of a case shows; `in_full`: and what they
/// would add. A sentence behind a blank, or nothing.
std::string unseen_text(const Summary& summary, bool in_full);

/// What the columns mean, as sentences.
std::string load_columns_text(const Summary& summary);

/// Decimals that give about three digits.
int few_decimals(double largest);

}  // namespace floes
