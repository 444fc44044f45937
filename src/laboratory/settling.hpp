#pragma once
// Waiting for rest: a laboratory test reads its ice only when another while changes nothing any more.

#include <cmath>
#include <optional>
#include <utility>

namespace floes {

/// Steps between two looks, and how many looks a test may take.
inline constexpr int steps_between_looks = 25;
inline constexpr int most_looks = 400;

/// Calls advance() until observe() (m) changes by no more than 1e-7 of its distance from `origin` between two looks,
/// twice running; a turning point is no rest. Returns that reading, or nothing when it never settles.
template <class Advance, class Observe>
std::optional<double> settle(Advance&& advance, Observe&& observe, double origin) {
    double reading = observe();
    int quiet = 0;
    for (int look = 0; look < most_looks; ++look) {
        for (int step = 0; step < steps_between_looks; ++step) advance();
        const double before = std::exchange(reading, observe());
        if (!std::isfinite(reading)) return std::nullopt;
        quiet = std::abs(reading - before) <= 1e-7 * std::abs(reading - origin) + 1e-15 ? quiet + 1 : 0;
        if (quiet == 2) return reading;
    }
    return std::nullopt;
}

}  // namespace floes
