#pragma once
// Dynamic positioning: thrusters that pull a structure back to its place by a PD law, as far as they can.
//
//   F = -clamp(K e + D ė, -L, L),   D = 2 ζ √(K M)
//
// in each of surge, sway and yaw by itself and in the structure's own axes, with e its offset and M its inertia. There
// is no integral part: under a steady load F the structure stays F/K aside. Thrust follows the law without delay.

#include <compare>
#include <numbers>
#include <vector>

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

// What holds a structure that gives way: springs, lines and thrusters in the plane of the water, and what they hold.
//
// The offset of the structure from where its moorings would have it is (x, z, yaw): m along the world's x and z, and
// rad about +y (+z turns to +x). Forces on it are (F_x, F_z, M_y): N, N and N m about its axis. Springs pull back with
// their stiffness times the offset, in each of the three by itself. A line pulls from its fairlead, which turns with
// the structure, towards its anchor, which does not move, with a tension by the horizontal distance of the two:
//
//   T(s) = max(0, T_0 + k (s - s_0)),   or by a curve, on which T_0 says where the line begins
//
// so that lines also resist sway and yaw by turning (T/s abeam), as they do. A line above its break load is gone. A
// turret's curve is of all lines together: towards where the turret would be, by the distance from there. Thrusters:
// structure/thrusters.hpp.

/// What the structure can do; the rest is held.
enum class FreeMotion { surge, surge_sway, all };

struct MooringLine {
    double x = 0;           ///< of the fairlead from the structure's axis, ahead, m
    double z = 0;           ///< likewise towards +z, m
    double azimuth = 0;     ///< towards which it leads, rad: 0 along +x, π/2 towards +z
    double distance = 0;    ///< s_0, horizontally from the fairlead to the anchor without an offset, m, > 0
    double pretension = 0;  ///< T_0, horizontal, without an offset, N
    double stiffness = 0;   ///< k, N/m; not used where there is a curve
    double break_load = 0;  ///< N, horizontal; 0: it never breaks

    friend auto operator<=>(const MooringLine&, const MooringLine&) = default;
};

/// A point of the tension of a line over its horizontal distance, or of a turret's force over its offset.
struct TensionPoint {
    double extension = 0;  ///< m, of a line from anywhere
    double tension = 0;    ///< N

    friend auto operator<=>(const TensionPoint&, const TensionPoint&) = default;
};

struct Moorings {
    FreeMotion free = FreeMotion::all;
    double mass = 0;             ///< kg; 0: no moorings, the structure moves as prescribed
    double gyration = 0;         ///< radius of gyration of the mass in yaw, m
    double added_surge = 0;      ///< water that moves with it, kg
    double added_sway = 0;       ///< kg
    double added_yaw = 0;        ///< kg m²
    double surge = 0;            ///< stiffness of springs, N/m
    double sway = 0;             ///< N/m
    double yaw = 0;              ///< N m/rad
    double damping = 0;          ///< linear, of the critical, in each direction, by the stiffness without an offset
    double quadratic_surge = 0;  ///< N s²/m²
    double quadratic_sway = 0;   ///< N s²/m²
    double quadratic_yaw = 0;    ///< N m s²
    std::vector<MooringLine> lines{};          ///< in addition to the springs
    std::vector<TensionPoint> curve{};         ///< of each line, both rising; empty: by its stiffness
    std::vector<TensionPoint> turret_curve{};  ///< from 0, 0, both rising; empty: there is none
    double turret = 0;                         ///< of the turret's axis from the structure's, ahead, m
    Thrusters thrusters{};

    bool give_way() const { return mass > 0; }
    /// Number of directions in which it gives way: the first ones of surge, sway and yaw.
    int directions() const { return 1 + static_cast<int>(free); }
    Vec3 inertia() const;    ///< with the water: kg, kg, kg m²
    Vec3 quadratic() const;  ///< N s²/m², N s²/m², N m s²
    /// Stiffness of springs, lines and turret without an offset, each direction by itself: N/m, N/m, N m/rad.
    Vec3 stiffness() const;
    /// 2π √(m/k) of each direction, s, with the thrusters' gain in k: without damping; infinite where nothing holds it.
    Vec3 periods() const;

    friend bool operator==(const Moorings&, const Moorings&) = default;
};

/// Tension of a line whose fairlead is `longer` m farther from its anchor than without an offset, N.
double tension(const Moorings& moorings, const MooringLine& line, double longer);

struct LinePull {
    double tension = 0;            ///< N
    Vec3 force = Vec3::Zero();     ///< on the structure: N, N, N m
    Vec2 fairlead = Vec2::Zero();  ///< from where the axis is without an offset: x and z, m
    Vec2 anchor = Vec2::Zero();    ///< likewise
};

/// Pull of a line at an offset of the structure.
LinePull pull(const Moorings& moorings, const MooringLine& line, const Vec3& offset);

/// On the structure by the turret's curve at an offset of the structure: N, N, N m.
Vec3 turret_pull(const Moorings& moorings, const Vec3& offset);

/// A point (x, z) of the structure's own axes in those of the world, turned by `yaw`.
Vec2 turned(const Vec2& point, double yaw);

}  // namespace floes
