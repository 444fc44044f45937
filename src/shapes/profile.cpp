#include "shapes/profile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"

namespace floes {
namespace {

constexpr std::size_t most_points = 1000;

bool is_a_point(const ProfilePoint& point) {
    return std::isfinite(point.height) && std::isfinite(point.radius) && point.radius >= 0;
}

bool falls(const ProfilePoint& below, const ProfilePoint& above) {
    return above.height < below.height;
}

std::string part_words(const ProfilePoint& lower, const ProfilePoint& upper) {
    const double angle = std::atan2(upper.height - lower.height, std::abs(upper.radius - lower.radius)) / unit::degree;
    return fmt::format("{:.1f}° from the horizontal (radius {:.3f} m at {:+.3f} m to {:.3f} m at {:+.3f} m)", angle,
                       lower.radius, lower.height, upper.radius, upper.height);
}

}  // namespace

std::vector<std::vector<double>> Profile::rows() const {
    std::vector<std::vector<double>> rows;
    for (const ProfilePoint& point : points_) rows.push_back({point.height, point.radius});
    return rows;
}

Profile Profile::of_rows(const std::vector<std::vector<double>>& rows) {
    std::vector<ProfilePoint> profile;
    for (const std::vector<double>& row : rows) profile.push_back({row.at(0), row.at(1)});
    return Profile(std::move(profile));
}

std::optional<std::string> Profile::fault() const {
    if (points_.size() < 2) return "is not a body; give at least two [height_m, radius_m] points";
    if (points_.size() > most_points) return fmt::format("has more than {} points", most_points);
    if (!std::ranges::all_of(points_, is_a_point))
        return "has a point that is none; heights must be finite, radii finite and at least 0";
    if (std::ranges::adjacent_find(points_, falls) != points_.end())
        return "has a height that falls; give the points from the keel up";
    if (!(bottom() < 0 && top() > 0)) return "does not span the waterline; give points below and above height 0";
    if (waterline_radius() <= 0) return "has no radius at the waterline; make its radius at height 0 greater than 0";
    return std::nullopt;
}

std::vector<Frustum> Profile::solids() const {
    if (const auto wrong = fault()) throw InputError(fmt::format("The structure's profile {}.", *wrong));
    std::vector<Frustum> solids;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const ProfilePoint& low = points_[i - 1];
        const ProfilePoint& high = points_[i];
        const bool flat = low.height == high.height;
        const bool on_axis = low.radius == 0 && high.radius == 0;
        if (!flat && !on_axis) solids.push_back({low.height, low.radius, high.height, high.radius});
    }
    return solids;
}

std::vector<Frustum> Profile::overlapping_solids() const {
    std::vector<Frustum> continued = solids();
    for (Frustum& solid : continued) {
        const double slope = (solid.top_radius - solid.bottom_radius) / (solid.top_height - solid.bottom_height);
        const double low = solid.bottom_height;
        const auto wall = [&, from = solid.bottom_radius](double height) { return from + slope * (height - low); };
        const auto inside = [&](const ProfilePoint& point) {
            const double radius = wall(point.height);
            return radius >= 0 && radius <= point.radius;
        };
        for (const ProfilePoint& point : points_) {
            if (point.height <= solid.top_height) continue;
            if (!inside(point)) break;
            solid.top_height = point.height;
            solid.top_radius = wall(point.height);
        }
        for (const ProfilePoint& point : points_ | std::views::reverse) {
            if (point.height >= solid.bottom_height) continue;
            if (!inside(point)) break;
            solid.bottom_radius = wall(point.height);
            solid.bottom_height = point.height;
        }
    }
    return continued;
}

double Profile::waterline_radius() const {
    double radius = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const ProfilePoint& below = points_[i - 1];
        const ProfilePoint& above = points_[i];
        if (below.height > 0 || above.height < 0) continue;
        const double rise = above.height - below.height;
        const double here = rise > 0 ? below.radius - (above.radius - below.radius) * below.height / rise
                                     : std::max(below.radius, above.radius);
        radius = std::max(radius, here);
    }
    return radius;
}

double Profile::largest_radius() const {
    double largest = 0;
    for (const ProfilePoint& point : points_) largest = std::max(largest, point.radius);
    return largest;
}

double Profile::bottom() const {
    return points_.empty() ? 0 : points_.front().height;
}

double Profile::top() const {
    return points_.empty() ? 0 : points_.back().height;
}

double Profile::wall_angle_above_water() const {
    const auto above = std::ranges::find_if(points_, [](const ProfilePoint& point) { return point.height > 0; });
    if (above == points_.begin() || above == points_.end())
        throw InputError("The structure has no wall above the waterline.");
    const auto below = above - 1;
    return std::atan2(above->height - below->height, above->radius - below->radius);
}

std::string Profile::words() const {
    std::vector<std::string> parts;
    for (std::size_t i = 1; i < points_.size(); ++i) parts.push_back(part_words(points_[i - 1], points_[i]));
    return fmt::format("{}{}", parts.size() == 1 ? "straight, " : "", fmt::join(parts, ", then "));
}

std::vector<Vec2> Profile::side_view() const {
    std::vector<Vec2> outline;
    for (const ProfilePoint& point : points_) outline.emplace_back(point.radius, point.height);
    for (auto point = points_.rbegin(); point != points_.rend(); ++point)
        outline.emplace_back(-point->radius, point->height);
    return outline;
}

}  // namespace floes
