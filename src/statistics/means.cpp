#include "statistics/means.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace floes {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double population_sd(std::span<const double> values, double mean) {
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

std::size_t part_begin(std::size_t count, std::size_t index, std::size_t parts) {
    return index * count / parts;
}

std::vector<double> batch_means(std::span<const double> values, std::size_t batch) {
    std::vector<double> means(values.size() / batch);
    for (std::size_t k = 0; k < means.size(); ++k) means[k] = mean_of(values.subspan(k * batch, batch));
    return means;
}

std::vector<double> part_means(std::span<const double> values, std::size_t parts) {
    std::vector<double> means(parts, 0.0);
    const std::size_t length = values.size();  // of a part, where a value has the length `parts`
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t k = i * parts / length; k * length < (i + 1) * parts; ++k) {
            const std::size_t common = std::min((i + 1) * parts, (k + 1) * length) - std::max(i * parts, k * length);
            means[k] += values[i] * static_cast<double>(common) / static_cast<double>(length);
        }
    }
    return means;
}

}  // namespace floes
