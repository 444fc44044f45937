#pragma once
// A figure as SVG. Its styles are classes of the page's style sheet, so that it works on light and dark screens and on
// paper. For this module only.

#include <string>
#include <vector>

#include "tables/figure.hpp"
#include "tables/units.hpp"

namespace floes {

/// Multiples of the axis's step, or of 1, 2 or 5 times a power of ten, from low to high, at most about `most` of them;
/// decades on a logarithmic axis.
std::vector<double> ticks(const Axis& axis, int most);

std::string svg(const Figure& figure, const Units& units = {});

}  // namespace floes
