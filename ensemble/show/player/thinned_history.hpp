#pragma once
// A load history for the eye: few enough points to draw, with every peak.

#include <span>
#include <vector>

namespace floes {

/// values[k] is that of step steps[k].
struct ThinnedHistory {
    std::vector<int> steps;     ///< rising; index of the value in the whole history
    std::vector<float> values;  ///< N
};

/// The least and the largest value of each of at most `most / 2` equal parts of the steps [begin, end), in the order in
/// which they come; all values if they are not more than `most`.
ThinnedHistory thinned(std::span<const double> history, int begin, int end, int most);

}  // namespace floes
