#include "inference/extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <boost/math/tools/roots.hpp>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "inference/numerics.hpp"

namespace floes {

namespace {

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
    FLOES_EXPECTS(p > 0 && p < 1);
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

namespace {

constexpr ExtremeFit no_fit{undefined, undefined, undefined, undefined};
constexpr int most_fits = 999;
constexpr std::size_t most_drawn = 500;  // maxima in a sample
constexpr double fit_budget = 1e5;       // maxima fitted in all samples of a goodness of fit, at least 199 samples

/// λ1, λ2, λ3 from unbiased probability-weighted moments.
std::array<double, 3> l_moments(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const double n = static_cast<double>(sorted.size());
    double b0 = 0;
    double b1 = 0;
    double b2 = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double place = static_cast<double>(i);
        b0 += sorted[i] / n;
        b1 += sorted[i] * place / (n - 1) / n;
        b2 += sorted[i] * place * (place - 1) / ((n - 1) * (n - 2)) / n;
    }
    return {b0, 2 * b1 - b0, 6 * b2 - 6 * b1 + b0};
}

/// Root of the likelihood equation s = mean(x) - Σ x e^(-x/s) / Σ e^(-x/s); the location follows from it.
ExtremeFit fit_gumbel(std::span<const double> maxima, double first_scale) {
    const double count = static_cast<double>(maxima.size());
    const double mean = std::accumulate(maxima.begin(), maxima.end(), 0.0) / count;
    const double least = std::ranges::min(maxima);
    const auto sums = [&](double scale) {
        double weights = 0;
        double weighted = 0;
        for (const double x : maxima) {
            const double weight = std::exp(-(x - least) / scale);
            weights += weight;
            weighted += weight * x;
        }
        return std::pair(weights, weighted / weights);
    };
    const auto equation = [&](double scale) { return scale - mean + sums(scale).second; };
    // The equation rises from below 0 (scale -> 0: least - mean) without bound.
    double low = first_scale;
    double high = first_scale;
    while (equation(low) > 0) low /= 2;
    while (equation(high) < 0) high *= 2;
    std::uintmax_t steps = 200;
    const auto bracket =
        boost::math::tools::toms748_solve(equation, low, high, boost::math::tools::eps_tolerance<double>(50), steps);
    ExtremeFit fit{0, 0.5 * (bracket.first + bracket.second), 0, 0};
    fit.location = least - fit.scale * std::log(sums(fit.scale).first / count);
    fit.log_likelihood = log_likelihood(fit, maxima);
    return fit;
}

// Coordinates of the simplex in units of the start's scale: (location, log scale, shape), so that one size fits all.
ExtremeFit fit_by_simplex(std::span<const double> maxima, const ExtremeFit& start, double size, double small_enough) {
    const auto at = [&start](std::span<const double> point) -> ExtremeFit {
        return {start.location + start.scale * point[0], start.scale * std::exp(point[1]), point[2], 0};
    };
    const auto cost = [&](std::span<const double> point) {
        const ExtremeFit fit = at(point);
        return std::abs(fit.shape) < 1 ? -log_likelihood(fit, maxima) : infinity;
    };
    const Minimum found = walk_simplex(cost, std::array{0.0, 0.0, start.shape}, {size, small_enough});
    if (!std::isfinite(found.cost)) return no_fit;
    ExtremeFit fit = at(found.at);
    fit.log_likelihood = -found.cost;
    return fit;
}

/// A start with a finite likelihood: the L-moments, or Gumbel's parameters if the data exceed the range of the former.
ExtremeFit gev_start(std::span<const double> maxima) {
    const ExtremeFit by_moments = fit_by_l_moments(maxima, ExtremeKind::gev);
    if (by_moments.valid() && std::abs(by_moments.shape) < 1 && std::isfinite(by_moments.log_likelihood))
        return by_moments;
    return fit_by_l_moments(maxima, ExtremeKind::gumbel);
}

}  // namespace

ExtremeFit fit_by_l_moments(std::span<const double> maxima, ExtremeKind kind) {
    if (maxima.size() < 3) return no_fit;
    const auto [mean, spread, third] = l_moments(maxima);
    if (!(spread > 0)) return no_fit;
    ExtremeFit fit;
    if (kind == ExtremeKind::gumbel) {
        fit.scale = spread / std::log(2.0);
        fit.location = mean - std::numbers::egamma * fit.scale;
    } else {
        const double c = 2 / (3 + third / spread) - std::log(2.0) / std::log(3.0);
        const double k = 7.8590 * c + 2.9554 * c * c;  // = -ξ
        if (!(k > -1) || std::abs(k) < 1e-6) return fit_by_l_moments(maxima, ExtremeKind::gumbel);
        const double gamma = std::tgamma(1 + k);
        fit.shape = -k;
        fit.scale = spread * k / ((1 - std::pow(2, -k)) * gamma);
        fit.location = mean - fit.scale * (1 - gamma) / k;
    }
    fit.log_likelihood = log_likelihood(fit, maxima);
    return fit;
}

ExtremeFit fit_maxima(std::span<const double> maxima, ExtremeKind kind, const ExtremeFit* start) {
    if (maxima.size() < fewest_maxima) return no_fit;
    const ExtremeFit gumbel = fit_by_l_moments(maxima, ExtremeKind::gumbel);
    if (!gumbel.valid()) return no_fit;
    if (kind == ExtremeKind::gumbel) return fit_gumbel(maxima, gumbel.scale);
    // A resample's fit is close to that of the data and needs less precision than the scatter of resamples.
    if (start != nullptr && std::isfinite(log_likelihood(*start, maxima)))
        return fit_by_simplex(maxima, *start, 0.1, 1e-4);
    // Run twice: a second simplex escapes if the first one collapsed.
    const ExtremeFit first = fit_by_simplex(maxima, gev_start(maxima), 0.2, 1e-6);
    const ExtremeFit second = first.valid() ? fit_by_simplex(maxima, first, 0.05, 1e-9) : no_fit;
    constexpr double edge = 0.99;  // where the likelihood still rises beyond the shapes that are looked at
    return std::abs(second.shape) < edge ? second : no_fit;
}

GoodnessOfFit goodness_of_fit(const ExtremeFit& fit, ExtremeKind kind, std::span<const double> maxima, int samples) {
    GoodnessOfFit result{{undefined, undefined}, undefined, undefined};
    if (!fit.valid()) return result;
    result.found = distances(fit, maxima);
    if (samples == 0) {
        const double affordable = fit_budget / static_cast<double>(std::min(maxima.size(), most_drawn));
        samples = static_cast<int>(std::clamp(affordable, 199.0, double{most_fits}));
    }
    RandomStream random{0, static_cast<std::uint32_t>(kind), StreamId::goodness_of_fit, maxima.size()};
    // A² and √n D of a fitted distribution hardly depend on the number of maxima (Stephens' 1 + 0.2/√n).
    std::vector<double> drawn(std::min(maxima.size(), most_drawn));
    const double root = std::sqrt(static_cast<double>(maxima.size()) / static_cast<double>(drawn.size()));
    int farther_a = 0;
    int farther_d = 0;
    for (int sample = 0; sample < samples; ++sample) {
        for (double& x : drawn) x = extreme_quantile(fit, random.uniform(1e-16, 1));
        const ExtremeFit own = fit_maxima(drawn, kind, &fit);
        if (!own.valid()) continue;
        const Distances other = distances(own, drawn);
        farther_a += other.anderson_darling >= result.found.anderson_darling;
        farther_d += other.kolmogorov_smirnov >= root * result.found.kolmogorov_smirnov;
    }
    // The data count as one more sample, so p is never 0.
    result.anderson_darling_p = (farther_a + 1.0) / (samples + 1.0);
    result.kolmogorov_smirnov_p = (farther_d + 1.0) / (samples + 1.0);
    return result;
}

FittedExtreme fit_extremes(std::span<const double> maxima, ExtremeKind kind) {
    const ExtremeFit fit = fit_maxima(maxima, kind);
    return {kind, fit, goodness_of_fit(fit, kind, maxima)};
}

}  // namespace floes
