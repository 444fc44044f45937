// Wilcoxon's signed-rank test: exact by counting all signs for few differences, otherwise by the normal distribution.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "inference/paired.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr std::size_t most_for_exact = 50;

/// Twice the rank of each magnitude, ties sharing the mean of theirs: whole numbers.
std::vector<int> doubled_ranks(std::span<const double> differences) {
    std::vector<std::size_t> order(differences.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto magnitude = [&](std::size_t index) { return std::abs(differences[index]); };
    std::ranges::stable_sort(order, {}, magnitude);
    std::vector<int> ranks(differences.size());
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        while (end < order.size() && magnitude(order[end]) == magnitude(order[begin])) ++end;
        for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = static_cast<int>(begin + 1 + end);
        begin = end;
    }
    return ranks;
}

/// P(sum of the ranks of positive differences <= smaller) if both signs are equally likely. Counts are exact up to
/// 2^53; above that only rounding is lost.
double tail_by_counting(const std::vector<int>& ranks, std::int64_t smaller) {
    std::vector<double> chance(static_cast<std::size_t>(smaller) + 1, 0.0);
    chance[0] = 1;
    for (const int rank : ranks) {
        const auto step = static_cast<std::size_t>(rank);
        for (std::size_t sum = chance.size(); sum-- > 0;) {
            chance[sum] = 0.5 * (chance[sum] + (sum >= step ? chance[sum - step] : 0.0));
        }
    }
    return std::accumulate(chance.begin(), chance.end(), 0.0);
}

}  // namespace

SignedRank wilcoxon_signed_rank(std::span<const double> differences) {
    std::vector<double> moved(differences.begin(), differences.end());
    std::erase(moved, 0.0);
    if (moved.empty()) {
        const double undefined = std::numeric_limits<double>::quiet_NaN();
        return {undefined, undefined, true};
    }
    const std::vector<int> ranks = doubled_ranks(moved);
    std::int64_t positive = 0;
    double squares = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (moved[i] > 0) positive += ranks[i];
        squares += 0.25 * ranks[i] * static_cast<double>(ranks[i]);
    }
    const std::int64_t all = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
    const std::int64_t smaller = std::min(positive, all - positive);
    const double rank_sum = 0.5 * static_cast<double>(smaller);
    if (moved.size() <= most_for_exact) {
        return {rank_sum, std::min(1.0, 2 * tail_by_counting(ranks, smaller)), true};
    }
    const double z =
        (rank_sum - 0.25 * static_cast<double>(all)) / std::sqrt(0.25 * squares);  // mean and variance given the ranks
    return {rank_sum, 2 * normal_below(-std::abs(z)), false};
}

}  // namespace floes
