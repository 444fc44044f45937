#include "inference/bootstrap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/undefined.hpp"
#include "statistics/distributions.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

constexpr Limits no_limits{undefined, undefined};
constexpr std::size_t most_draws = 20'000'000;

/// Σ U³ / (6 (Σ U²)^(3/2)), where `influence` gives the U of each value.
template <class Influence>
double acceleration_of(std::span<const double> values, Influence influence) {
    double squares = 0;
    double cubes = 0;
    for (const double value : values) {
        const double u = influence(value);
        squares += u * u;
        cubes += u * u * u;
    }
    return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

double acceleration_of_jackknife(std::span<const double> without) {
    return acceleration_of(without, [mean = mean_of(without)](double value) { return mean - value; });
}

/// Acceleration from the jackknife: the statistic without each row in turn.
double acceleration(std::size_t rows, const RowStatistic& statistic) {
    std::vector<double> without;
    leave_out(rows, rows, [&](std::span<const std::uint32_t> others) { without.push_back(statistic(others)); });
    return acceleration_of_jackknife(without);
}

/// Which quantile of the sorted resampled values is that of the estimate, Efron's Eq. (6.8).
class Correction {
  public:
    /// None if the values do not vary, are not finite, or all lie on one side of the estimate.
    static std::optional<Correction> of(std::span<const double> sorted, double estimate, double acceleration) {
        if (sorted.empty() || !std::isfinite(estimate) || !std::isfinite(sorted.front()) ||
            !std::isfinite(sorted.back()) || sorted.front() == sorted.back()) {
            return {};
        }
        const auto [first, last] = std::ranges::equal_range(sorted, estimate);
        const double below = static_cast<double>((first - sorted.begin()) + (last - sorted.begin())) /
                             (2 * static_cast<double>(sorted.size()));
        if (below <= 0 || below >= 1) return {};
        return Correction(normal_quantile(below), acceleration);
    }

    double level(double p) const {
        const double shifted = bias_ + normal_quantile(p);
        return normal_below(bias_ + shifted / (1 - acceleration_ * shifted));
    }

  private:
    Correction(double bias, double acceleration) : bias_(bias), acceleration_(acceleration) {}
    double bias_;
    double acceleration_;
};

/// The limits given the bootstrap distribution, the estimate and the acceleration.
Limits corrected_limits(std::vector<double> resampled, double estimate, double accelerated, double confidence) {
    std::ranges::sort(resampled);
    const auto correction = Correction::of(resampled, estimate, accelerated);
    if (!correction) return no_limits;
    const double tail = (1 - confidence) / 2;
    return {quantile_of_sorted(resampled, correction->level(tail)),
            quantile_of_sorted(resampled, correction->level(1 - tail))};
}

void check_confidence(double confidence) {
    if (confidence > 0 && confidence < 1) return;
    throw InputError(fmt::format("The confidence is {}; it must lie between 0 and 1, such as 0.95.", confidence));
}

}  // namespace

std::vector<std::uint32_t> all_rows(std::size_t rows) {
    std::vector<std::uint32_t> all(rows);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

void leave_out(std::size_t rows, std::size_t most, const std::function<void(std::span<const std::uint32_t>)>& use) {
    const std::size_t groups = std::min(rows, most);
    std::vector<std::uint32_t> others;
    for (std::size_t group = 0; group < groups; ++group) {
        others.clear();
        for (std::uint32_t row = 0; row < rows; ++row)
            if (row % groups != group) others.push_back(row);
        use(others);
    }
}

int default_resamples(std::size_t rows) {
    return static_cast<int>(std::clamp<std::size_t>(most_draws / std::max<std::size_t>(rows, 1), 999, 9999));
}

std::vector<double> bootstrap(std::size_t rows, const RowStatistic& statistic, const BootstrapOptions& options) {
    FLOES_EXPECTS(rows >= 1);
    const int resamples = options.resamples > 0 ? options.resamples : default_resamples(rows);
    std::vector<double> results(static_cast<std::size_t>(resamples));
    std::vector<std::uint32_t> drawn(rows);
    RandomStream random{0, options.draw, StreamId::bootstrap, rows};
    for (double& result : results) {
        for (std::uint32_t& row : drawn) row = random.below(static_cast<std::uint32_t>(rows));
        result = statistic(drawn);
    }
    return results;
}

Limits bca_interval(std::size_t rows, const RowStatistic& statistic, const BootstrapOptions& options) {
    check_confidence(options.confidence);
    if (rows < 3) return no_limits;
    return corrected_limits(bootstrap(rows, statistic, options), statistic(all_rows(rows)),
                            acceleration(rows, statistic), options.confidence);
}

std::vector<double> bca_draws(std::vector<double> resampled, double estimate, std::span<const double> without) {
    std::erase_if(resampled, [](double value) { return !std::isfinite(value); });
    std::ranges::sort(resampled);
    const auto correction = Correction::of(resampled, estimate, acceleration_of_jackknife(without));
    if (!correction) return resampled;
    std::vector<double> moved(resampled.size());
    for (std::size_t k = 0; k < moved.size(); ++k)
        moved[k] = quantile_of_sorted(
            resampled, correction->level((static_cast<double>(k) + 0.5) / static_cast<double>(moved.size())));
    return moved;
}

std::vector<Limits> bca_mean_intervals(std::span<const std::vector<double>> columns, const BootstrapOptions& options) {
    check_confidence(options.confidence);
    const auto mean = [](std::span<const double> values, std::span<const std::uint32_t> rows) {
        double sum = 0;
        for (const std::uint32_t row : rows) sum += values[row];
        return sum / static_cast<double>(rows.size());
    };
    std::map<std::size_t, std::vector<std::size_t>> alike;  // columns by their number of values
    for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k].size() >= 3) alike[columns[k].size()].push_back(k);
    std::vector<Limits> limits(columns.size(), no_limits);
    for (const auto& [rows, members] : alike) {
        std::vector<std::vector<double>> resampled(members.size());
        bootstrap(
            rows,
            [&](std::span<const std::uint32_t> drawn) {
                for (std::size_t k = 0; k < members.size(); ++k)
                    resampled[k].push_back(mean(columns[members[k]], drawn));
                return 0.0;
            },
            options);
        for (std::size_t k = 0; k < members.size(); ++k) {
            const std::vector<double>& values = columns[members[k]];
            // Leaving out row i moves the mean by (x_i - mean) / (n - 1), so the influence needs no n sums.
            const double accelerated =
                acceleration_of(values, [middle = mean_of(values)](double value) { return value - middle; });
            limits[members[k]] = corrected_limits(std::move(resampled[k]), mean(values, all_rows(rows)), accelerated,
                                                  options.confidence);
        }
    }
    return limits;
}

Limits bca_mean_interval(std::span<const double> values, const BootstrapOptions& options) {
    const std::vector<std::vector<double>> only{{values.begin(), values.end()}};
    return bca_mean_intervals(only, options).front();
}

Limits percentile_interval(std::vector<double> values, double confidence) {
    check_confidence(confidence);
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return no_limits;
    std::ranges::sort(values);
    const double tail = (1 - confidence) / 2;
    return {quantile_of_sorted(values, tail), quantile_of_sorted(values, 1 - tail)};
}

double quantile_of_sorted(std::span<const double> sorted, double p) {
    FLOES_EXPECTS(!sorted.empty() && p >= 0 && p <= 1);
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto index = static_cast<std::size_t>(place);
    if (index + 1 >= sorted.size()) return sorted.back();
    return sorted[index] + (place - static_cast<double>(index)) * (sorted[index + 1] - sorted[index]);
}

}  // namespace floes
