#pragma once
// The model's own uncertainty: what its unknowns do to the load, varied one at a time about run.base_case, beside what
// sampling leaves open.

#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "findings/load_columns.hpp"

namespace floes {

/// What one case changes of one load, less the base case; NaN where unknown.
struct LoadChange {
    double estimate = 0;
    Limits interval{};          ///< 95 %
    double standard_error = 0;  ///< NaN where unknown
    bool paired = true;         ///< over common arrangements; otherwise by Welch's t
};

struct VariationRow {
    std::size_t of_case = 0;
    std::string input;                ///< paths of the keys that differ: variations of one input share it
    std::vector<LoadChange> changes;  ///< by load column
};

/// One load column over all inputs.
struct WidthRow {
    double base = 0;
    double sampling = 0;  ///< half of the 95 % interval of the base case's mean
    double down = 0;      ///< all inputs together, at most 0
    double up = 0;        ///< at least 0
};

struct ModelWidth {
    std::size_t base = 0;
    std::vector<LoadColumn> loads;
    std::vector<VariationRow> variations;  ///< those that moved the mean load most come first
    std::vector<WidthRow> widths;          ///< by load column
    std::size_t inputs = 0;
};

/// None where the campaign has no base case, or not two members each of it and of another case.
///
/// Down and up: root of the sum over inputs of the squared largest change that way, less the squared standard errors of
/// these changes, which chance alone would add. As if inputs were independent and their ends equally likely (ISO/IEC
/// Guide 98-3:2008, 5.1.2).
std::optional<ModelWidth> find_model_width(const Evidence& evidence);

/// The base case's loads, what the first `most` variations change, and what all inputs do together.
Table variations_table(const Summary& summary, const ModelWidth& width, std::size_t most);

/// One sentence on the mean load; empty without a width.
std::string width_sentence(const std::optional<ModelWidth>& width);

Section model_section(Evidence& evidence);

}  // namespace floes
