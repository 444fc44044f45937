#pragma once
// A periodic box for the sampler: what is known of hard squares holds far from any wall.

#include "arrangement/crowd.hpp"

namespace floes {

/// Opposite edges meet.
struct PeriodicBox {
    double low_x = 0;
    double low_z = 0;
    double length = 0;
    double breadth = 0;
    static constexpr bool periodic = true;

    bool admits(const Rectangle&, double, double, Turn) const { return true; }
    bool admits(Corners, double, double) const { return true; }
    void into(double& x, double& z) const {
        fold(x, low_x, length);
        fold(z, low_z, breadth);
    }
    void nearest(double& dx, double& dz) const {
        fold(dx, -0.5 * length, length);
        fold(dz, -0.5 * breadth, breadth);
    }

  private:
    static void fold(double& value, double low, double period) {
        if (value < low) value += period;
        if (value >= low + period) value -= period;
    }
};

}  // namespace floes
