#include "statistics/load_statistics.hpp"

#include <fmt/format.h>
#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contract.hpp"
#include "statistics/distributions.hpp"

namespace floes {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about(std::span<const double> values, double mean) {
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum;
}

double population_sd(std::span<const double> values, double mean) {
    return std::sqrt(squares_about(values, mean) / static_cast<double>(values.size()));
}

std::size_t part_begin(std::size_t count, std::size_t index, std::size_t parts) {
    return index * count / parts;
}

namespace {

std::span<const double> part_of(std::span<const double> window, std::size_t index, std::size_t parts) {
    const std::size_t begin = part_begin(window.size(), index, parts);
    return window.subspan(begin, part_begin(window.size(), index + 1, parts) - begin);
}

}  // namespace

std::vector<double> part_maxima(std::span<const double> values, std::size_t parts) {
    FLOES_EXPECTS(parts >= 1 && values.size() >= parts);
    std::vector<double> maxima;
    for (std::size_t k = 0; k < parts; ++k) maxima.push_back(std::ranges::max(part_of(values, k, parts)));
    return maxima;
}

std::vector<double> batch_means(std::span<const double> values, std::size_t batch) {
    FLOES_EXPECTS(batch >= 1);
    std::vector<double> means(values.size() / batch);
    for (std::size_t k = 0; k < means.size(); ++k) means[k] = mean_of(values.subspan(k * batch, batch));
    return means;
}

std::vector<double> part_means(std::span<const double> values, std::size_t parts) {
    FLOES_EXPECTS(parts >= 1);
    std::vector<double> means(parts, 0.0);
    const std::size_t length = values.size();  // of a part, where a value has the length `parts`
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t k = i * parts / length; k * length < (i + 1) * parts; ++k) {
            const std::size_t common = std::min((i + 1) * parts, (k + 1) * length) - std::max(i * parts, k * length);
            means[k] += values[i] * static_cast<double>(common) / static_cast<double>(length);
        }
    }
    return means;
}

Swing swing_of(std::span<const double> values) {
    FLOES_EXPECTS(!values.empty());
    const double mean = mean_of(values);
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return {mean, population_sd(values, mean), largest};
}

namespace {

// Batch means: 15 batches of a 150 s window last 10 s each, longer than the correlation time of the load, so their
// means are nearly independent, and 13 degrees of freedom remain for the test.
constexpr std::size_t most_batches = 15;
constexpr double significance = 0.05;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

struct Line {
    double slope = 0;          ///< per index
    double slope_squares = 0;  ///< sum of squared deviations of the index
    double residual_squares = 0;
};

/// Least squares of the values over their indices.
Line fit_line(std::span<const double> values) {
    const double middle = 0.5 * static_cast<double>(values.size() - 1);
    const double mean = mean_of(values);
    Line line;
    double product = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double index = static_cast<double>(i) - middle;
        line.slope_squares += index * index;
        product += index * (values[i] - mean);
    }
    line.slope = product / line.slope_squares;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double residual = values[i] - mean - line.slope * (static_cast<double>(i) - middle);
        line.residual_squares += residual * residual;
    }
    return line;
}

/// Two-sided p of slope = 0 of the batch means: t = slope / standard error with (batches - 2) degrees of freedom.
double slope_p_value(std::span<const double> window) {
    const std::size_t batches = std::min(most_batches, window.size() / 2);
    if (batches < 3) return 1;
    std::vector<double> means;
    for (std::size_t i = 0; i < batches; ++i) means.push_back(mean_of(part_of(window, i, batches)));
    const Line line = fit_line(means);
    const double freedom = static_cast<double>(batches - 2);
    const double error = std::sqrt(line.residual_squares / freedom / line.slope_squares);
    if (line.slope == 0) return 1;
    if (error == 0) return 0;
    return 2 * student_above(std::abs(line.slope) / error, freedom);
}

}  // namespace

LoadStatistics load_statistics(std::span<const double> window, double time_step, int segments) {
    if (segments < 1 || window.size() < 2 * static_cast<std::size_t>(segments)) {
        throw ContractError(
            fmt::format("A window of {} samples cannot be cut into {} segments of at least 2 samples each.",
                        window.size(), segments));
    }
    if (!(time_step > 0)) throw ContractError(fmt::format("The time step is {} s; it must be above 0.", time_step));
    if (!std::ranges::all_of(window, [](double value) { return std::isfinite(value); })) {
        throw ContractError("The load in the window is not finite everywhere, so the member has no statistics.");
    }
    LoadStatistics result;
    result.mean = mean_of(window);
    result.sd = population_sd(window, result.mean);
    result.maximum = std::ranges::max(window);
    result.segment_maximum = part_maxima(window, static_cast<std::size_t>(segments));
    result.mean_maximum = mean_of(result.segment_maximum);
    result.sd_maximum = population_sd(result.segment_maximum, result.mean_maximum);
    result.trend = fit_line(window).slope / time_step;
    result.trend_p = slope_p_value(window);
    result.steady = result.trend_p >= significance;
    const bool constant = !(result.sd > 0);
    result.skewness = constant ? undefined : boost::math::statistics::skewness(window.begin(), window.end());
    result.excess_kurtosis =
        constant ? undefined : boost::math::statistics::excess_kurtosis(window.begin(), window.end());
    return result;
}

std::vector<LevelCount> count_levels(std::span<const double> window, std::span<const double> levels) {
    FLOES_EXPECTS(std::ranges::none_of(levels, [](double level) { return std::isnan(level); }));
    std::vector<LevelCount> counts(levels.size());
    double before = std::numeric_limits<double>::infinity();  // a window that begins above a level does not rise to it
    for (const double load : window) {
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const bool above = load > levels[k];
            counts[k].steps_above += above ? 1 : 0;
            counts[k].upcrossings += above && !(before > levels[k]) ? 1 : 0;
        }
        before = load;
    }
    return counts;
}

namespace {

constexpr std::size_t fewest_batches = 4;
constexpr double window_factor = 5;

/// Sum of products of deviations `lag` apart.
double covariance_sum(std::span<const double> values, double mean, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < values.size(); ++i) sum += (values[i] - mean) * (values[i + lag] - mean);
    return sum;
}

}  // namespace

std::optional<std::size_t> steady_start(std::span<const double> load) {
    if (load.size() < fewest_batches) return {};
    const std::size_t batch = (load.size() + steady_batches - 1) / steady_batches;
    const std::vector<double> means = batch_means(load, batch);
    const std::size_t most = means.size() / 2;
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    double mean = 0;
    double squares = 0;  // of means[i] … about their mean, accumulated from the end (Welford)
    for (std::size_t i = means.size(); i-- > 0;) {
        const double count = static_cast<double>(means.size() - i);
        const double before = means[i] - mean;
        mean += before / count;
        squares += before * (means[i] - mean);
        const double error = squares / (count * count);
        if (i <= most && error <= least) {  // of equal ones, the longest
            least = error;
            best = i;
        }
    }
    if (best == most) return {};
    return best * batch;
}

Autocorrelation autocorrelation(std::span<const double> load, double step, std::size_t batch,
                                std::optional<double> variance) {
    FLOES_EXPECTS(step > 0 && batch >= 1);
    if (load.size() < fewest_batches * batch) return {undefined, undefined};
    const double mean = mean_of(load);
    const double single = variance ? *variance : covariance_sum(load, mean, 0) / static_cast<double>(load.size());
    if (!(single > 0)) return {undefined, undefined};
    const std::vector<double> means = batch_means(load, batch);
    const double mean_of_means = mean_of(means);
    const double own = covariance_sum(means, mean_of_means, 0);
    double tau = 1;
    for (std::size_t lag = 1; lag < means.size(); ++lag) {
        const double next = tau + 2 * covariance_sum(means, mean_of_means, lag) / own;
        if (next <= 0) break;  // of a load that swings regularly
        tau = next;
        if (static_cast<double>(lag) >= window_factor * tau) break;
    }
    const double of_means = own / static_cast<double>(means.size());
    const double effective = static_cast<double>(means.size()) * single / (of_means * tau);
    return {static_cast<double>(load.size()) * step / effective, effective};
}

}  // namespace floes
