#pragma once
// Waiting for rest: a laboratory test takes a reading only when further steps no longer change it.

#include <cmath>
#include <optional>
#include <utility>

#include "ice/scenario_world.hpp"

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

/// Drag that brings a dry square element of this mass (kg) and side (m) to rest: a tenth of its momentum goes in each
/// step (s). Only the state at rest matters, and that does not depend on it.
inline Wrench settling_drag(const BodyState& body, double mass, double side, double time_step) {
    constexpr double loss = 0.1;
    const double moment_of_inertia = mass * side * side / 12;  // the smallest of a flat box, so that no axis gains
    return {.force = -loss * mass / time_step * body.velocity,
            .moment = -loss * moment_of_inertia / time_step * body.angular_velocity};
}

}  // namespace floes
