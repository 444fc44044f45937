#include "shapes/hull_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace floes {
namespace {

/// To whole nanometres: tangents differ in their last bit from one processor to another.
double rounded(double length) {
    return std::round(length * 1e9) / 1e9;
}

double cotangent(double angle) {
    return std::abs(angle - 0.5 * std::numbers::pi) < 1e-9 ? 0 : 1 / std::tan(angle);
}

enum ShipPart { bow, stern, port, starboard, bottom };

/// The planes of a ship or a barge, with the part that each is of.
struct Side {
    Plane plane;
    int part;
};

Plane plane_through(const Vec3& point, const Vec3& normal) {
    const Vec3 unit = normal.normalized();
    return {unit, unit.dot(point)};
}

/// The two sides of a wedge that points along `ahead` (+1 or -1) and meets the water at |x| = L/2.
void add_wedge(std::vector<Side>& sides, const HullSizes& s, double ahead, int part) {
    for (const double side : {-1.0, 1.0})
        sides.push_back({plane_through({ahead * 0.5 * s.length, 0, 0},
                                       {ahead * std::sin(s.entrance), -std::sin(s.entrance) * cotangent(s.stem),
                                        side * std::cos(s.entrance)}),
                         part});
}

void add_end(std::vector<Side>& sides, const HullSizes& s, double ahead, double angle, int part) {
    sides.push_back({plane_through({ahead * 0.5 * s.length, 0, 0}, {ahead, -cotangent(angle), 0}), part});
}

std::vector<Side> sides_of(HullKind kind, const HullSizes& s) {
    std::vector<Side> sides;
    for (const double side : {-1.0, 1.0})
        sides.push_back(
            {plane_through({0, 0, side * 0.5 * s.beam}, {0, -cotangent(s.flare), side}), side < 0 ? port : starboard});
    sides.push_back({{Vec3::UnitY(), s.freeboard}, bottom});
    sides.push_back({{-Vec3::UnitY(), s.draught}, bottom});
    if (kind == HullKind::barge) {
        add_end(sides, s, 1, s.stem, bow);
        add_end(sides, s, -1, s.stem, stern);
        return sides;
    }
    add_wedge(sides, s, 1, bow);
    if (kind == HullKind::drillship)
        add_wedge(sides, s, -1, stern);
    else
        add_end(sides, s, -1, 0.5 * std::numbers::pi, stern);
    return sides;
}

Polyhedron ship_body(const std::vector<Side>& sides) {
    std::vector<Plane> planes;
    for (const Side& side : sides) planes.push_back(side.plane);
    std::vector<Vec3> corners = intersection(planes, Vec3::Zero()).corners;
    for (Vec3& corner : corners) corner = corner.unaryExpr(&rounded);
    return convex_hull(corners);
}

ConvexSolid ship(HullKind kind, const HullSizes& sizes) {
    const std::vector<Side> sides = sides_of(kind, sizes);
    Polyhedron body = ship_body(sides);
    std::vector<int> parts;
    for (const Plane& face : body.planes) {
        const auto likeness = [&](const Side& side) { return side.plane.normal.dot(face.normal); };
        parts.push_back(std::ranges::max_element(sides, {}, likeness)->part);
    }
    return ConvexSolid(std::move(body), 0, std::move(parts));
}

std::optional<std::string> ship_fault(HullKind kind, const HullSizes& s) {
    const Polyhedron body = ship_body(sides_of(kind, s));
    const auto [low, high] = std::ranges::minmax(body.corners, {}, [](const Vec3& corner) { return corner.y(); });
    constexpr double rounding = 1e-6;  // of the depth
    const double slack = rounding * (s.draught + s.freeboard);
    if (low.y() > -s.draught + slack)
        return fmt::format("closes at a depth of {:.4g} m, above its keel; take a smaller draught or steeper walls",
                           -low.y());
    if (high.y() < s.freeboard - slack)
        return fmt::format("closes at a height of {:.4g} m, below its deck; take a smaller freeboard", high.y());
    const double bow_length = 0.5 * s.beam * cotangent(s.entrance) * (kind == HullKind::drillship ? 2 : 1);
    if (kind != HullKind::barge && bow_length > s.length)
        return fmt::format("is shorter than its wedge of {:.4g} m; take a larger hull.entrance_deg", bow_length);
    return std::nullopt;
}

}  // namespace

std::vector<double HullSizes::*> needed_sizes(HullKind kind) {
    using S = HullSizes;
    switch (kind) {
        case HullKind::cylinder:
            return {&S::diameter, &S::draught, &S::freeboard};
        case HullKind::cone_up:
        case HullKind::cone_down:
            return {&S::diameter, &S::wall, &S::draught, &S::freeboard};
        case HullKind::four_legs:
            return {&S::diameter, &S::spacing, &S::draught, &S::freeboard};
        case HullKind::wedge_bow:
        case HullKind::drillship:
            return {&S::length, &S::beam, &S::draught, &S::freeboard, &S::stem, &S::entrance};
        case HullKind::barge:
            return {&S::length, &S::beam, &S::draught, &S::freeboard, &S::stem};
        case HullKind::profile:
        case HullKind::file:
            break;
    }
    return {};
}

std::optional<std::string> fault_of(HullKind kind, const HullSizes& sizes) {
    for (double HullSizes::*const size : needed_sizes(kind))
        if (!(sizes.*size > 0))
            return fmt::format("needs {}; give it above 0",
                               std::ranges::find(hull_size_keys, size, &HullSizeKey::size)->path);
    if (kind == HullKind::four_legs && sizes.spacing <= sizes.diameter)
        return "has legs that touch; make hull.spacing_m larger than hull.diameter_m";
    if (kind == HullKind::cone_up || kind == HullKind::cone_down) {
        for (const ProfilePoint& point : profile_of(kind, sizes))
            if (!(point.radius > 0))
                return fmt::format("comes to a point before the height {:.4g} m; take a steeper hull.wall_deg",
                                   point.height);
    }
    return is_ship(kind) ? ship_fault(kind, sizes) : std::nullopt;
}

std::vector<ProfilePoint> profile_of(HullKind kind, const HullSizes& s) {
    const double radius = 0.5 * s.diameter;
    const double slope = kind == HullKind::cylinder ? 0 : (kind == HullKind::cone_down ? 1 : -1) * cotangent(s.wall);
    return {{-s.draught, rounded(radius - slope * s.draught)}, {s.freeboard, rounded(radius + slope * s.freeboard)}};
}

HullSolids solids_of(HullKind kind, const HullSizes& s) {
    if (kind != HullKind::four_legs) return {{"bow", "stern", "port", "starboard", "bottom and deck"}, {ship(kind, s)}};
    HullSolids legs;
    const double side = 0.5 * s.spacing;
    const Frustum leg{-s.draught, 0.5 * s.diameter, s.freeboard, 0.5 * s.diameter};
    for (const double ahead : {1.0, -1.0}) {
        for (const double across : {-1.0, 1.0}) {
            legs.solids.emplace_back(leg, Vec3(ahead * side, 0, across * side), static_cast<int>(legs.parts.size()));
            legs.parts.push_back(fmt::format("{} {}", ahead > 0 ? "fore" : "aft", across < 0 ? "port" : "starboard"));
        }
    }
    return legs;
}

Words words_of(HullKind kind, const HullSizes& s) {
    const auto degrees = [](double angle) { return Words::of("{:.4g}°", angle / unit::degree); };
    if (kind == HullKind::four_legs)
        return Words::of("four vertical legs of {:.4g} m in diameter, {:.4g} m apart, draught {:.4g} m", s.diameter,
                         s.spacing, s.draught);
    const Words size = Words::of("{:.4g} m x {:.4g} m at the waterline, draught {:.4g} m", s.length, s.beam, s.draught);
    if (kind == HullKind::barge)
        return Words::of("barge, {}, ends {} and sides {} from the horizontal", size, degrees(s.stem),
                         degrees(s.flare));
    return Words::of("{}, {}, stem {} and sides {} from the horizontal, half entrance angle {}",
                     kind == HullKind::drillship ? "drillship" : "ship with a wedge bow", size, degrees(s.stem),
                     degrees(s.flare), degrees(s.entrance));
}

}  // namespace floes
