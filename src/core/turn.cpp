#include "core/turn.hpp"

#include <cmath>

namespace floes {

namespace {

// Taylor series in r² for |r| <= pi/4: the first omitted term is below 1e-19.
double sine(double r, double r2) {
    double series = 1.0 / 355687428096000.0;  // 17!
    series = series * r2 - 1.0 / 1307674368000.0;
    series = series * r2 + 1.0 / 6227020800.0;
    series = series * r2 - 1.0 / 39916800.0;
    series = series * r2 + 1.0 / 362880.0;
    series = series * r2 - 1.0 / 5040.0;
    series = series * r2 + 1.0 / 120.0;
    series = series * r2 - 1.0 / 6.0;
    return r + r * r2 * series;
}

double cosine(double r2) {
    double series = 1.0 / 20922789888000.0;  // 16!
    series = series * r2 - 1.0 / 87178291200.0;
    series = series * r2 + 1.0 / 479001600.0;
    series = series * r2 - 1.0 / 3628800.0;
    series = series * r2 + 1.0 / 40320.0;
    series = series * r2 - 1.0 / 720.0;
    series = series * r2 + 1.0 / 24.0;
    return 1.0 - r2 * (0.5 - r2 * series);
}

}  // namespace

Turn turn_of(double yaw) {
    constexpr double quarters_per_radian = 0x1.45f306dc9c883p-1;
    constexpr double quarter_high = 0x1.921fb544p+0;  // pi/2 in 33 bits: its small multiples are exact
    constexpr double quarter_low = 0x1.0b4611a626331p-34;
    const double quarters = std::floor(yaw * quarters_per_radian + 0.5);
    const double r = (yaw - quarters * quarter_high) - quarters * quarter_low;
    const double r2 = r * r;
    const double c = cosine(r2);
    const double s = sine(r, r2);
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

}  // namespace floes
