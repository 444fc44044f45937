#pragma once
// Cases compared in pairs, arrangement by arrangement. Only cases of the same field geometry meet the same floes, so
// only those are paired.

#include <cstddef>
#include <optional>
#include <span>
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
    double power = 0.8;                    ///< probability of finding it at the 5 % level
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

/// A value with its interval on a line of its own.
struct Strip {
    std::string label;
    Estimate value;
};

/// Strips below each other, the first at the top, with a line at 0. `words` and `unit`: of the axis.
Figure strips_figure(std::span<const Strip> strips, const std::string& words, const std::string& unit);

}  // namespace floes
