#include "inference/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_shape = 1e-9;  // below it log1p(ξ z) / ξ equals z to all relevant digits

/// y of F = exp(-exp(-y)); ±∞ outside the range of the distribution.
double reduced(const ExtremeFit& fit, double x) {
    const double z = (x - fit.location) / fit.scale;
    if (std::abs(fit.shape) < smallest_shape) return z;
    if (1 + fit.shape * z <= 0) return fit.shape > 0 ? -infinity : infinity;
    return std::log1p(fit.shape * z) / fit.shape;
}

}  // namespace

double log_likelihood(const ExtremeFit& fit, std::span<const double> maxima) {
    double sum = -static_cast<double>(maxima.size()) * std::log(fit.scale);
    for (const double x : maxima) {
        const double y = reduced(fit, x);
        if (!std::isfinite(y)) return -infinity;
        sum -= (1 + fit.shape) * y + std::exp(-y);
    }
    return sum;
}

double extreme_cdf(const ExtremeFit& fit, double x) {
    return std::exp(-std::exp(-reduced(fit, x)));
}

double extreme_quantile(const ExtremeFit& fit, double p) {
    const double y = -std::log(-std::log(p));
    const double z = std::abs(fit.shape) < smallest_shape ? y : std::expm1(fit.shape * y) / fit.shape;
    return fit.location + fit.scale * z;
}

double return_level(const ExtremeFit& fit, double segments) {
    return fit.valid() ? extreme_quantile(fit, 1 - 1 / segments) : undefined;
}

Distances distances(const ExtremeFit& fit, std::span<const double> maxima) {
    std::vector<double> sorted(maxima.begin(), maxima.end());
    std::ranges::sort(sorted);
    const double count = static_cast<double>(sorted.size());
    // log F and log (1 - F) without cancellation, so that A² includes far tails.
    std::vector<double> log_below;
    std::vector<double> log_above;
    double largest_gap = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double exponent = std::exp(-reduced(fit, sorted[i]));
        log_below.push_back(std::max(-exponent, -700.0));
        log_above.push_back(std::max(std::log(-std::expm1(-exponent)), -700.0));
        const double below = std::exp(-exponent);
        const double place = static_cast<double>(i);
        largest_gap = std::max({largest_gap, (place + 1) / count - below, below - place / count});
    }
    double sum = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sum += (2 * static_cast<double>(i) + 1) * (log_below[i] + log_above[sorted.size() - 1 - i]);
    }
    return {-count - sum / count, largest_gap};
}

std::vector<ExceedancePoint> exceedance_curve(std::vector<double> maxima) {
    std::ranges::sort(maxima);
    std::vector<ExceedancePoint> curve;
    const double count = static_cast<double>(maxima.size());
    for (std::size_t i = 0; i < maxima.size(); ++i) {
        curve.push_back({maxima[i], (count - static_cast<double>(i)) / (count + 1)});
    }
    return curve;
}

}  // namespace floes
