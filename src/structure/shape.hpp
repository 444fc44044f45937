#pragma once
// The shape of the towed structure, as one value that answers all that others need to know of it. How it is given, a
// body of revolution about a vertical axis by its radius over height, is known in this room only.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"
#include "structure/convex_solid.hpp"

namespace floes {

/// A point of the profile: height above the waterline (m, negative below) and radius there (m).
struct ProfilePoint {
    double height = 0;
    double radius = 0;
    friend bool operator==(const ProfilePoint&, const ProfilePoint&) = default;
};

/// One number of each row in which a shape is written down, SI.
struct ShapeColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view text;  ///< what it is
    double low;
    double high;  ///< low <= number <= high
};

/// A closed surface of flat polygons, whose corners run counter-clockwise as seen from outside.
struct SurfaceMesh {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> polygons;  ///< indices of points

    /// Outward and of length 1; 0 for a polygon without area.
    Vec3 normal(const std::vector<int>& polygon) const;
};

class Shape {
  public:
    /// Table 2: breadths 1.472 and 1.228 m, draught 0.443 m, depth 0.565 m. Above the waterline a straight wall through
    /// them stands at 45°. Below, the table gives no radius: the default, 69.1°, is fitted to the paper's mean load at
    /// E = 60 MPa (docs/validation.md).
    Shape();

    /// From the keel up. The profile may flare, narrow or step (equal heights make a flat ring), so the body need not
    /// be convex. Whether it is a body is for fault() to say.
    explicit Shape(std::vector<ProfilePoint> profile);

    /// The shape as rows of numbers, for keys, files and reports.
    static constexpr std::array<ShapeColumn, 2> columns{
        {{"height", "m", "height of a profile point above the waterline", -1000, 1000},
         {"radius", "m", "radius of the structure at a profile point", 0, 1000}}};
    std::vector<std::vector<double>> rows() const;
    static Shape of_rows(const std::vector<std::vector<double>>& rows);

    /// Why it is no body that stands in the water, as "does not span the waterline; give points below and above height
    /// 0"; nothing if it is one. What follows holds for a shape without fault.
    std::optional<std::string> fault() const;

    /// The convex solids that it is made of. Throws InputError with the fault of a shape that has one.
    std::vector<ConvexSolid> solids() const;

    /// The same body of solids that are continued, straight on along their walls, for as long as that stays inside the
    /// shape: at a waist the rims at which solids meet then lie inside, where nothing can touch them.
    std::vector<ConvexSolid> overlapping_solids() const;

    /// Of the circle that it cuts out of the water, m; at a flat ring the larger. 0 if it does not span the waterline.
    double waterline_radius() const;
    double largest_radius() const;                ///< m
    double bottom() const;                        ///< height of the keel, m, below 0
    double top() const;                           ///< height of the upper end, m
    double draught() const { return -bottom(); }  ///< m

    /// Angle from the horizontal of the wall that rises from the waterline, rad: under 90 degrees it flares upward (and
    /// bends ice down), 90 degrees is vertical, over 90 degrees it narrows upward.
    double wall_angle_above_water() const;

    /// "straight, 45.0° from the horizontal (radius 0.171 m at -0.443 m to 0.736 m at +0.122 m)"; of a bent wall every
    /// part, from the bottom up.
    std::string words() const;

    /// The surface for pictures, m from the axis at the waterline: x along the tow, y up. Round parts have `sides`
    /// sides.
    SurfaceMesh mesh(int sides) const;

    /// Outline of the section along the tow through the axis: (x, height) in m, closed.
    std::vector<Vec2> section() const;

    friend bool operator==(const Shape&, const Shape&) = default;

  private:
    std::vector<ProfilePoint> profile_;
};

}  // namespace floes
