#pragma once
// Prisms: convex polygons of even thickness, in their own axes. y runs along the thickness; corners lie in (x, z) about
// the centre of mass. A box is one with four corners.

#include <array>
#include <vector>

#include "shapes/elements.hpp"

namespace floes {

class StateArchive;

using Triple = std::array<double, 3>;

inline Triple operator-(const Triple& a, const Triple& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Triple operator+(const Triple& a, const Triple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Triple operator*(double s, const Triple& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

inline Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct PrismEdge {
    Corner normal;      ///< outward
    double half_width;  ///< of the polygon along it, m
    double middle;      ///< of that width, from the centre of mass along the normal
};

struct PrismShape {
    Outline corners;  ///< m
    std::vector<PrismEdge> edges;
    double inner_radius = 0;    ///< of the circle round the centre of mass that touches the nearest edge, m
    double half_thickness = 0;  ///< m
    Triple half_extent{};       ///< of the box about the centre of mass that holds it, m
    bool is_box = false;        ///< it is that box

    PrismShape() = default;
    PrismShape(Outline of, double half_thickness);
    bool empty() const { return corners.empty(); }
    void archive(StateArchive& state);  ///< core/state_archive.hpp
};

/// Where a prism is. World axes, m.
struct PrismPlace {
    const PrismShape* shape;
    const double* position;  ///< 3, of the centre of mass
    const double* rotation;  ///< 9, prism -> world, row by row
};

inline Triple centre_of(const PrismPlace& prism) {
    return {prism.position[0], prism.position[1], prism.position[2]};
}

/// A direction in the axes of the prism in those of the world, and the other way round.
inline Triple out_of(const PrismPlace& prism, const Triple& d) {
    const double* r = prism.rotation;
    return {r[0] * d[0] + r[1] * d[1] + r[2] * d[2], r[3] * d[0] + r[4] * d[1] + r[5] * d[2],
            r[6] * d[0] + r[7] * d[1] + r[8] * d[2]};
}

inline Triple into(const PrismPlace& prism, const Triple& d) {
    const double* r = prism.rotation;
    return {r[0] * d[0] + r[3] * d[1] + r[6] * d[2], r[1] * d[0] + r[4] * d[1] + r[7] * d[2],
            r[2] * d[0] + r[5] * d[1] + r[8] * d[2]};
}

/// The same of a point.
inline Triple to_world(const PrismPlace& prism, const Triple& p) {
    return out_of(prism, p) + centre_of(prism);
}

inline Triple to_own(const PrismPlace& prism, const Triple& p) {
    return into(prism, p - centre_of(prism));
}

/// Area that a plane cuts from a prism at a depth below its first point, m², and what it gains per depth, m.
struct PrismSection {
    double area = 0;
    double growth = 0;
};

/// Those of planes with one normal. With F(s) the area of the polygon up to the depth s, A(d) = (F(d) - F(d - e))/c for
/// a prism that is e = T c deep along its thickness, c the cosine of it; both cosines are at least `flattest`. Past the
/// middle A stays as it is there, as that of a box does.
class PrismSections {
  public:
    /// normal: inwards, of length 1, in the axes of the prism, which must stay where it is.
    PrismSections(const PrismShape& prism, const Triple& normal);

    PrismSection at(double depth) const;

    /// The area that a contact of this depth crushes, taken from where that area is not 0: an edge that only just
    /// touches has a growth alone.
    PrismSection crushed(double depth) const;

  private:
    /// For the part of the polygon below a height: its area, and the chord at the height over |flat_|.
    PrismSection below(double height) const;

    const PrismShape* prism_;
    Corner flat_;
    double cosine_;
    std::array<double, most_corners + 1> heights_;  ///< of the corners, and of the first again
    double low_, rise_, middle_;
};

/// The edge through which a direction from the centre, in the axes of the prism, leaves; -1: a flat face.
int edge_towards(const PrismShape& prism, const Triple& direction);

}  // namespace floes
