#include "statistics/averaged_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "core/contract.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

/// Places of the local maxima above `least`; of a plateau its first.
std::vector<std::size_t> local_maxima(std::span<const double> values, double least) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const bool risen = k == 0 || values[k] > values[k - 1];
        const bool falls = k + 1 == values.size() || values[k] >= values[k + 1];
        if (risen && falls && values[k] > least) places.push_back(k);
    }
    return places;
}

}  // namespace

double largest_of(const AveragedLoad& load) {
    if (load.segment_maximum.empty()) return std::numeric_limits<double>::quiet_NaN();
    return std::ranges::max(load.segment_maximum);
}

std::vector<double> declustered_peaks(std::span<const double> values, std::size_t apart, double least) {
    FLOES_EXPECTS(apart >= 1);
    std::vector<std::size_t> places = local_maxima(values, least);
    std::ranges::stable_sort(places, std::ranges::greater{}, [&](std::size_t place) { return values[place]; });
    std::vector<double> peaks;
    std::set<std::size_t> taken;
    for (const std::size_t place : places) {
        const auto next = taken.lower_bound(place);
        const bool near_next = next != taken.end() && *next - place < apart;
        const bool near_last = next != taken.begin() && place - *std::prev(next) < apart;
        if (near_next || near_last) continue;
        taken.insert(place);
        peaks.push_back(values[place]);
    }
    return peaks;
}

namespace {

/// A sum that terms enter and leave. What rounding takes from it is kept beside it (Neumaier 1974): a peak that has
/// left leaves nothing behind.
class CompensatedSum {
  public:
    void add(double term) {
        const double next = sum_ + term;
        lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + lost_; }

  private:
    double sum_ = 0;
    double lost_ = 0;
};

/// A time in whole steps, at least one.
std::size_t in_steps(double time, double time_step) {
    return static_cast<std::size_t>(std::max(1LL, std::llround(time / time_step)));
}

AveragedLoad averaged_over(std::span<const double> window, double time, const Averaging& how) {
    const std::size_t steps = in_steps(time, how.time_step);
    const auto segments = static_cast<std::size_t>(how.segments);
    const std::vector<double> means = running_means(window, steps);
    const double mean = mean_of(means);
    AveragedLoad result{.time = time,
                        .sd = population_sd(means, mean),
                        .segment_maximum = {},
                        .peaks = declustered_peaks(means, in_steps(how.peak_separation, how.time_step), mean)};
    for (std::size_t k = 0; k < segments; ++k) {
        const std::size_t begin = std::max(part_begin(window.size(), k, segments), steps - 1);
        const std::size_t end = part_begin(window.size(), k + 1, segments);
        if (begin >= end)
            throw ContractError(fmt::format("An averaging time of {} steps is longer than a segment of {}.", steps,
                                            window.size() / segments));
        const auto ending_here = std::span(means).subspan(begin - (steps - 1), end - begin);
        result.segment_maximum.push_back(std::ranges::max(ending_here));
    }
    result.mean_maximum = mean_of(result.segment_maximum);
    result.sd_maximum = population_sd(result.segment_maximum, result.mean_maximum);
    return result;
}

}  // namespace

std::vector<double> running_means(std::span<const double> values, std::size_t count) {
    FLOES_EXPECTS(count >= 1);
    std::vector<double> means;
    CompensatedSum sum;
    for (std::size_t k = 0; k < values.size(); ++k) {
        sum.add(values[k]);
        if (k >= count) sum.add(-values[k - count]);
        if (k + 1 >= count) means.push_back(sum.value() / static_cast<double>(count));
    }
    return means;
}

std::vector<AveragedLoad> averaged_load(std::span<const double> window, const Averaging& how) {
    FLOES_EXPECTS(how.time_step > 0 && how.segments >= 1);
    std::vector<AveragedLoad> all;
    for (const double time : how.times) all.push_back(averaged_over(window, time, how));
    return all;
}

PartLoad part_load(const PartHistory& part, const Averaging& how) {
    FLOES_EXPECTS(!part.surge.empty() && part.surge.size() == part.sway.size());
    PartLoad load{.mean = mean_of(part.surge),
                  .maximum = std::ranges::max(part.surge),
                  .mean_sway = mean_of(part.sway),
                  .mean_heave = mean_of(part.heave)};
    load.sd = population_sd(part.surge, load.mean);
    for (const AveragedLoad& one : averaged_load(part.surge, how)) load.mean_maximum.push_back(one.mean_maximum);
    for (const AveragedLoad& one : averaged_load(part.normal, how)) load.normal_maximum.push_back(one.mean_maximum);
    return load;
}

namespace {

/// First and last value, and where the load turns; no two successive ones are equal.
std::vector<double> turning_points(std::span<const double> values) {
    std::vector<double> points;
    for (const double value : values) {
        if (!points.empty() && value == points.back()) continue;
        const std::size_t count = points.size();
        const bool goes_on =
            count >= 2 && (points[count - 1] - points[count - 2] > 0) == (value - points[count - 1] > 0);
        if (goes_on)
            points.back() = value;
        else
            points.push_back(value);
    }
    return points;
}

LoadCycle cycle(double from, double to, double count) {
    return {std::abs(to - from), 0.5 * (from + to), count};
}

}  // namespace

std::vector<LoadCycle> rainflow(std::span<const double> values) {
    std::vector<LoadCycle> cycles;
    std::vector<double> open;  // points whose ranges are not counted yet
    for (const double point : turning_points(values)) {
        open.push_back(point);
        while (open.size() >= 3) {
            const std::size_t last = open.size() - 1;
            if (std::abs(open[last] - open[last - 1]) < std::abs(open[last - 1] - open[last - 2])) break;
            const bool from_start = open.size() == 3;
            cycles.push_back(cycle(open[last - 2], open[last - 1], from_start ? 0.5 : 1));
            if (from_start)
                open.erase(open.begin());
            else
                open.erase(open.end() - 3, open.end() - 1);
        }
    }
    for (std::size_t k = 1; k < open.size(); ++k) cycles.push_back(cycle(open[k - 1], open[k], 0.5));
    return cycles;
}

double damage_sum(std::span<const LoadCycle> cycles, double exponent) {
    FLOES_EXPECTS(exponent > 0);
    double sum = 0;
    for (const LoadCycle& one : cycles) sum += one.count * std::pow(one.range, exponent);
    return sum;
}

}  // namespace floes
