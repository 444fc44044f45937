#include "inference/sobol_indices.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"

namespace floes {

namespace {

using Rows = std::span<const std::uint32_t>;

void check(const SaltelliValues& values) {
    const auto check_one = [&](const std::vector<double>& one) {
        if (one.size() != values.a.size())
            throw InputError("Sobol indices need one value for each base point at each of Saltelli's points.");
        for (const double value : one) {
            if (!std::isfinite(value))
                throw InputError("Sobol indices need finite values; leave out base points with other ones.");
        }
    };
    check_one(values.a);
    check_one(values.b);
    for (const std::vector<double>& one : values.ab) check_one(one);
}

struct Moments {
    double mean;
    double variance;
};

/// Moments of y_A and y_B together, over the rows.
Moments moments(const SaltelliValues& values, Rows rows) {
    const double count = 2 * static_cast<double>(rows.size());
    double sum = 0;
    for (const std::uint32_t row : rows) sum += values.a[row] + values.b[row];
    const double mean = sum / count;
    double squares = 0;
    for (const std::uint32_t row : rows) {
        const double a = values.a[row] - mean;
        const double b = values.b[row] - mean;
        squares += a * a + b * b;
    }
    return {mean, squares / count};
}

double first_order(const SaltelliValues& values, std::size_t input, Rows rows) {
    const auto [mean, variance] = moments(values, rows);
    double sum = 0;
    for (const std::uint32_t row : rows) sum += (values.b[row] - mean) * (values.ab[input][row] - values.a[row]);
    return sum / static_cast<double>(rows.size()) / variance;
}

double total(const SaltelliValues& values, std::size_t input, Rows rows) {
    double sum = 0;
    for (const std::uint32_t row : rows) {
        const double change = values.a[row] - values.ab[input][row];
        sum += change * change;
    }
    return sum / static_cast<double>(rows.size()) / (2 * moments(values, rows).variance);
}

}  // namespace

SobolIndices sobol_indices(const SaltelliValues& values, const BootstrapOptions& options) {
    check(values);
    const std::size_t count = values.a.size();
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    const bool varies = count > 0 && moments(values, all).variance > 0;
    const auto index = [&](auto estimator, std::size_t input) -> SobolIndex {
        constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
        if (!varies) return {undefined, {undefined, undefined}};
        const RowStatistic statistic = [&](Rows rows) { return estimator(values, input, rows); };
        return {statistic(all), bca_interval(count, statistic, options)};
    };
    SobolIndices indices;
    for (std::size_t input = 0; input < values.ab.size(); ++input) {
        indices.first.push_back(index(first_order, input));
        indices.total.push_back(index(total, input));
    }
    return indices;
}

}  // namespace floes
