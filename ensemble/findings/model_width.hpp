#pragma once
// The model's own uncertainty: what its unknowns do to the load, varied one at a time about run.base_case, beside what
// sampling leaves open.

#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// What one case changes of one load, less the base case; NaN where unknown.
struct LoadChange {
    Estimate change;
    double standard_error = 0;  ///< NaN where unknown
    bool paired = true;         ///< over common arrangements; otherwise by Welch's t
};

struct VariationRow {
    std::size_t of_case = 0;
    std::string input;                ///< keys that differ, but for a step that follows; its variations share it
    std::vector<LoadChange> changes;  ///< by load
};

/// One load over all inputs.
struct WidthRow {
    Quantity quantity{};
    std::string words;    ///< "mean load"
    double base = 0;      ///< the base case's mean
    double sampling = 0;  ///< half of its 95 % interval
    double down = 0;      ///< all inputs together, at most 0
    double up = 0;        ///< at least 0
};

struct ModelWidth {
    std::size_t base = 0;
    std::vector<VariationRow> variations;  ///< those that moved the mean load most come first
    std::vector<WidthRow> widths;          ///< by load
    std::size_t inputs = 0;
};

/// None where the campaign has no base case, or not two members each of it and of another case.
///
/// Down and up: root of the sum over inputs of the squared largest change that way, less the squared standard errors of
/// these changes, which chance alone would add. As if inputs were independent and their ends equally likely (ISO/IEC
/// Guide 98-3:2008, 5.1.2).
std::optional<ModelWidth> find_model_width(const Evidence& evidence);

/// For people: the base case's loads, what the first `most` variations change, and what all inputs do together.
Results variations_table(const Summary& summary, const ModelWidth& width, std::size_t most);

/// One sentence on the mean load; empty without a width.
std::string width_sentence(const std::optional<ModelWidth>& width, const Units& units);

Section model_section(Evidence& evidence);

}  // namespace floes
