#include "structure/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace floes {
namespace {

void check(const std::vector<ProfilePoint>& points) {
    if (points.size() < 2) {
        throw InputError(fmt::format(
            "The structure's profile has {} point(s); it needs at least 2 (height, radius) points.", points.size()));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [height, radius] = points[i];
        if (!std::isfinite(height) || !std::isfinite(radius) || radius < 0) {
            throw InputError(
                fmt::format("Point {} of the structure's profile is (height {} m, radius {} m); both must be finite "
                            "and the radius at "
                            "least 0.",
                            i, height, radius));
        }
        if (i > 0 && height < points[i - 1].height) {
            throw InputError(
                fmt::format("Point {} of the structure's profile lies at {} m, below the point before it at {} m; "
                            "heights must rise.",
                            i, height, points[i - 1].height));
        }
    }
    if (points.front().height >= 0 || points.back().height <= 0) {
        throw InputError(fmt::format(
            "The structure's profile runs from {} m to {} m; it must begin below the waterline (0) and end above it.",
            points.front().height, points.back().height));
    }
}

}  // namespace

Profile::Profile(std::vector<ProfilePoint> points) : points_(std::move(points)) {
    check(points_);
    if (waterline_radius() <= 0) {
        throw InputError(
            "The structure's profile has radius 0 at the waterline; the radius at height 0 must be above 0.");
    }
}

double Profile::radius_at(double height) const {
    double radius = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const ProfilePoint& low = points_[i];
        const ProfilePoint& high = points_[i + 1];
        if (height < low.height || height > high.height) continue;
        const double rise = high.height - low.height;
        const double here = rise > 0 ? low.radius + (height - low.height) / rise * (high.radius - low.radius)
                                     : std::max(low.radius, high.radius);
        radius = std::max(radius, here);
    }
    return radius;
}

double Profile::maximum_radius() const {
    return std::ranges::max(points_, {}, &ProfilePoint::radius).radius;
}

std::vector<Frustum> Profile::frusta() const {
    std::vector<Frustum> pieces;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const ProfilePoint& low = points_[i];
        const ProfilePoint& high = points_[i + 1];
        const bool flat = low.height == high.height;
        const bool on_axis = low.radius == 0 && high.radius == 0;
        if (!flat && !on_axis) pieces.push_back({low.height, low.radius, high.height, high.radius});
    }
    return pieces;
}

std::vector<double> Profile::wall_angles() const {
    std::vector<double> angles;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        angles.push_back(
            std::atan2(points_[i + 1].height - points_[i].height, points_[i + 1].radius - points_[i].radius));
    }
    return angles;
}

}  // namespace floes
