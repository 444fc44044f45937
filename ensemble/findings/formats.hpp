#pragma once
// A summary as text: a table for people, JSON and CSV for programs. The same figures in all three.

#include <cstddef>
#include <optional>
#include <string>

#include "findings/summary.hpp"

namespace floes {

/// Index of the case that the others are compared with, as Table 3 does; none: no comparison.
using Reference = std::optional<std::size_t>;

/// For people: the conditions, the counts, every quantity with its intervals, failures by mode, what was set aside. One
/// column a case, as many side by side as `width` characters hold and the others below. Ends in a newline.
std::string summary_table(const Summary& summary, int width, Reference reference = {});

/// For programs: {"cases": [{"name", "cfm", "elastic_modulus_MPa", "members", …}]}; null where undefined. Ends in a
/// newline.
std::string summary_json(const Summary& summary, Reference reference = {});

/// A header line and one line a case; an interval takes the columns NAME, NAME_low, NAME_high, NAME_bca_low,
/// NAME_bca_high, NAME_prediction_low, NAME_prediction_high; empty where undefined.
std::string summary_csv(const Summary& summary, Reference reference = {});

}  // namespace floes
