#pragma once
// Means of values: of all of them, and of successive batches.

#include <cstddef>
#include <span>
#include <vector>

namespace floes {

/// Sum over count, added in order; NaN of none.
double mean_of(std::span<const double> values);

/// Value k is the mean of values[k * batch] … values[(k + 1) * batch - 1]; an incomplete batch at the end is dropped.
/// `batch` at least 1.
std::vector<double> batch_means(std::span<const double> values, std::size_t batch);

}  // namespace floes
