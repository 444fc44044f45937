#pragma once
// What holds a structure that gives way: hanging cables, thrusters, springs and lines, and how it moves on them.

#include <array>
#include <cmath>
#include <compare>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "core/vector.hpp"

namespace floes {

// A mooring line that hangs in the water and may lie on the bottom, in its closed form.
//
// An elastic cable of length L, wet weight w per length and stiffness EA hangs from its upper end, with the pull H
// along the water and V down, to an anchor that is x away and z lower (Jonkman, NREL/TP-500-41958, Eqs. 2-35 to 2-38).
// With V below wL the part L_B = L - V/w lies on the bottom, where friction of the coefficient C takes C w of H per
// length:
//
//   x = L_B + (H/w) asinh(V/H) + HL/EA + (C w/2EA) [-L_B² + (L_B - H/Cw) max(L_B - H/Cw, 0)]
//   z = (H/w) [√(1 + (V/H)²) - 1] + V²/(2EAw)
//
// and without contact with the bottom
//
//   x = (H/w) [asinh(V/H) - asinh((V - wL)/H)] + HL/EA
//   z = (H/w) [√(1 + (V/H)²) - √(1 + ((V - wL)/H)²)] + (VL - wL²/2)/EA
//
// A line that is long enough hangs straight down, H = 0, and the rest of it lies on the bottom.

/// SI.
struct Cable {
    double length = 0;     ///< L, unstretched, m
    double weight = 0;     ///< w, in water, N/m, > 0
    double stiffness = 0;  ///< EA, N, > 0
    double friction = 0;   ///< C, of the bottom, >= 0

    friend bool operator==(const Cable&, const Cable&) = default;
};

/// Of a cable at its upper end, and what lies.
struct CablePull {
    double along = 0;    ///< H, N
    double down = 0;     ///< V, N
    double resting = 0;  ///< L_B, m
    double anchor = 0;   ///< tension at the lower end, N

    double tension() const { return std::hypot(along, down); }  ///< at the upper end, N
};

/// With the upper end x >= 0 m beside the anchor and z > 0 m above it. To 1e-10.
CablePull hang(const Cable& cable, double x, double z);

/// Where it runs, as hang() has it: from its upper end to the anchor in `parts` of equal length, (x from the anchor, z
/// above it), m. What lies is drawn evenly from the anchor to where it leaves the bottom.
std::vector<Vec2> course(const Cable& cable, double x, double z, int parts);

// Dynamic positioning: thrusters that pull a structure back to its place by a PD law, as far as they can.
//
//   F = -clamp(K e + D ė, -L, L),   D = 2 ζ √(K M)
//
// in each of surge, sway and yaw by itself and in the structure's own axes, with e its offset and M its inertia. There
// is no integral part: under a steady load F the structure stays F/K aside. Thrust follows the law without delay.

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
// The offset of the structure from where its moorings would have it has six parts, in the order of Motion: m along the
// world's x and z, rad about +y (+z turns to +x), m up, rad about +z (lifts the bow) and about +x (heels to starboard),
// as in StructurePose. Forces on it are likewise N and N m about its reference point, its axis at the height of the
// calm water; of the turns they are small-angle ones. Springs pull back with their stiffness times the offset, in each
// of surge, sway and yaw by itself. A line pulls from its fairlead at the height of the water, which turns with the
// structure, towards its anchor, which does not move, with a tension by the horizontal distance of the two:
//
//   T(s) = max(0, T_0 + k (s - s_0)),   or by a curve, on which T_0 says where the line begins
//
// so that lines also resist sway and yaw by turning (T/s abeam), as they do. A line above its break load is gone. A
// turret's curve is of all lines together: towards where the turret would be, by the distance from there. Lines of a
// turret hang from a table that keeps its heading while the structure turns about it: they pull at the turret's axis,
// and hold the heading by its arm alone. Thrusters stand above.

enum class Motion { surge, sway, yaw, heave, pitch, roll };
inline constexpr std::array<std::string_view, 6> motion_names{"surge", "sway", "yaw", "heave", "pitch", "roll"};
constexpr std::size_t at(Motion motion) {
    return static_cast<std::size_t>(motion);
}

struct MooringLine {
    double x = 0;           ///< of the fairlead from the structure's axis, or from that of its turret, ahead, m
    double z = 0;           ///< likewise towards +z, m
    double azimuth = 0;     ///< towards which it leads, rad: 0 along +x, π/2 towards +z
    double distance = 0;    ///< s_0, horizontally from the fairlead to the anchor without an offset, m, > 0
    double pretension = 0;  ///< T_0, horizontal, without an offset, N
    double stiffness = 0;   ///< k, N/m; not used where there is a curve
    double break_load = 0;  ///< N, horizontal; 0: it never breaks

    friend auto operator<=>(const MooringLine&, const MooringLine&) = default;
};

/// A line with a weight, from a fairlead under or over the water to an anchor on the bottom: as above.
struct HangingLine {
    Vec3 fairlead = Vec3::Zero();  ///< in the structure's axes from the reference point, or the turret's axis, m
    double azimuth = 0;            ///< towards which it leads, rad: 0 along +x, π/2 towards +z
    double distance = 0;           ///< horizontally from the fairlead to the anchor without an offset, m, > 0
    double depth = 0;              ///< of the anchor below the calm water, m, below the fairlead
    Cable cable{};
    double break_load = 0;  ///< N, at the fairlead; 0: it never breaks

    friend bool operator==(const HangingLine&, const HangingLine&) = default;
};

/// A point of the tension of a line over its horizontal distance, or of a turret's force over its offset.
struct TensionPoint {
    double extension = 0;  ///< m, of a line from anywhere
    double tension = 0;    ///< N

    friend auto operator<=>(const TensionPoint&, const TensionPoint&) = default;
};

/// About whose axis the structure turns freely while what is moored to it keeps its heading.
struct Turret {
    bool lines = false;                 ///< whether lines and hanging lines hang from it; else from the structure
    std::vector<TensionPoint> curve{};  ///< of a whole mooring, from 0, 0, both rising; empty: there is none
    double ahead = 0;                   ///< its axis from the structure's, m
    double friction = 0;                ///< moment of its bearing against turning, N m

    bool any() const { return lines || !curve.empty(); }

    friend bool operator==(const Turret&, const Turret&) = default;
};

struct Moorings {
    std::array<bool, 6> free{true, true, true, false, false, false};  ///< by Motion; the others are held
    double mass = 0;            ///< kg; 0: no moorings, the structure moves as prescribed
    double height = 0;          ///< of its centre, which is on the axis, over the calm water, m
    double gyration = 0;        ///< radius of gyration of the mass in yaw, m
    double pitch_gyration = 0;  ///< about its centre, m
    double roll_gyration = 0;   ///< likewise, m
    /// Water that moves with it, in each motion by itself: kg, kg m².
    std::array<double, 6> added{};
    /// In addition, in the order and the axes of radiation programs about the reference point, six rows each or none:
    /// kg, kg m, kg m², and over s.
    std::vector<std::vector<double>> added_mass{};
    std::vector<std::vector<double>> radiation_damping{};
    double surge = 0;    ///< stiffness of springs, N/m
    double sway = 0;     ///< N/m
    double yaw = 0;      ///< N m/rad
    double damping = 0;  ///< linear, of the critical, in each direction, by the stiffness without an offset
    std::array<double, 6> quadratic{};   ///< by Motion, N s²/m² and N m s²
    std::vector<MooringLine> lines{};    ///< in addition to the springs
    std::vector<HangingLine> hanging{};  ///< likewise
    std::vector<TensionPoint> curve{};   ///< of each line, both rising; empty: by its stiffness
    Turret turret{};
    Thrusters thrusters{};

    bool give_way() const { return mass > 0; }
    bool is_free(Motion motion) const { return free.at(at(motion)); }
    std::vector<int> directions() const;  ///< in which it gives way, by Motion, rising
    /// Whether it heaves, pitches or rolls, so that the water's stiffness matters.
    bool floats() const { return is_free(Motion::heave) || is_free(Motion::pitch) || is_free(Motion::roll); }
    Mat6 inertia() const;    ///< with the water about the reference point: kg, kg m, kg m²
    Mat6 radiation() const;  ///< damping by waves, floes' axes: kg/s, kg m/s, kg m²/s
    std::size_t line_count() const { return lines.size() + hanging.size(); }
    /// Stiffness of springs, lines and turret without an offset: N/m, N, N m. Of lines that do not hang each
    /// direction by itself.
    Mat6 stiffness() const;
    /// 2π √(m/k), s, of surge, sway or yaw by itself, with the thrusters' gain in k: without damping; infinite where
    /// nothing holds it.
    double period(Motion motion) const;
    /// The same with the thrusters' and the water's.
    Mat6 held(const Mat6& water) const;

    friend bool operator==(const Moorings&, const Moorings&) = default;
};

/// Tension of a line whose fairlead is `longer` m farther from its anchor than without an offset, N. Throws
/// MemberFailure past the rows of its curve, unless it breaks before their end.
double tension(const Moorings& moorings, const MooringLine& line, double longer);

struct LinePull {
    double tension = 0;            ///< N; of a hanging line at the fairlead
    Vec6 force = Vec6::Zero();     ///< on the structure: N, N m
    Vec3 fairlead = Vec3::Zero();  ///< from where the reference point is without an offset, m
    Vec3 anchor = Vec3::Zero();    ///< likewise
};

/// Pull of a line at an offset of the structure.
LinePull pull(const Moorings& moorings, const MooringLine& line, const Vec6& offset);
/// Throws MemberFailure where the fairlead is no longer above the anchor.
LinePull pull(const HangingLine& line, const Vec6& offset, const Turret& turret = {});
/// Of all lines by their numbers, hanging ones last.
LinePull pull(const Moorings& moorings, std::size_t number, const Vec6& offset);

/// N, of a line by its number; 0: it never breaks.
double break_load(const Moorings& moorings, std::size_t number);

bool has_lines_that_break(const Moorings& moorings);

/// Where a line of that number runs between these ends (m), from its fairlead: straight, or hanging.
std::vector<Vec3> course(const Moorings& moorings, std::size_t number, const Vec3& fairlead, const Vec3& anchor);

/// A force or an offset in the plane of the water, by Motion: surge, sway and yaw.
Vec6 in_plane(const Vec3& of);

/// On the structure by the turret's curve at an offset of the structure: N, N m. Throws MemberFailure past its rows.
Vec6 turret_pull(const Moorings& moorings, const Vec6& offset);

/// A way in which a floating structure swings by itself, without damping.
struct NaturalMode {
    double period = 0;              ///< 2π √(m/k), s; infinite where nothing holds it, NaN where it turns over
    Motion motion = Motion::surge;  ///< of which it has most energy; yaw of what turns about a turret
};

/// Whether only the load itself holds that mode: the structure turns about a turret ahead of its axis until it lies
/// with the load, as a weathervane.
bool weathervanes(const Moorings& moorings, const NaturalMode& mode);

/// All natural modes, one for each direction in which it gives way, by Motion. `water`: its stiffness
/// (water_stiffness() in shapes/hydrostatics.hpp). The inertia is positive definite.
std::vector<NaturalMode> natural_modes(const Moorings& moorings, const Mat6& water);

/// Of those with a finite period the one with the longest; none where there is none.
std::optional<NaturalMode> longest_mode(const Moorings& moorings, const Mat6& water);

/// A matrix of a radiation program (x ahead, y to port, z up; surge, sway, heave, roll, pitch, yaw) in floes' order and
/// axes, in which sway and pitch change sign. The only place that knows.
Mat6 from_hydrodynamic_axes(const std::vector<std::vector<double>>& rows);

/// A point (x, z) of the structure's own axes in those of the world, turned by `yaw`.
Vec2 turned(const Vec2& point, double yaw);

/// How far the turret, without one the structure's axis, is from where it would be without an offset, m. Of offsets of
/// the structure's axis as histories have them: `surge`, positive against the tow, and `sway`, m; `yaw`, rad.
double horizontal_offset(const Moorings& moorings, double surge, double sway, double yaw);

}  // namespace floes
