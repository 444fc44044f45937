#include "statistics/steady_state.hpp"

#include <limits>
#include <vector>

#include "core/contract.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {
namespace {

constexpr std::size_t fewest_batches = 4;
constexpr double window_factor = 5;

/// Sum of products of deviations `lag` apart.
double covariance_sum(std::span<const double> values, double mean, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < values.size(); ++i) sum += (values[i] - mean) * (values[i + lag] - mean);
    return sum;
}

}  // namespace

std::optional<std::size_t> steady_start(std::span<const double> load) {
    if (load.size() < fewest_batches) return {};
    const std::size_t batch = (load.size() + steady_batches - 1) / steady_batches;
    const std::vector<double> means = batch_means(load, batch);
    const std::size_t most = means.size() / 2;
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    double mean = 0;
    double squares = 0;  // of means[i] … about their mean, accumulated from the end (Welford)
    for (std::size_t i = means.size(); i-- > 0;) {
        const double count = static_cast<double>(means.size() - i);
        const double before = means[i] - mean;
        mean += before / count;
        squares += before * (means[i] - mean);
        const double error = squares / (count * count);
        if (i <= most && error <= least) {  // of equal ones, the longest
            least = error;
            best = i;
        }
    }
    if (best == most) return {};
    return best * batch;
}

Autocorrelation autocorrelation(std::span<const double> load, double step, std::size_t batch,
                                std::optional<double> variance) {
    FLOES_EXPECTS(step > 0 && batch >= 1);
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
    if (load.size() < fewest_batches * batch) return {undefined, undefined};
    const double mean = mean_of(load);
    const double single = variance ? *variance : covariance_sum(load, mean, 0) / static_cast<double>(load.size());
    if (!(single > 0)) return {undefined, undefined};
    const std::vector<double> means = batch_means(load, batch);
    const double mean_of_means = mean_of(means);
    const double own = covariance_sum(means, mean_of_means, 0);
    double tau = 1;
    for (std::size_t lag = 1; lag < means.size(); ++lag) {
        tau += 2 * covariance_sum(means, mean_of_means, lag) / own;
        if (static_cast<double>(lag) >= window_factor * tau) break;
    }
    const double of_means = own / static_cast<double>(means.size());
    const double effective = static_cast<double>(means.size()) * single / (of_means * tau);
    return {static_cast<double>(load.size()) * step / effective, effective};
}

}  // namespace floes
