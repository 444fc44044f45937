#pragma once
// Means of values, of all of them and of successive batches, and their spread.

#include <cstddef>
#include <span>
#include <vector>

namespace floes {

/// Sum over count, added in order; NaN of none.
double mean_of(std::span<const double> values);

/// Root of the mean square difference from `mean`; NaN if there is none.
double population_sd(std::span<const double> values, double mean);

/// Index at which part `index` of `parts` equal parts of `count` values begins; they differ by one value where `parts`
/// does not divide `count`.
std::size_t part_begin(std::size_t count, std::size_t index, std::size_t parts);

/// Value k is the mean of values[k * batch] … values[(k + 1) * batch - 1]; an incomplete batch at the end is dropped.
/// `batch` at least 1.
std::vector<double> batch_means(std::span<const double> values, std::size_t batch);

/// Mean of each of `parts` equal parts of the values, of which there is at least one. A value across an edge counts on
/// both sides by its share there, so the mean of the parts is the mean of all.
std::vector<double> part_means(std::span<const double> values, std::size_t parts);

}  // namespace floes
