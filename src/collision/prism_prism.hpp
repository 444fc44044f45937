#pragma once
// Where two prisms overlap: by separating axes, along the one of least overlap. A face clips the other's face, and two
// edges touch at a point, as btBoxBoxDetector does for boxes; not with its bits.

#include "collision/box_box.hpp"
#include "collision/prism.hpp"

namespace floes {

/// How far two prisms are apart along the normal of the face along which they are farthest apart, m; negative where
/// they overlap. Only faces of a, or of b, where asked for.
double widest_face_gap(const PrismPlace& a, const PrismPlace& b, bool of_a, bool of_b);

/// Refills `found`; its count is 0 where they are apart.
void find_overlap(const PrismPlace& a, const PrismPlace& b, BoxOverlap& found);

}  // namespace floes
