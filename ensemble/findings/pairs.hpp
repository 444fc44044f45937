#pragma once
// Cases compared in pairs, arrangement by arrangement. Only cases of the same field geometry meet the same floes, so
// only those are paired.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "inference/paired.hpp"

namespace floes {

/// One quantity of one pair of cases, over the arrangements that both have done.
struct PairRow {
    Quantity quantity{};
    std::size_t first = 0;  ///< index of the case that the other is compared with
    std::size_t second = 0;
    PairedComparison found{};     ///< second - first
    std::vector<int> apart = {};  ///< arrangements whose difference is far from the others'
    double first_mean = 0;        ///< over the same arrangements
    double t_p_holm = 0;          ///< Holm over all pairs of this quantity
    double wilcoxon_p_holm = 0;
    int to_resolve_observed = 0;  ///< arrangements needed in total to find a true difference this large; 0: unknown
    int to_resolve_wished = 0;    ///< the same for a difference of `resolve` x first_mean

    /// The difference as one cell; limits from two arrangements say nothing.
    Estimate difference() const;
};

struct PairOptions {
    std::optional<std::size_t> reference;  ///< comes first in its pairs
    bool others = true;                    ///< pairs without the reference, too
    double resolve = 0.1;                  ///< difference to be resolved, as a fraction of the first case's mean
};

/// Every pair of cases, or those with the reference, that share at least two done arrangements, for each quantity of
/// Table 3 and of the averaged load in order; pairs in file order.
std::vector<PairRow> compare_pairs(const Evidence& evidence, const PairOptions& options = {});

/// One quantity of each of the first `most` cases less that of `reference`, in file order; p is of each pair alone.
/// Cases that share fewer than two done arrangements with it are left out.
std::vector<PairRow> compare_with(const Evidence& evidence, std::size_t reference, const Quantity& quantity,
                                  std::size_t most);

/// A case less the reference where they begin from other floes, so that only their means can be compared.
struct ApartRow {
    std::size_t second = 0;
    MeanDifference found{};
    int fewest = 0;  ///< values of the case with fewer

    Estimate difference() const;
};

/// One quantity of each of the first `most` cases that share no done arrangement with `reference`, in file order. Cases
/// without a value are left out.
std::vector<ApartRow> compare_apart(const Evidence& evidence, std::size_t reference, const Quantity& quantity,
                                    std::size_t most);

/// A sentence on the pairs that could not be compared; empty when there are none.
std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options = {});

/// What a campaign of many cases shows instead of its pairs and extremes: how many pairs, and the command that shows
/// them.
std::string unasked_text(const Summary& summary);

/// The table has the headline quantities; a page and the records have all.
Section pairs_section(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options);

// The model's own uncertainty: what its unknowns do to the load, varied one at a time about run.base_case, beside what
// sampling leaves open.

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
