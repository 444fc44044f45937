#pragma once
// Which of the fifteen axes of two boxes separates them, or along which they overlap least.

#include "collision/box.hpp"

namespace floes {

/// Two boxes as seen from a.
struct BoxPair {
    Triple between;  ///< from the centre of a to that of b, axes of a
    double turn[9];  ///< axes of b -> axes of a, row by row
};

BoxPair seen_from_a(const BoxPlace& a, const BoxPlace& b);

/// The axis of least overlap.
struct LeastOverlap {
    /// 1, 2, 3: a face normal of a; 4, 5, 6: of b; 7 to 15: edge of a times edge of b, those of b change first; 0: the
    /// boxes are apart.
    int code = 0;
    double depth = 0;      ///< m
    bool turned = false;   ///< the axis points from b to a
    Triple edge_normal{};  ///< of codes above 6: the axis, unit, axes of a
};

LeastOverlap least_overlap(const BoxPlace& a, const BoxPlace& b);

}  // namespace floes
