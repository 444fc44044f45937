#include "inference/variance_parts.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "statistics/distributions.hpp"
#include "statistics/means.hpp"

namespace floes {
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
