#include "inference/year_load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.hpp"
#include "core/undefined.hpp"
#include "inference/sobol_indices.hpp"
#include "statistics/distributions.hpp"

namespace floes {
namespace {

constexpr std::size_t drawn = 800;
constexpr std::size_t drawn_for_indices = 256;
constexpr double least_factor = 0.05;  // a load is above 0, however uncertain its emulator

/// One number in each of `count` equal parts of (0, 1), in random order.
std::vector<double> latin(std::size_t count, RandomStream& random) {
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k)
        values[k] = (static_cast<double>(k) + random.uniform(1e-9, 1)) / static_cast<double>(count);
    for (std::size_t k = count; k > 1; --k)
        std::swap(values[k - 1], values[random.below(static_cast<std::uint32_t>(k))]);
    return values;
}

YearFigure figure_of(std::vector<double> values) {
    // A year without such a load in some of the draws has none to quote.
    if (std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
        return {undefined, {undefined, undefined}};
    std::ranges::sort(values);
    return {quantile_of_sorted(values, 0.5), {quantile_of_sorted(values, 0.025), quantile_of_sorted(values, 0.975)}};
}

}  // namespace

YearLoad::YearLoad(std::span<const PosteriorLoad* const> sources, std::vector<YearRegime> regimes)
    : sources_(sources.begin(), sources.end()), regimes_(std::move(regimes)), years_(draw(drawn, 0)) {}

std::vector<YearLoad::Year> YearLoad::draw(std::size_t count, std::uint32_t number) const {
    std::vector<Year> years(count);
    for (std::size_t source = 0; source < sources_.size(); ++source) {
        RandomStream random{36, number, StreamId::bootstrap, source};
        const std::vector<double> places = latin(count, random);
        const std::vector<double> offs = latin(count, random);
        const std::vector<PosteriorLoad::Draw>& draws = sources_[source]->draws();
        std::vector<double> sums;
        double sum = 0;
        for (const PosteriorLoad::Draw& one : draws) sums.push_back(sum += one.weight);
        for (std::size_t k = 0; k < count; ++k) {
            const auto at = std::ranges::lower_bound(sums, places[k] * sum) - sums.begin();
            const auto row = std::min(static_cast<std::size_t>(at), draws.size() - 1);
            years[k].push_back({&draws[row].tail, normal_quantile(offs[k])});
        }
    }
    return years;
}

double YearLoad::expected_above(std::size_t regime, const Year& year, double x) const {
    const YearRegime& one = regimes_[regime];
    const Choice& choice = year[one.source];
    const double factor = one.factor * std::max(least_factor, 1 + one.factor_sd * choice.off);
    const double window = sources_[one.source]->window();
    return -log_below(*choice.tail, window, one.time / window, x / factor);
}

double YearLoad::expected_above(const Year& year, double x) const {
    double sum = 0;
    for (std::size_t regime = 0; regime < regimes_.size(); ++regime) sum += expected_above(regime, year, x);
    return sum;
}

double YearLoad::load_of(const Year& year, double probability) const {
    const double wanted = -std::log1p(-probability);
    double low = std::numeric_limits<double>::infinity();
    for (const YearRegime& regime : regimes_) low = std::min(low, regime.factor * year[regime.source].tail->threshold);
    low *= 0.1;
    if (!(expected_above(year, low) > wanted)) return undefined;
    double high = 2 * low;
    for (int k = 0; k < 60 && expected_above(year, high) > wanted; ++k) {
        low = high;
        high *= 2;
    }
    for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (low + high);
        (expected_above(year, middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::vector<double> YearLoad::loads(double probability) const {
    std::vector<double> found;
    for (const Year& year : years_) found.push_back(load_of(year, probability));
    return found;
}

YearFigure YearLoad::load(double probability) const {
    return figure_of(loads(probability));
}

std::vector<YearShare> YearLoad::shares(double probability) const {
    const std::vector<double> found = loads(probability);
    const double expected = -std::log1p(-probability);
    std::vector<YearShare> made;
    for (std::size_t regime = 0; regime < regimes_.size(); ++regime) {
        std::vector<double> parts;
        for (std::size_t k = 0; k < years_.size(); ++k) {
            const double all = expected_above(years_[k], found[k]);
            parts.push_back(all > 0 ? expected_above(regime, years_[k], found[k]) / all : undefined);
        }
        const double mean = std::accumulate(parts.begin(), parts.end(), 0.0) / static_cast<double>(parts.size());
        made.push_back({mean, percentile_interval(std::move(parts)), regimes_[regime].time / (mean * expected)});
    }
    return made;
}

std::vector<double> YearLoad::uncertainty(double probability) const {
    if (sources_.size() == 1) return {1.0};
    const std::vector<Year> one = draw(drawn_for_indices, 1);
    const std::vector<Year> other = draw(drawn_for_indices, 2);
    const auto log_loads = [&](const std::vector<Year>& years) {
        std::vector<double> values;
        for (const Year& year : years) values.push_back(std::log(load_of(year, probability)));
        return values;
    };
    SaltelliValues values{log_loads(one), log_loads(other), {}};
    for (std::size_t source = 0; source < sources_.size(); ++source) {
        std::vector<Year> mixed = one;
        for (std::size_t k = 0; k < mixed.size(); ++k) mixed[k][source] = other[k][source];
        values.ab.push_back(log_loads(mixed));
    }
    std::vector<double> made(sources_.size(), undefined);
    if (!std::ranges::all_of(values.a, [](double value) { return std::isfinite(value); })) return made;
    const SobolIndices indices = sobol_indices(values, {.resamples = 999});
    for (std::size_t source = 0; source < made.size(); ++source)
        made[source] = std::clamp(indices.first[source].estimate, 0.0, 1.0);
    return made;
}

std::vector<double> YearLoad::exceeded(double x) const {
    std::vector<double> found;
    for (const Year& year : years_) found.push_back(-std::expm1(-expected_above(year, x)));
    return found;
}

}  // namespace floes
