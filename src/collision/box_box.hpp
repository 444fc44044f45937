#pragma once
// Where two boxes overlap: the points that Bullet's btBoxBoxDetector finds, to the last bit.

#include <array>

#include "collision/box.hpp"

namespace floes {

/// Points at which two boxes overlap, at most four.
struct BoxOverlap {
    struct Point {
        Triple on_b;   ///< on the surface of b, m
        double depth;  ///< m, not negative
    };
    int count = 0;
    Triple normal{};  ///< unit, from a to b
    std::array<Point, 4> points;
};

/// How far two boxes are apart along one of the six normals of their faces: 0, 1, 2 of a, 3, 4, 5 of b. m; negative
/// where they overlap along it.
double face_gap(const BoxPlace& a, const BoxPlace& b, int axis);

/// Refills `found`; its count is 0 where the boxes are apart.
void find_overlap(const BoxPlace& a, const BoxPlace& b, BoxOverlap& found);

}  // namespace floes
