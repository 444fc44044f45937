#pragma once
// Prisms: convex polygons of even thickness, in their own axes. y runs along the thickness; corners lie in (x, z) about
// the centre of mass. A box is one with four corners.

#include "collision/box.hpp"
#include "shapes/polygon.hpp"

namespace floes {

struct PrismShape {
    Outline corners;            ///< m
    Outline normals;            ///< outward, of each edge
    double half_thickness = 0;  ///< m

    PrismShape() = default;
    PrismShape(Outline of, double half_thickness);
    bool empty() const { return corners.empty(); }
};

PrismShape prism_of_box(const Triple& half_extent);

/// Half extents of the box about the centre of mass that holds the prism, m.
Triple bounds_of(const PrismShape& prism);

/// Where a prism is; place.half_extent is not looked at.
struct PrismPlace {
    const PrismShape* shape;
    BoxPlace place;
};

/// Area that a plane cuts from a prism at a depth below its first point, m², and what it gains per depth, m.
struct PrismSection {
    double area = 0;
    double growth = 0;
};

/// normal: inwards, of length 1, in the axes of the prism. With F(s) the area of the polygon up to the depth s,
/// A(d) = (F(d) - F(d - e))/c for a prism that is e = T c deep along its thickness, c the cosine of it; both cosines
/// are at least `flattest`. Past the middle it stays at its largest, as that of a box does.
PrismSection section_of(const PrismShape& prism, const Triple& normal, double depth);

/// The area that a contact of this depth crushes, taken from where that area is not 0: an edge that only just touches
/// has a growth alone. Growth and area as section_of().
PrismSection crushed_section(const PrismShape& prism, const Triple& normal, double depth);

/// The edge through which a direction from the centre, in the axes of the prism, leaves; -1: a flat face.
int edge_towards(const PrismShape& prism, const Triple& direction);

}  // namespace floes
