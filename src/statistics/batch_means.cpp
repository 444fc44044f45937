#include "statistics/batch_means.hpp"

#include <numeric>

namespace floes {

std::vector<double> batch_means(std::span<const double> values, std::size_t batch) {
    std::vector<double> means(values.size() / batch);
    for (std::size_t k = 0; k < means.size(); ++k) {
        const std::span<const double> own = values.subspan(k * batch, batch);
        means[k] = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(batch);
    }
    return means;
}

}  // namespace floes
