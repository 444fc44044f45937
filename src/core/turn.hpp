#pragma once
// Cosine and sine of a yaw from additions and multiplications only. A C library may choose its sin by processor (glibc
// has one with fused multiply-add and one without), and a Monte Carlo chain that differs in a single last bit soon
// becomes a different chain.

namespace floes {

struct Turn {
    double cos = 1;
    double sin = 0;
};

/// yaw in rad, |yaw| < 1e6. Absolute error below 3e-16 for |yaw| <= 2 pi.
Turn turn_of(double yaw);

}  // namespace floes
