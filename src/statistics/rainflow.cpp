#include "statistics/rainflow.hpp"

#include <cmath>

#include "core/contract.hpp"

namespace floes {
namespace {

/// First and last value, and where the load turns; no two successive ones are equal.
std::vector<double> turning_points(std::span<const double> values) {
    std::vector<double> points;
    for (const double value : values) {
        if (!points.empty() && value == points.back()) continue;
        const std::size_t count = points.size();
        const bool goes_on =
            count >= 2 && (points[count - 1] - points[count - 2] > 0) == (value - points[count - 1] > 0);
        if (goes_on)
            points.back() = value;
        else
            points.push_back(value);
    }
    return points;
}

LoadCycle cycle(double from, double to, double count) {
    return {std::abs(to - from), 0.5 * (from + to), count};
}

}  // namespace

std::vector<LoadCycle> rainflow(std::span<const double> values) {
    std::vector<LoadCycle> cycles;
    std::vector<double> open;  // points whose ranges are not counted yet
    for (const double point : turning_points(values)) {
        open.push_back(point);
        while (open.size() >= 3) {
            const std::size_t last = open.size() - 1;
            if (std::abs(open[last] - open[last - 1]) < std::abs(open[last - 1] - open[last - 2])) break;
            const bool from_start = open.size() == 3;
            cycles.push_back(cycle(open[last - 2], open[last - 1], from_start ? 0.5 : 1));
            if (from_start)
                open.erase(open.begin());
            else
                open.erase(open.end() - 3, open.end() - 1);
        }
    }
    for (std::size_t k = 1; k < open.size(); ++k) cycles.push_back(cycle(open[k - 1], open[k], 0.5));
    return cycles;
}

double damage_sum(std::span<const LoadCycle> cycles, double exponent) {
    FLOES_EXPECTS(exponent > 0);
    double sum = 0;
    for (const LoadCycle& one : cycles) sum += one.count * std::pow(one.range, exponent);
    return sum;
}

}  // namespace floes
