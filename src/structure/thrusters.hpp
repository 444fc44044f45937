#pragma once
// Dynamic positioning: thrusters that pull a structure back to its place by a PD law, as far as they can.
//
//   F = -clamp(K e + D ė, -L, L),   D = 2 ζ √(K M)
//
// in each of surge, sway and yaw by itself and in the structure's own axes, with e its offset and M its inertia. There
// is no integral part: under a steady load F the structure stays F/K aside. Thrust follows the law without delay.

#include <numbers>

#include "core/vector.hpp"

namespace floes {

struct Thrusters {
    Vec3 gain = Vec3::Zero();                  ///< K: N/m, N/m, N m/rad; 0: no thrust in that direction
    Vec3 limit = Vec3::Zero();                 ///< L: N, N, N m; 0: it has no end
    double damping = 1 / std::numbers::sqrt2;  ///< ζ, of the critical one of the gain and the inertia, >= 0

    bool any() const { return !gain.isZero(); }

    friend bool operator==(const Thrusters&, const Thrusters&) = default;
};

/// The law in one direction.
struct ThrustLaw {
    double gain = 0;     ///< K, N/m
    double damping = 0;  ///< D, N s/m
    double limit = 0;    ///< L, N; infinite: none
};

/// That of a direction, 0 to 2, of a structure of this inertia, kg or kg m².
ThrustLaw thrust_law(const Thrusters& thrusters, int direction, double inertia);

/// N, at an offset (m) and a velocity (m/s).
double thrust(const ThrustLaw& law, double offset, double velocity);

/// The velocity after `time` s under thrust alone while the offset stays, m/s. Exact: w = K e + D v falls by
/// ẇ = -(D/M) clamp(w), linearly above the limit and exponentially below it. inertia: kg.
double velocity_under_thrust(const ThrustLaw& law, double offset, double velocity, double inertia, double time);

}  // namespace floes
