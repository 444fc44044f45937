#include "inference/return_levels.hpp"

#include <algorithm>

namespace floes {

namespace {

constexpr double fit_budget = 3e5;  // maxima fitted in all resamples; at least 199 resamples, at most 999

std::vector<double> pooled(std::span<const std::vector<double>> maxima) {
    std::vector<double> all;
    for (const std::vector<double>& one : maxima) all.insert(all.end(), one.begin(), one.end());
    return all;
}

std::vector<ExtremeFit> refit(std::span<const std::vector<double>> maxima, ExtremeKind kind, const ExtremeFit& fit,
                              std::size_t count) {
    const double affordable = fit_budget / static_cast<double>(count);
    const int resamples = static_cast<int>(std::clamp(affordable, 199.0, 999.0));
    std::vector<ExtremeFit> fits;
    std::vector<double> drawn;
    bootstrap(maxima.size(),
              [&](std::span<const std::uint32_t> rows) {
                  drawn.clear();
                  for (const std::uint32_t row : rows)
                      drawn.insert(drawn.end(), maxima[row].begin(), maxima[row].end());
                  const ExtremeFit found = fit_maxima(drawn, kind, &fit);
                  if (found.valid()) fits.push_back(found);
                  return found.location;
              },
              {.resamples = resamples});
    return fits;
}

}  // namespace

FittedExtreme fit_extremes(std::span<const std::vector<double>> maxima, ExtremeKind kind,
                           std::span<const double> segments) {
    const std::vector<double> all = pooled(maxima);
    FittedExtreme result;
    result.kind = kind;
    result.fit = fit_maxima(all, kind);
    result.goodness = goodness_of_fit(result.fit, kind, all);
    std::vector<ExtremeFit> fits;
    if (result.fit.valid()) fits = refit(maxima, kind, result.fit, all.size());
    const auto limits = [&](auto value) {
        std::vector<double> values(fits.size());
        std::ranges::transform(fits, values.begin(), value);
        return percentile_interval(std::move(values));
    };
    result.location = limits([](const ExtremeFit& fit) { return fit.location; });
    result.scale = limits([](const ExtremeFit& fit) { return fit.scale; });
    result.shape = limits([](const ExtremeFit& fit) { return fit.shape; });
    for (const double period : segments) {
        result.levels.push_back({period, return_level(result.fit, period),
                                 limits([period](const ExtremeFit& fit) { return return_level(fit, period); })});
    }
    return result;
}

}  // namespace floes
