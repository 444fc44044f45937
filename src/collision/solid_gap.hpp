#pragma once
// How far a prism of ice is from a convex solid of the structure, how deep in it, and where: between cores that lie
// inside both by a margin. With f(n) = min n·p - max n·c over the points p of the one core and c of the other, the
// signed distance of the two is the largest f over all unit vectors n, and margins are taken off it. So faces and walls
// are exact, and corners and rims are rounded by their margin, as Bullet has them.

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "core/vector.hpp"
#include "shapes/convex_solid.hpp"
#include "shapes/elements.hpp"

namespace floes {

/// What a prism is without its margin, in its own axes, m.
struct PrismCore {
    Outline corners;  ///< x and z
    double half_thickness = 0;
    double margin = 0;
};

/// Corners of such a core, in the axes of a solid.
class PrismCorners {
  public:
    /// The core's centre, and its axes as columns. The core must stay where it is.
    PrismCorners(const PrismCore& core, const Vec3& centre, const Mat3& axes);

    const Vec3& centre() const { return centre_; }
    Vec3 face_normal(std::size_t face) const;  ///< outward; of the two flat faces, then of the polygon's edges
    std::size_t faces() const { return 2 + core_->corners.size(); }
    Vec3 edge_direction(std::size_t edge) const;  ///< of the thickness, then of the polygon's edges

    Vec3 nearest(const Vec3& direction) const;  ///< the corner that lies least far along it
    /// The same; of several, to a nanometre, their middle, or the point between the outermost two that lies in the
    /// plane of the direction and the y axis.
    Vec3 middle_of_nearest(const Vec3& direction, bool on_axis) const;
    void shift(const Vec3& by);

    /// Of each corner of the polygon the upper one, then the lower.
    std::span<const Vec3> corners() const { return {corners_.data(), count_}; }

  private:
    const PrismCore* core_;
    Vec3 centre_;
    Mat3 axes_;
    std::size_t count_;
    std::array<Vec3, 2 * most_corners> corners_;
};

/// The core of a solid, in its own axes.
class SolidCore {
  public:
    explicit SolidCore(const ConvexSolid& core);

    struct Edge {
        Vec3 end, along;
        Vec3 left, right;  ///< normals of its faces, along ~ left × right
        double length;
    };

    const Frustum* round() const { return std::get_if<Frustum>(&form_); }
    const Polyhedron& flat() const { return std::get<Polyhedron>(form_); }
    std::span<const Edge> edges() const { return edges_; }  ///< of a polyhedron
    Vec3 farthest(const Vec3& direction) const;
    bool holds(const Vec3& point) const;  ///< to a nanometre

  private:
    std::variant<Frustum, Polyhedron> form_;
    std::vector<Edge> edges_;
};

/// Lengths in m, in the axes of the solid.
struct SolidGap {
    double gap = 0;                ///< between the cores; negative: how far the prism must go along the normal
    Vec3 normal = Vec3::Zero();    ///< unit, from the solid to the prism
    Vec3 on_prism = Vec3::Zero();  ///< of the prism's core, where it is nearest or deepest
};

/// Where the gap is more than `enough`, it may be less than it is, but more than that, and the rest is not told.
SolidGap gap_between(const SolidCore& solid, const PrismCorners& prism, double enough);

}  // namespace floes
