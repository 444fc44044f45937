#pragma once
// Means of successive values.

#include <cstddef>
#include <span>
#include <vector>

namespace floes {

/// Value k is the mean of values[k * batch] … values[(k + 1) * batch - 1]; an incomplete batch at the end is dropped.
/// `batch` at least 1.
std::vector<double> batch_means(std::span<const double> values, std::size_t batch);

}  // namespace floes
