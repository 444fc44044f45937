#include "inference/unlike_members.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "inference/bootstrap.hpp"
#include "inference/interval.hpp"
#include "statistics/distributions.hpp"

namespace floes {
namespace {

constexpr double level = 0.01;   // of all tests whether any member stands out
constexpr double chance = 0.05;  // that a kind of member is not seen

/// Mean logarithm of the highest third; 0 and below count as nothing.
double height_of(std::span<const double> falling) {
    const std::size_t third = std::min(falling.size(), std::max<std::size_t>(3, (falling.size() + 2) / 3));
    double sum = 0;
    for (std::size_t k = 0; k < third; ++k) sum += std::log(std::max(falling[k], 1e-12));
    return sum / static_cast<double>(third);
}

struct Height {
    double value;
    std::size_t row;
};

enum class Tails { upper, both };

/// Of falling values, how far the highest, or the farthest, is from the mean of all, in their SD: Rosner's R.
struct Departure {
    double value;
    bool highest;  ///< else the lowest
};
Departure departure(std::span<const Height> falling, Tails tails) {
    const double count = static_cast<double>(falling.size());
    double mean = 0, squares = 0;
    for (const Height& one : falling) mean += one.value / count;
    for (const Height& one : falling) squares += (one.value - mean) * (one.value - mean);
    const double sd = std::sqrt(squares / (count - 1));
    const double up = falling.front().value - mean, down = mean - falling.back().value;
    const bool highest = tails == Tails::upper || up >= down;
    return {sd > 0 ? (highest ? up : down) / sd : 0, highest};
}

/// What the departure of the highest, or farthest, of `count` normal values is below with 99 %.
double usual_departure(double count, Tails tails) {
    const double t = student_t(count - 2, level / (tails == Tails::both ? 2 * count : count));
    return (count - 1) * t / std::sqrt((count - 2 + t * t) * count);
}

/// Of heights in any order.
std::vector<std::size_t> standing_out(std::vector<Height> heights, Tails tails = Tails::upper) {
    std::ranges::stable_sort(heights, [](const Height& a, const Height& b) { return a.value > b.value; });
    if (heights.size() < fewest_to_stand_out) return {};
    std::span<const Height> left = heights;
    std::vector<std::size_t> rows;  // in the order in which they are taken away
    std::size_t count = 0;
    const std::size_t most = heights.size() / 4;
    const double least = usual_departure(static_cast<double>(heights.size() - most), tails);  // it grows with the count
    for (std::size_t k = 0; k < most; ++k) {
        const Departure found = departure(left, tails);
        rows.push_back((found.highest ? left.front() : left.back()).row);
        if (found.value > least && found.value > usual_departure(static_cast<double>(left.size()), tails))
            count = k + 1;
        left = found.highest ? left.subspan(1) : left.first(left.size() - 1);
    }
    rows.resize(count);
    std::ranges::sort(rows);
    return rows;
}

std::vector<Height> heights_of(std::span<const double> values) {
    std::vector<Height> heights;
    for (std::size_t row = 0; row < values.size(); ++row) heights.push_back({values[row], row});
    return heights;
}

/// The highest peaks of all that are those of these rows.
std::size_t carried_by(MemberPeakSpans peaks, const std::vector<std::size_t>& rows) {
    double highest_other = -1;
    for (std::size_t row = 0; row < peaks.size(); ++row)
        if (!peaks[row].empty() && !std::ranges::binary_search(rows, row))
            highest_other = std::max(highest_other, peaks[row].front());
    std::size_t count = 0;
    for (const std::size_t row : rows)
        count += static_cast<std::size_t>(
            std::ranges::count_if(peaks[row], [&](double peak) { return peak > highest_other; }));
    return count;
}

}  // namespace

UnlikeMembers unlike_members(MemberPeakSpans peaks, double share) {
    UnlikeMembers found;
    std::vector<Height> heights;
    for (std::size_t row = 0; row < peaks.size(); ++row)
        if (!peaks[row].empty()) heights.push_back({height_of(peaks[row]), row});
    found.out = standing_out(std::move(heights));
    if (!found.out.empty()) found.carried = carried_by(peaks, found.out);
    std::vector<double> all;
    for (std::size_t row = 0; row < peaks.size(); ++row)
        if (!std::ranges::binary_search(found.out, row)) all.insert(all.end(), peaks[row].begin(), peaks[row].end());
    const double members = static_cast<double>(peaks.size() - found.out.size());
    if (all.empty() || members < 2) return found;
    std::ranges::sort(all);
    const double threshold = quantile_of_sorted(all, 1 - share);
    double sum = 0, squares = 0;
    for (std::size_t row = 0; row < peaks.size(); ++row) {
        if (std::ranges::binary_search(found.out, row)) continue;
        const auto count =
            static_cast<double>(std::ranges::count_if(peaks[row], [&](double peak) { return peak > threshold; }));
        sum += count;
        squares += count * count;
    }
    if (sum == 0) return found;
    const double mean = sum / members;
    found.dispersion = (squares / members - mean * mean) * members / (members - 1) / mean;
    found.dispersion_p = chi_squared_above(std::max(0.0, (members - 1) * found.dispersion), members - 1);
    return found;
}

std::vector<std::size_t> rows_standing_out(std::span<const double> values) {
    return standing_out(heights_of(values));
}

std::vector<std::size_t> rows_standing_apart(std::span<const double> values) {
    return standing_out(heights_of(values), Tails::both);
}

double unseen_share(std::size_t members) {
    return 1 - std::pow(chance, 1 / static_cast<double>(std::max<std::size_t>(members, 1)));
}

int members_to_see(double share) {
    return std::max(1, static_cast<int>(std::ceil(std::log(chance) / std::log1p(-share))));
}

}  // namespace floes
