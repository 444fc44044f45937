#include "structure/convex_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floes {
namespace {

double frustum_volume(double height, double a, double b) {
    return std::numbers::pi / 3 * height * (a * a + a * b + b * b);
}

template <class Points>
void add_ring(Points& points, double radius, int sides, auto point_at) {
    for (int side = 0; side < (radius > 0 ? sides : 1); ++side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        points.push_back(point_at(radius * std::cos(angle), radius * std::sin(angle)));
    }
}

}  // namespace

std::optional<std::string> Frustum::fault() const {
    if (!(top_height > bottom_height))
        return fmt::format("the height of a frustum is {}; it must be above 0 m", top_height - bottom_height);
    if (!(bottom_radius >= 0 && top_radius >= 0))
        return fmt::format("the smaller radius of a frustum is {}; it must be at least 0 m",
                           std::fmin(bottom_radius, top_radius));
    if (!(bottom_radius + top_radius > 0)) return "the larger radius of a frustum is 0; it must be above 0 m";
    return std::nullopt;
}

Vec3 Frustum::farthest(const Vec3& direction) const {
    const double across = std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
    const double bottom = bottom_radius * across + bottom_height * direction.y();
    const double top = top_radius * across + top_height * direction.y();
    const double radius = top > bottom ? top_radius : bottom_radius;
    const double height = top > bottom ? top_height : bottom_height;
    if (across == 0) return {radius, height, 0};
    return {radius * direction.x() / across, height, radius * direction.z() / across};
}

Frustum Frustum::inside(double depth) const {
    const double rise = top_height - bottom_height;
    const double spread = top_radius - bottom_radius;
    const double inset = depth * std::hypot(rise, spread) / rise;  // along the radius
    Frustum core = *this;
    core.bottom_radius = std::max(0.0, bottom_radius - inset);
    core.top_radius = std::max(0.0, top_radius - inset);
    // Where the wall meets the axis the tip moves along it.
    if (bottom_radius < inset) core.bottom_height += std::min(rise, (inset - bottom_radius) * rise / std::abs(spread));
    if (top_radius < inset) core.top_height -= std::min(rise, (inset - top_radius) * rise / std::abs(spread));
    return core;
}

double Frustum::radius_at(double height) const {
    const double share = (height - bottom_height) / (top_height - bottom_height);
    return bottom_radius + share * (top_radius - bottom_radius);
}

std::optional<std::string> ConvexSolid::fault() const {
    if (const auto* round = std::get_if<Frustum>(&form)) return round->fault();
    if (std::get<Polyhedron>(form).empty()) return "a solid of the structure has all its points in one plane";
    return std::nullopt;
}

Vec3 ConvexSolid::farthest(const Vec3& direction) const {
    return std::visit([&](const auto& one) { return one.farthest(direction); }, form);
}

ConvexSolid ConvexSolid::inside(double depth) const {
    ConvexSolid core = *this;
    if (auto* round = std::get_if<Frustum>(&core.form))
        *round = round->inside(depth);
    else if (Polyhedron thin = std::get<Polyhedron>(form).inside(depth); !thin.empty())
        core.form = std::move(thin);
    return core;
}

ConvexSolid ConvexSolid::scaled(double factor) const {
    ConvexSolid other = *this;
    other.place *= factor;
    std::visit([&](auto& one) { one = one.scaled(factor); }, other.form);
    return other;
}

int ConvexSolid::part_at(const Vec3& point) const {
    if (face_parts.empty()) return part;
    const std::vector<Plane>& planes = std::get<Polyhedron>(form).planes;
    const Vec3 here = point - place;
    const auto nearest = std::ranges::max_element(planes, {}, [&](const Plane& one) { return one.height(here); });
    return face_parts[static_cast<std::size_t>(nearest - planes.begin())];
}

double ConvexSolid::volume() const {
    if (const auto* round = std::get_if<Frustum>(&form))
        return frustum_volume(round->top_height - round->bottom_height, round->bottom_radius, round->top_radius);
    return std::get<Polyhedron>(form).volume();
}

double ConvexSolid::volume_below(double height) const {
    const double level = height - place.y();
    const auto* round = std::get_if<Frustum>(&form);
    if (round == nullptr) return std::get<Polyhedron>(form).cut({Vec3::UnitY(), level}).volume();
    if (level <= round->bottom_height) return 0;
    if (level >= round->top_height) return volume();
    return frustum_volume(level - round->bottom_height, round->bottom_radius, round->radius_at(level));
}

std::vector<Vec2> ConvexSolid::section(double height, int sides) const {
    const double level = height - place.y();
    std::vector<Vec2> outline;
    if (const auto* round = std::get_if<Frustum>(&form)) {
        if (level < round->bottom_height || level > round->top_height) return {};
        add_ring(outline, round->radius_at(level), sides, [](double x, double z) { return Vec2(x, z); });
    } else {
        outline = std::get<Polyhedron>(form).section(level);
    }
    for (Vec2& point : outline) point += Vec2(place.x(), place.z());
    return outline;
}

std::vector<Vec3> ConvexSolid::corners(int sides) const {
    std::vector<Vec3> points;
    if (const auto* round = std::get_if<Frustum>(&form)) {
        for (const auto& [radius, height] :
             {std::pair{round->bottom_radius, round->bottom_height}, std::pair{round->top_radius, round->top_height}})
            add_ring(points, radius, sides, [&](double x, double z) { return Vec3(x, height, z); });
    } else {
        points = std::get<Polyhedron>(form).corners;
    }
    for (Vec3& point : points) point += place;
    return points;
}

}  // namespace floes
