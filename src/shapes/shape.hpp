#pragma once
// The shape of the towed structure, as one value that answers all that others need to know of it. How it is given, as a
// body of revolution about a vertical axis by its radius over height, by a few sizes, or as convex pieces, is known in
// this module only. Axes: x ahead, y up from the waterline, z to starboard.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.hpp"
#include "shapes/convex_solid.hpp"
#include "shapes/hull_sizes.hpp"

namespace floes {

/// Sides of the polygons that stand for circles in outlines; a tenth of a percent of the area is lost.
inline constexpr int round_sides = 72;

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

/// A circle or an ellipse that stands for what the hull cuts out of the water, where water flows round it, m.
struct WaterlineEllipse {
    double x = 0;  ///< of its middle
    double z = 0;
    double half_length = 0;   ///< along x
    double half_breadth = 0;  ///< along z

    friend bool operator==(const WaterlineEllipse&, const WaterlineEllipse&) = default;
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

    /// As one of the built-in hulls.
    Shape(HullKind kind, const HullSizes& sizes);

    /// The same shape, given in another way, or with other numbers: all that is given is kept beside what is in force.
    HullKind kind() const { return kind_; }
    void set_kind(HullKind kind) { kind_ = kind; }
    const HullSizes& sizes() const { return sizes_; }
    void set_size(double HullSizes::*size, double value) { sizes_.*size = value; }
    void set_profile(const std::vector<std::vector<double>>& rows);

    /// A point of a convex piece of kind file: number of its piece, index of its part, then x, height and z in m.
    static constexpr std::array<ShapeColumn, 5> piece_columns{{{"piece", "", "number of the piece, from 0", 0, 1e6},
                                                               {"part", "", "index of its part", 0, 1e6},
                                                               {"x", "m", "ahead of the axis", -1e4, 1e4},
                                                               {"height", "m", "above the waterline", -1e4, 1e4},
                                                               {"z", "m", "to starboard", -1e4, 1e4}}};
    std::vector<std::vector<double>> piece_rows() const;
    /// Points of one piece are its corners; those inside the hull of the others are left out. Throws InputError as
    /// convex_hull() does.
    void set_pieces(const std::vector<std::vector<double>>& rows);
    /// A face of such a piece that is of another part than the piece; faces as convex_hull() orders them.
    static constexpr std::array<ShapeColumn, 3> face_columns{{{"piece", "", "number of the piece, from 0", 0, 1e6},
                                                              {"face", "", "number of its face, from 0", 0, 1e6},
                                                              {"part", "", "index of the face's part", 0, 1e6}}};
    const std::vector<std::vector<double>>& face_rows() const { return face_rows_; }
    void set_faces(const std::vector<std::vector<double>>& rows) { face_rows_ = rows; }

    /// Names of the parts of kind file, divided by commas.
    std::string& part_list() { return part_list_; }

    bool is_of_revolution() const { return floes::is_of_revolution(kind_); }

    /// Names of its parts; a body of revolution is one.
    std::vector<std::string> parts() const;

    /// The shape as rows of numbers, for keys, files and reports.
    static constexpr std::array<ShapeColumn, 2> columns{
        {{"height", "m", "height of a profile point above the waterline", -1000, 1000},
         {"radius", "m", "radius of the structure at a profile point", 0, 1000}}};
    std::vector<std::vector<double>> rows() const;     ///< as given, in force or not
    std::vector<std::vector<double>> profile() const;  ///< in force; of a hull that is none of revolution empty
    static Shape of_rows(const std::vector<std::vector<double>>& rows);

    /// Why it is no body that stands in the water, as "does not span the waterline; give points below and above height
    /// 0"; nothing if it is one. What follows holds for a shape without fault.
    std::optional<std::string> fault() const;

    /// The convex solids that it is made of. Throws InputError with the fault of a shape that has one.
    std::vector<ConvexSolid> solids() const;

    /// The same body of solids that are continued, straight on along their walls, for as long as that stays inside the
    /// shape: at a waist the rims at which solids meet then lie inside, where nothing can touch them.
    std::vector<ConvexSolid> overlapping_solids() const;

    /// Radius of the circle that it cuts out of the water, m; at a flat ring the larger. Of a hull that is none of
    /// revolution half its breadth there. 0 if it does not span the waterline.
    double waterline_radius() const;
    /// From the axis to where the waterline ends ahead, m, of the body turned by `yaw` about +y, rad.
    double waterline_ahead(double yaw = 0) const;
    double largest_radius() const;                ///< m, from the axis
    double bottom() const;                        ///< height of the keel, m, below 0
    double top() const;                           ///< height of the upper end, m
    double draught() const { return -bottom(); }  ///< m

    /// Volume that at least one of its solids holds, m³, by the lengths that they cover on lines along x through a grid
    /// of lines_across x lines_across cells. Exact for one solid, or for solids whose boxes do not meet. Where one of
    /// several is round it is the sum of theirs, as if they did not overlap.
    double volume() const;

    /// What it cuts out of the water, an outline for each piece, m in (x, z).
    std::vector<std::vector<Vec2>> waterlines() const;
    /// Ellipses of the same length and breadth, one round all pieces that meet at the waterline; at most most_ellipses.
    std::vector<WaterlineEllipse> waterline_ellipses() const;
    static constexpr std::size_t most_ellipses = 8;

    /// Angle from the horizontal of the wall that rises from the waterline, rad: under 90 degrees it flares upward (and
    /// bends ice down), 90 degrees is vertical, over 90 degrees it narrows upward.
    double wall_angle_above_water() const;

    /// "straight, 45.0° from the horizontal (radius 0.171 m at -0.443 m to 0.736 m at +0.122 m)"; of a bent wall every
    /// part, from the bottom up.
    Words words() const;

    /// The surface for pictures, m from the axis at the waterline. Round parts have `sides` sides; pieces keep faces
    /// that others hide.
    SurfaceMesh mesh(int sides) const;

    /// Outlines as seen from abeam, one for each piece: (x, height) in m, closed.
    std::vector<std::vector<Vec2>> side_view() const;

    friend bool operator==(const Shape&, const Shape&) = default;

  private:
    std::vector<ProfilePoint> in_force() const;  ///< of a body of revolution
    std::optional<std::string> fault_of_pieces() const;
    /// Of kind file.
    const Polyhedron& polyhedron(std::size_t piece) const { return std::get<Polyhedron>(file_solids_[piece].form); }
    HullSolids pieces() const;  ///< of a hull that is none of revolution

    HullKind kind_ = HullKind::profile;
    std::vector<ProfilePoint> profile_;
    HullSizes sizes_;
    std::string part_list_;                       ///< of kind file
    std::vector<ConvexSolid> file_solids_;        ///< likewise
    std::vector<std::vector<double>> face_rows_;  ///< likewise
};

// Areas of the surfaces of a structure's parts, by closed form.

/// What each part has of the structure's surface between two heights, m²: of the faces of its pieces, without what
/// lies inside other pieces, against them, or is another's as well. Exact for flat faces and for walls of legs; a
/// horizontal face counts if its height lies between the two. Of a body of revolution, which is one part, none. Throws
/// InputError with the fault of a shape that has one.
std::vector<double> part_areas(const Shape& shape, double low, double high);

}  // namespace floes
