#include "inference/interval.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <boost/random/gamma_distribution.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

constexpr Limits no_limits{undefined, undefined};

std::vector<double> logarithms(std::span<const double> values) {
    std::vector<double> logs;
    for (const double value : values) logs.push_back(std::log(value));
    return logs;
}

}  // namespace

Interval mean_interval(std::span<const double> values) {
    for (const double value : values)
        if (!std::isfinite(value))
            throw InputError(
                fmt::format("A mean over {} members includes the value {}; leave out members without a result.",
                            values.size(), value));
    const double mean = mean_of(values);
    if (values.size() < 2) return {values.empty() ? undefined : mean, undefined, undefined, undefined, undefined};
    const double count = static_cast<double>(values.size());
    const double sd = std::sqrt(squares_about(values, mean) / (count - 1));
    const double t = student_t(count - 1, beyond_limit);
    const double of_mean = t * sd / std::sqrt(count);
    const double of_run = t * sd * std::sqrt(1 + 1 / count);
    return {mean, mean - of_mean, mean + of_mean, mean - of_run, mean + of_run};
}

Interval positive_interval(std::span<const double> values) {
    Interval interval = mean_interval(values);
    if (std::ranges::any_of(values, [](double value) { return value <= 0; })) return interval;
    const Interval logarithmic = mean_interval(logarithms(values));
    interval.prediction_low = std::exp(logarithmic.prediction_low);
    interval.prediction_high = std::exp(logarithmic.prediction_high);
    return interval;
}

Interval clipped(const Interval& interval, double least, double most) {
    const auto cut = [&](double value) { return std::clamp(value, least, most); };  // NaN stays NaN
    return {cut(interval.estimate), cut(interval.low), cut(interval.high), cut(interval.prediction_low),
            cut(interval.prediction_high)};
}

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

/// For falling values, how far the highest, or the farthest, is from the mean of all, in their SD: Rosner's R.
struct Departure {
    double value;
    bool highest;  ///< else the lowest
};
Departure departure(std::span<const Height> falling, Sides sides) {
    const double count = static_cast<double>(falling.size());
    double mean = 0, squares = 0;
    for (const Height& one : falling) mean += one.value / count;
    for (const Height& one : falling) squares += (one.value - mean) * (one.value - mean);
    const double sd = std::sqrt(squares / (count - 1));
    const double up = falling.front().value - mean, down = mean - falling.back().value;
    const bool highest = sides == Sides::above || up >= down;
    return {sd > 0 ? (highest ? up : down) / sd : 0, highest};
}

/// What the departure of the highest, or farthest, of `count` normal values is below with 99 %.
double usual_departure(double count, Sides sides) {
    const double t = student_t(count - 2, level / (sides == Sides::both ? 2 * count : count));
    return (count - 1) * t / std::sqrt((count - 2 + t * t) * count);
}

/// For heights in any order.
std::vector<std::size_t> standing_out(std::vector<Height> heights, Sides sides) {
    std::ranges::stable_sort(heights, [](const Height& a, const Height& b) { return a.value > b.value; });
    if (heights.size() < fewest_to_stand_out) return {};
    std::span<const Height> left = heights;
    std::vector<std::size_t> rows;  // in the order in which they are taken away
    std::size_t count = 0;
    const std::size_t most = heights.size() / 4;
    const double least = usual_departure(static_cast<double>(heights.size() - most), sides);  // it grows with the count
    for (std::size_t k = 0; k < most; ++k) {
        const Departure found = departure(left, sides);
        rows.push_back((found.highest ? left.front() : left.back()).row);
        if (found.value > least && found.value > usual_departure(static_cast<double>(left.size()), sides))
            count = k + 1;
        left = found.highest ? left.subspan(1) : left.first(left.size() - 1);
    }
    rows.resize(count);
    std::ranges::sort(rows);
    return rows;
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
    found.out = standing_out(std::move(heights), Sides::above);
    if (!found.out.empty()) found.carried = carried_by(peaks, found.out);
    const std::vector<double> all = pooled_peaks(peaks, found.out, false);
    const double members = static_cast<double>(peaks.size() - found.out.size());
    if (all.empty() || members < 2) return found;
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

std::vector<double> pooled_peaks(MemberPeakSpans peaks, std::span<const std::size_t> out, bool of_out) {
    std::vector<double> all;
    for (std::size_t row = 0; row < peaks.size(); ++row)
        if (std::ranges::binary_search(out, row) == of_out) all.insert(all.end(), peaks[row].begin(), peaks[row].end());
    std::ranges::sort(all);
    return all;
}

double unseen_share(std::size_t members) {
    return 1 - std::pow(chance, 1 / static_cast<double>(std::max<std::size_t>(members, 1)));
}

int members_to_see(double share) {
    FLOES_EXPECTS(share > 0 && share < 1);
    return std::max(1, static_cast<int>(std::ceil(std::log(chance) / std::log1p(-share))));
}

namespace {

constexpr int draws = 4000;
constexpr std::uint32_t own_draws = 0x6d6978;  // none that a bootstrap uses
constexpr double jeffreys = 0.5;
constexpr double usual_scatter = 0.3;  // of the logarithm, of members of a kind
constexpr double prior_members = 2;    // members
constexpr double largest_log = 50;     // of a distance that a draw may have, over those seen

/// A sample's mean, sample SD and size.
struct Moments {
    double mean = 0;
    double sd = 0;
    double count = 0;

    explicit Moments(std::span<const double> values)
        : mean(mean_of(values)), count(static_cast<double>(values.size())) {
        if (count > 1) sd = population_sd(values, mean) * std::sqrt(count / (count - 1));
    }
    double freedom() const { return std::max(1.0, count - 1); }
};

/// 32 random bits a call, as Boost's distributions take them.
class Bits {
  public:
    using result_type = std::uint32_t;
    explicit Bits(std::size_t number) : random_{0, own_draws, StreamId::bootstrap, number} {}
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return 0xffffffffu; }
    result_type operator()() { return static_cast<result_type>(random_.uniform() * 0x1p32); }

  private:
    RandomStream random_;
};

/// Draws of what is not known of the kinds.
class Draws {
  public:
    explicit Draws(std::size_t number) : bits_(number) {}

    double normal() { return normal_(bits_); }
    double gamma(double shape) { return boost::random::gamma_distribution<>{shape}(bits_); }
    double chi_squared(double freedom) { return 2 * gamma(freedom / 2); }
    double student(double freedom) {
        const double z = normal();
        return z / std::sqrt(chi_squared(freedom) / freedom);
    }
    double uniform() { return boost::random::uniform_01<>{}(bits_); }

  private:
    Bits bits_;
    boost::random::normal_distribution<> normal_;
};

}  // namespace

Apart apart(std::span<const double> values, Sides sides) {
    if (values.empty() || values.size() > most_tested) return {};
    if (sides == Sides::above && std::ranges::any_of(values, [](double value) { return !(value > 0); })) return {};
    std::vector<double> rising(values.begin(), values.end());
    std::ranges::sort(rising);
    const double middle = quantile_of_sorted(rising, 0.5);
    std::vector<Height> heights;
    for (std::size_t row = 0; row < values.size(); ++row)
        heights.push_back({sides == Sides::above ? std::log(values[row]) : values[row], row});
    Apart found;
    for (const std::size_t row : standing_out(std::move(heights), sides))
        (sides == Sides::above || values[row] > middle ? found.above : found.below).push_back(row);
    return found;
}

Interval mixed_interval(std::span<const double> values, const Interval& plain, const Apart& apart, Sides sides) {
    if (apart.count() == 0) return plain;
    std::vector<double> usual, distances;
    for (std::size_t row = 0; row < values.size(); ++row)
        if (!std::ranges::binary_search(apart.above, row) && !std::ranges::binary_search(apart.below, row))
            usual.push_back(values[row]);
    const Moments of_usual(usual);
    for (const std::vector<std::size_t>* side : {&apart.above, &apart.below})
        for (const std::size_t row : *side) distances.push_back(std::abs(values[row] - of_usual.mean));
    const Moments far(logarithms(distances));
    const double squares = prior_members * usual_scatter * usual_scatter + (far.count - 1) * far.sd * far.sd;

    Draws draw(values.size());
    std::vector<double> means, further;
    const Moments usual_logs(sides == Sides::above ? logarithms(usual) : std::vector<double>{0});
    for (int k = 0; k < draws; ++k) {
        const double above = draw.gamma(static_cast<double>(apart.above.size()) + jeffreys);
        const double below =
            sides == Sides::both ? draw.gamma(static_cast<double>(apart.below.size()) + jeffreys) : 0.0;
        const double others = draw.gamma(of_usual.count + jeffreys);
        const double all = above + below + others;
        const double variance = squares / draw.chi_squared(prior_members + far.count - 1);
        const double mean = of_usual.mean + of_usual.sd / std::sqrt(of_usual.count) * draw.student(of_usual.freedom());
        const double moved = std::clamp(std::sqrt(variance / far.count) * draw.normal(), -largest_log, largest_log);
        means.push_back(mean + (above - below) / all * std::exp(far.mean + moved));
        if (sides == Sides::both) continue;
        const double one = draw.normal();
        further.push_back(draw.uniform() < above / all
                              ? of_usual.mean +
                                    std::exp(far.mean + moved + std::min(largest_log, std::sqrt(variance) * one))
                              : std::exp(usual_logs.mean + usual_logs.sd * std::sqrt(1 + 1 / usual_logs.count) *
                                                               draw.student(usual_logs.freedom())));
    }
    const Limits limits = percentile_interval(std::move(means));
    Interval mixed = plain;
    mixed.low = std::min(limits.low, plain.estimate);
    mixed.high = std::max(limits.high, plain.estimate);
    if (!further.empty()) {
        const Limits next = percentile_interval(std::move(further));
        mixed.prediction_low = next.low;
        mixed.prediction_high = next.high;
    }
    return mixed;
}

namespace {

constexpr std::size_t most_draws = 20'000'000;

/// Acceleration from the jackknife, U the mean of the statistic without each row in turn less its value without one:
/// Σ U³ / (6 (Σ U²)^(3/2)).
double acceleration(std::size_t rows, const RowStatistic& statistic) {
    std::vector<double> without;
    for (std::uint32_t out = 0; out < rows; ++out) {
        std::vector<std::uint32_t> others = all_rows(rows);
        others.erase(others.begin() + out);
        without.push_back(statistic(others));
    }
    const double mean = mean_of(without);
    double squares = 0;
    double cubes = 0;
    for (const double value : without) {
        const double u = mean - value;
        squares += u * u;
        cubes += u * u * u;
    }
    return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

/// The limits given the bootstrap distribution, the estimate and the acceleration. NaN if the values do not vary, are
/// not finite, or all lie on one side of the estimate.
Limits corrected_limits(std::vector<double> resampled, double estimate, double accelerated) {
    std::ranges::sort(resampled);
    if (resampled.empty() || !std::isfinite(estimate) || !std::isfinite(resampled.front()) ||
        !std::isfinite(resampled.back()) || resampled.front() == resampled.back())
        return no_limits;
    const auto [first, last] = std::ranges::equal_range(resampled, estimate);
    const double below = static_cast<double>((first - resampled.begin()) + (last - resampled.begin())) /
                         (2 * static_cast<double>(resampled.size()));
    if (below <= 0 || below >= 1) return no_limits;
    const double bias = normal_quantile(below);
    // Which quantile of the resampled values is that of the estimate, Efron's Eq. (6.8).
    const auto level = [&](double p) {
        const double shifted = bias + normal_quantile(p);
        return normal_below(bias + shifted / (1 - accelerated * shifted));
    };
    return {quantile_of_sorted(resampled, level(beyond_limit)), quantile_of_sorted(resampled, level(1 - beyond_limit))};
}

}  // namespace

std::vector<std::uint32_t> all_rows(std::size_t rows) {
    std::vector<std::uint32_t> all(rows);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

std::vector<double> bootstrap(std::size_t rows, const RowStatistic& statistic, int resamples) {
    FLOES_EXPECTS(rows >= 1);
    if (resamples == 0) resamples = static_cast<int>(std::clamp<std::size_t>(most_draws / rows, 999, 9999));
    std::vector<double> results(static_cast<std::size_t>(resamples));
    std::vector<std::uint32_t> drawn(rows);
    RandomStream random{0, 0, StreamId::bootstrap, rows};
    for (double& result : results) {
        for (std::uint32_t& row : drawn) row = random.below(static_cast<std::uint32_t>(rows));
        result = statistic(drawn);
    }
    return results;
}

Limits bca_interval(std::size_t rows, const RowStatistic& statistic, int resamples) {
    if (rows < 3) return no_limits;
    return corrected_limits(bootstrap(rows, statistic, resamples), statistic(all_rows(rows)),
                            acceleration(rows, statistic));
}

Limits percentile_interval(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return no_limits;
    std::ranges::sort(values);
    return {quantile_of_sorted(values, beyond_limit), quantile_of_sorted(values, 1 - beyond_limit)};
}

double quantile_of_sorted(std::span<const double> sorted, double p) {
    FLOES_EXPECTS(!sorted.empty() && p >= 0 && p <= 1);
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto index = static_cast<std::size_t>(place);
    if (index + 1 >= sorted.size()) return sorted.back();
    return sorted[index] + (place - static_cast<double>(index)) * (sorted[index + 1] - sorted[index]);
}

}  // namespace floes
