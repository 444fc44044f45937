#include "inference/hidden_peaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace floes {
namespace {

constexpr double step = 1e-3;  // of u
constexpr std::size_t last = 3000;

struct Table {
    std::array<double, last + 1> kept{};  ///< θ
    std::array<double, last + 1> seen{};  ///< θ'
};

double exponent_slope(double v) {
    return v < 1e-8 ? 1 : -std::expm1(-v) / v;
}

/// By the trapezoid rule, whose error here is below 1e-7.
Table tabulated() {
    Table table;
    double exponent = 0;
    table.seen[0] = 1;
    for (std::size_t k = 1; k <= last; ++k) {
        const double u = step * static_cast<double>(k);
        exponent += 0.5 * step * (exponent_slope(u - step) + exponent_slope(u));
        table.seen[k] = std::exp(-2 * exponent);
        table.kept[k] = table.kept[k - 1] + 0.5 * step * (table.seen[k - 1] + table.seen[k]);
    }
    return table;
}

}  // namespace

double events_per_peak(double kept) {
    static const Table table = tabulated();
    const auto above = std::ranges::upper_bound(table.kept, kept);
    if (above == table.kept.begin()) return 1;
    if (above == table.kept.end()) return 1 / table.seen.back();
    const auto k = static_cast<std::size_t>(above - table.kept.begin());
    const double part = (kept - table.kept[k - 1]) / (table.kept[k] - table.kept[k - 1]);
    return 1 / (table.seen[k - 1] + part * (table.seen[k] - table.seen[k - 1]));
}

}  // namespace floes
