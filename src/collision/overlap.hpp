#pragma once
// Where two prisms overlap: by separating axes, along the one of least overlap. A face clips the other's face, and two
// edges touch at a point, as btBoxBoxDetector does for boxes: of two boxes with its bits (box_overlap.cpp).

#include <array>

#include "collision/prism.hpp"

namespace floes {

/// Points at which two prisms overlap, at most four.
struct Overlap {
    struct Point {
        Triple on_b;   ///< on the surface of b, m
        double depth;  ///< m, not negative
    };
    int count = 0;
    Triple normal{};  ///< unit, from a to b
    std::array<Point, 4> points;
};

/// How many of the axes of face_gap() belong to one of two prisms.
int face_axes(const PrismShape& of, const PrismShape& other);

/// How far two prisms are apart along a normal of the faces of one of them: axes of a come first, then those of b. m;
/// negative where they overlap along it.
double face_gap(const PrismPlace& a, const PrismPlace& b, int axis);

/// Refills `found`; its count is 0 where the prisms are apart.
void find_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found);

// The same of two boxes, for the two above: as Bullet's btBoxBoxDetector finds them, to the last bit.

/// As face_gap(), along one of the six normals of their faces: 0, 1, 2 of a, 3, 4, 5 of b.
double box_face_gap(const PrismPlace& a, const PrismPlace& b, int axis);

/// As find_overlap().
void find_box_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found);

}  // namespace floes
