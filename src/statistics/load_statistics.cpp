#include "statistics/load_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "statistics/distributions.hpp"
#include "statistics/means.hpp"

namespace floes {
namespace {

// Batch means: 15 batches of a 150 s window last 10 s each, longer than the correlation time of the load, so their
// means are nearly independent, and 13 degrees of freedom remain for the test.
constexpr std::size_t most_batches = 15;
constexpr double significance = 0.05;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

std::span<const double> part_of(std::span<const double> window, std::size_t index, std::size_t parts) {
    const std::size_t begin = part_begin(window.size(), index, parts);
    return window.subspan(begin, part_begin(window.size(), index + 1, parts) - begin);
}

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
        throw std::invalid_argument(
            fmt::format("A window of {} samples cannot be cut into {} segments of at least 2 samples each.",
                        window.size(), segments));
    }
    if (!(time_step > 0))
        throw std::invalid_argument(fmt::format("The time step is {} s; it must be above 0.", time_step));
    if (!std::ranges::all_of(window, [](double value) { return std::isfinite(value); })) {
        throw std::invalid_argument(
            "The load in the window is not finite everywhere, so the member has no statistics.");
    }
    LoadStatistics result;
    result.mean = mean_of(window);
    result.sd = population_sd(window, result.mean);
    result.maximum = std::ranges::max(window);
    const auto parts = static_cast<std::size_t>(segments);
    for (std::size_t i = 0; i < parts; ++i) {
        result.segment_maximum.push_back(std::ranges::max(part_of(window, i, parts)));
    }
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

}  // namespace floes
