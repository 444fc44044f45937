#pragma once
// A body of revolution about the vertical axis, by its radius over height.

#include <optional>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {

/// A point of the profile: height above the waterline (m, negative below) and radius there (m).
struct ProfilePoint {
    double height = 0;
    double radius = 0;
    friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

class Profile {
  public:
    /// From the keel up. It may flare, narrow or step (equal heights make a flat ring), so the body need not be convex.
    explicit Profile(std::vector<ProfilePoint> points) : points_(std::move(points)) {}

    /// As rows of height and radius.
    std::vector<std::vector<double>> rows() const;
    static Profile of_rows(const std::vector<std::vector<double>>& rows);

    /// Why it is no body that stands in the water; nothing if it is one. What follows holds without fault.
    std::optional<std::string> fault() const;

    /// Throws InputError with the fault of a profile that has one.
    std::vector<Frustum> solids() const;
    /// Those, continued straight on along their walls for as long as that stays inside.
    std::vector<Frustum> overlapping_solids() const;

    double waterline_radius() const;        ///< m; at a flat ring the larger
    double largest_radius() const;          ///< m
    double bottom() const;                  ///< m
    double top() const;                     ///< m
    double wall_angle_above_water() const;  ///< rad, from the horizontal
    std::string words() const;
    std::vector<Vec2> side_view() const;
    const std::vector<ProfilePoint>& points() const { return points_; }

    friend bool operator==(const Profile&, const Profile&) = default;

  private:
    std::vector<ProfilePoint> points_;
};

}  // namespace floes
