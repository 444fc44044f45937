#pragma once
// How many lanes this processor has, and their kernels.

#include <vector>

#include "solver/lane_layout.hpp"

namespace floes {

/// Widths that this processor can run, rising; 1 is always among them. They give the same bits.
std::vector<int> lane_widths();

/// Kernels of one of lane_widths(). Throws RunError for any other width.
const LaneKernels& lane_kernels(int width);

}  // namespace floes
