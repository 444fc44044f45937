#include "tables/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {

double round_above(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= value) return digit * power;
    return 10 * power;
}

double round_below(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= value) return digit * power;
    return power;
}

Axis axis_around(std::string label, std::span<const double> values, bool with_zero, std::string unit) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) low = high = 0;
    if (with_zero) {
        low = std::min(low, 0.0);
        high = std::max(high, 0.0);
    }
    if (low == high) high = low + 1;
    const double air = 0.05 * (high - low);
    return {.label = std::move(label),
            .low = with_zero && low == 0 ? 0 : low - air,
            .high = with_zero && high == 0 ? 0 : high + air,
            .unit = std::move(unit)};
}

void Figure::band(Points low, const Points& high, std::string style) {
    low.insert(low.end(), high.rbegin(), high.rend());
    area(std::move(low), std::move(style));
}

Figure::Size to_scale(double width, double height, double widest) {
    constexpr double beside = 80;  // of the plot, for axes and labels
    constexpr double below = 74;
    constexpr double highest = 420;
    const double scale = std::min((widest - beside) / width, highest / height);
    return {beside + scale * width, below + scale * height};
}

std::string colour(std::size_t number) {
    constexpr std::size_t colours = 6;
    return fmt::format("c{}", number % colours);
}

}  // namespace floes
