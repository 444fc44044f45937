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

/// How many normals of faces a prism has.
int face_axes(const PrismShape& of);

/// How far two prisms are apart along a normal of the faces of one of them: axes of a come first, then those of b. m;
/// negative where they overlap along it.
double face_gap(const PrismPlace& a, const PrismPlace& b, int axis);

/// The largest of these, of axes from `first` to before `end`.
struct FaceGap {
    double gap;
    int axis;
};
FaceGap widest_face_gap(const PrismPlace& a, const PrismPlace& b, int first, int end);

/// Refills `found`; its count is 0 where the prisms are apart.
void find_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found);

/// The same of two boxes, which it calls: as Bullet's btBoxBoxDetector finds it, to the last bit.
void find_box_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found);

}  // namespace floes
