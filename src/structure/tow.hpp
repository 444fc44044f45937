#pragma once
// The prescribed surge of the structure: constant speed from a starting point, no other motion.

namespace floes {

struct Tow {
    double start = 0;  ///< x of the axis at t = 0, m
    double speed = 0;  ///< m/s along +x

    /// x of the axis at time `t` (s), m. From the start every time, so that nothing accumulates.
    constexpr double x(double t) const { return start + speed * t; }
};

}  // namespace floes
