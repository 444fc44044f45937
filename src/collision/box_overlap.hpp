#pragma once
// Where two boxes overlap: the points that Bullet's btBoxBoxDetector finds, to the last bit. Only for this module.

#include "collision/overlap.hpp"

namespace floes {

/// As face_gap(), along one of the six normals of their faces: 0, 1, 2 of a, 3, 4, 5 of b.
double box_face_gap(const PrismPlace& a, const PrismPlace& b, int axis);

/// As find_overlap().
void find_box_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found);

}  // namespace floes
