#include "inference/interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Interval mean_interval(std::span<const double> values, double confidence) {
    if (!(confidence > 0 && confidence < 1)) {
        throw InputError(fmt::format("The confidence is {}; it must lie between 0 and 1, such as 0.95.", confidence));
    }
    double sum = 0;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            throw InputError(
                fmt::format("A mean over {} members includes the value {}; leave out members without a result.",
                            values.size(), value));
        }
        sum += value;
    }
    if (values.empty()) return {undefined, undefined, undefined, undefined, undefined};
    const double count = static_cast<double>(values.size());
    const double mean = sum / count;
    if (values.size() == 1) return {mean, undefined, undefined, undefined, undefined};

    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double sd = std::sqrt(squares / (count - 1));
    const double t = student_t(count - 1, (1 - confidence) / 2);
    const double of_mean = t * sd / std::sqrt(count);
    const double of_run = t * sd * std::sqrt(1 + 1 / count);
    return {mean, mean - of_mean, mean + of_mean, mean - of_run, mean + of_run};
}

Interval positive_interval(std::span<const double> values, double confidence) {
    Interval interval = mean_interval(values, confidence);
    if (std::ranges::any_of(values, [](double value) { return value <= 0; })) return interval;
    std::vector<double> logarithms(values.size());
    std::ranges::transform(values, logarithms.begin(), [](double value) { return std::log(value); });
    const Interval logarithmic = mean_interval(logarithms, confidence);
    interval.prediction_low = std::exp(logarithmic.prediction_low);
    interval.prediction_high = std::exp(logarithmic.prediction_high);
    return interval;
}

Interval clipped(const Interval& interval, double least, double most) {
    // NaN stays NaN, because both comparisons are false.
    const auto cut = [&](double value) { return value < least ? least : value > most ? most : value; };
    return {cut(interval.estimate), cut(interval.low), cut(interval.high), cut(interval.prediction_low),
            cut(interval.prediction_high)};
}

}  // namespace floes
