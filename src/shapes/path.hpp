#pragma once
// Where the structure goes, if not straight ahead at one speed: legs of heading, speed and time, or a table of places.

#include <compare>
#include <vector>

#include "core/vector.hpp"

namespace floes {

/// Headings and turns count from +x towards +z, as directions of current and wind do.
struct PathLeg {
    double heading = 0;  ///< at its beginning, rad
    double speed = 0;    ///< m/s, >= 0
    double time = 0;     ///< how long, s, > 0
    double turn = 0;     ///< rad/s: the heading changes so, along an arc of the radius speed / turn

    friend auto operator<=>(const PathLeg&, const PathLeg&) = default;
};

/// A place from the start, at a time.
struct PathPoint {
    double time = 0;  ///< s
    double x = 0;     ///< m
    double z = 0;     ///< m
    double yaw = 0;   ///< rad about +y: +z turns to +x

    friend auto operator<=>(const PathPoint&, const PathPoint&) = default;
};

enum class PathOf { structure, ice };    ///< whose legs they are: ice drifts past a structure that stands
enum class PathBow { ahead, unturned };  ///< whether the structure turns with the heading

struct Path {
    std::vector<PathLeg> legs{};
    PathOf of = PathOf::structure;
    PathBow bow = PathBow::unturned;
    double ramp = 0;  ///< s at the beginning of each leg in which speed and heading change evenly; the first from rest
    std::vector<PathPoint> table{};  ///< in place of legs; between two points speed and turning are constant

    bool any() const { return !legs.empty() || !table.empty(); }

    friend bool operator==(const Path&, const Path&) = default;
};

/// A pose with its velocity in the step that led there.
struct PathPlace {
    PlanarPose pose{};             ///< from the start
    Vec2 velocity = Vec2::Zero();  ///< along x and z, m/s
    double turning = 0;            ///< about +y, rad/s
};

/// The places at the ends of `steps` steps of `step` s, and the start before them. After its last leg or point the
/// structure stands. From one leg or point to the next the heading turns by the shorter way, whatever the multiple of a
/// full turn by which it is written. Where a heading turns, a step is the tangent in its middle: an arc's radius is
/// right to (turn step)² / 24 of itself.
std::vector<PathPlace> places_of(const Path& path, double step, int steps);

/// Until its last leg or point ends, s.
double duration_of(const Path& path);

/// Whether the structure moves in the last leg or to the last point, and stands only because the path ends.
bool ends_moving(const Path& path);

/// How far it goes along its way in all, m.
double way_of(const std::vector<PathPlace>& places, double step);

// The prescribed surge of the structure: constant speed from a starting point, no other motion.

struct Tow {
    double start = 0;  ///< x of the axis at t = 0, m
    double speed = 0;  ///< m/s along +x

    /// x of the axis at time `t` (s), m. From the start every time, so that nothing accumulates.
    constexpr double x(double t) const { return start + speed * t; }
};

}  // namespace floes
