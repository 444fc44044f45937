#pragma once
// Waiting for rest: a laboratory test takes a reading only when further steps no longer change it.

#include <cmath>
#include <optional>
#include <utility>

namespace floes {

/// Steps between two observations, and the largest number of observations.
inline constexpr int steps_between_looks = 25;
inline constexpr int most_looks = 400;

/// Calls advance() until observe() (m) changes by no more than 1e-7 of its distance from `origin` between two
/// observations, twice in a row, because a turning point is not rest. At `origin` itself rounding is left: 1e-15 m
/// times size_of_ice(). Returns the last observation, or nothing if it never settles.
template <class Advance, class Observe>
std::optional<double> settle(Advance&& advance, Observe&& observe, double origin, double size) {
    double reading = observe();
    int quiet = 0;
    for (int look = 0; look < most_looks; ++look) {
        for (int step = 0; step < steps_between_looks; ++step) advance();
        const double before = std::exchange(reading, observe());
        if (!std::isfinite(reading)) return std::nullopt;
        quiet = std::abs(reading - before) <= 1e-7 * std::abs(reading - origin) + 1e-15 * size ? quiet + 1 : 0;
        if (quiet == 2) return reading;
    }
    return std::nullopt;
}

}  // namespace floes
