#include "inference/sobol_indices.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "statistics/distributions.hpp"
#include "statistics/load_statistics.hpp"

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

struct MeanVariance {
    double mean;
    double variance;
};

/// MeanVariance of y_A and y_B together, over the rows.
MeanVariance moments(const SaltelliValues& values, Rows rows) {
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

namespace {

constexpr double tail = 0.025;
constexpr double rounding = 1e-24;  // of the sum of squares, which equal values may scatter by

/// What F exceeds with 2.5 %.
double high_f(double above, double below) {
    return fisher_quantile_above(tail, above, below);
}

}  // namespace

ArrangementShare arrangement_share(std::span<const std::vector<double>> values) {
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    ArrangementShare found{
        values.size(), values.empty() ? 0 : values.front().size(), undefined, undefined, {undefined, undefined}};
    for (const std::vector<double>& of_case : values)
        if (of_case.size() != found.arrangements)
            throw InputError("Cases over other arrangements have no common table.");
    if (found.cases < 2 || found.arrangements < 3) return found;
    const double cases = static_cast<double>(found.cases);
    const double count = static_cast<double>(found.arrangements);
    std::vector<double> of_arrangement(found.arrangements);  // mean difference from the mean of its case
    double all = 0, between = 0, size = 0;                   // sums of squares
    for (const std::vector<double>& of_case : values) {
        const double mean = mean_of(of_case);
        for (std::size_t k = 0; k < of_case.size(); ++k) {
            of_arrangement[k] += (of_case[k] - mean) / cases;
            all += (of_case[k] - mean) * (of_case[k] - mean);
            size += of_case[k] * of_case[k];
        }
    }
    for (const double one : of_arrangement) between += cases * one * one;
    const double freedom = count - 1;
    const double rest_freedom = freedom * (cases - 1);
    const double of_rest = (all - between) / rest_freedom;
    const double of_arrangements = between / freedom;
    if (!(all > rounding * size)) return found;
    found.sd = std::sqrt(all / (cases * freedom));
    const auto share_of = [&](double f) { return (f - 1) / (f + cases - 1); };
    if (!(of_rest > rounding * size)) {
        found.share = 1;
        return found;
    }
    const double f = of_arrangements / of_rest;
    found.share = share_of(f);
    found.interval = {share_of(f / high_f(freedom, rest_freedom)), share_of(f * high_f(rest_freedom, freedom))};
    return found;
}

}  // namespace floes
