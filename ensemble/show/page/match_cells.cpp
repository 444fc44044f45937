#include "page/match_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

int cell_of(double coordinate, int count) {
    return std::clamp(static_cast<int>(std::floor((coordinate + 1) / 2 * count)), 0, count - 1);
}

std::vector<double> shares(const std::vector<int>& left, const std::vector<int>& points) {
    std::vector<double> made;
    for (std::size_t k = 0; k < points.size(); ++k)
        made.push_back(points[k] > 0 ? static_cast<double>(left[k]) / points[k] : nan);
    return made;
}

}  // namespace

int match_cell_count(const Matching& found) {
    return std::clamp(static_cast<int>(std::sqrt(found.sampled / 8.0)), 4, 16);
}

MatchCells match_cells(const Matching& found, int first_axis, int second_axis, int side) {
    const auto cells = static_cast<std::size_t>(side * side);
    MatchCells made{side, std::vector<double>(cells, nan), {}};
    std::vector<int> points(cells, 0);
    std::vector<int> left(cells, 0);
    for (int row = 0; row < found.sampled; ++row) {
        const auto at = static_cast<std::size_t>(cell_of(found.points(row, second_axis), side) * side +
                                                 cell_of(found.points(row, first_axis), side));
        const double implausibility = found.implausibility[row];
        made.least[at] = std::fmin(made.least[at], implausibility);  // fmin ignores the NaN of an empty cell
        ++points[at];
        left[at] += implausibility <= ruled_out_above;
    }
    made.depth = shares(left, points);
    return made;
}

std::vector<double> share_along(const Matching& found, int axis, int count) {
    std::vector<int> points(static_cast<std::size_t>(count), 0);
    std::vector<int> left(static_cast<std::size_t>(count), 0);
    for (int row = 0; row < found.sampled; ++row) {
        const auto at = static_cast<std::size_t>(cell_of(found.points(row, axis), count));
        ++points[at];
        left[at] += found.implausibility[row] <= ruled_out_above;
    }
    return shares(left, points);
}

}  // namespace floes
