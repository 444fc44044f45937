#include "match/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double mean) {
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum;
}

/// Covariance of single runs of two points on one arrangement. Of two points with m and n runs, c of them on common
/// arrangements, the product of two deviations from the points' means has the expectation
/// (1 - 1/m - 1/n + c/(m n)) times the covariance.
double covariance(std::span<const PointRuns> points, const std::vector<double>& means) {
    std::vector<std::map<int, double>> deviations;
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::map<int, double>& of_point = deviations.emplace_back();
        for (std::size_t k = 0; k < points[p].values.size(); ++k)
            of_point[points[p].arrangements[k]] = points[p].values[k] - means[p];
    }
    double products = 0;
    double weight = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t q = p + 1; q < points.size(); ++q) {
            if (points[p].wave != points[q].wave) continue;
            double common = 0;
            for (const auto& [arrangement, deviation] : deviations[p]) {
                const auto other = deviations[q].find(arrangement);
                if (other == deviations[q].end()) continue;
                products += deviation * other->second;
                common += 1;
            }
            const auto m = static_cast<double>(deviations[p].size());
            const auto n = static_cast<double>(deviations[q].size());
            weight += common * (1 - 1 / m - 1 / n + common / (m * n));
        }
    }
    return weight > 0 ? products / weight : 0;
}

}  // namespace

Scatter scatter_of(std::span<const PointRuns> points, double pooled_runs) {
    Scatter found{{}, {}, {}, nan, 0};
    double squares = 0;
    double freedom = 0;
    std::vector<double> own_squares;
    for (const PointRuns& point : points) {
        const double own_freedom = static_cast<double>(point.values.size()) - 1;
        found.mean.push_back(mean_of(point.values));
        own_squares.push_back(squares_about(point.values, found.mean.back()));
        found.sample_variance.push_back(own_freedom > 0 ? own_squares.back() / own_freedom : nan);
        squares += own_squares.back();
        freedom += own_freedom;
    }
    if (freedom > 0) found.pooled = squares / freedom;
    for (std::size_t p = 0; p < points.size(); ++p)
        found.variance.push_back((pooled_runs * found.pooled + own_squares[p]) /
                                 (pooled_runs + static_cast<double>(points[p].values.size()) - 1));
    if (found.pooled > 0) found.shared = std::clamp(covariance(points, found.mean) / found.pooled, 0.0, 1.0);
    return found;
}

}  // namespace floes
