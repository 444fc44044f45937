#pragma once
// A box that may touch others.

#include <array>

namespace floes {

/// Where a box is. World axes, m.
struct BoxPlace {
    const double* half_extent;  ///< 3, along its own axes
    const double* position;     ///< 3, of the centre
    const double* rotation;     ///< 9, box -> world, row by row
};

using Triple = std::array<double, 3>;

inline Triple operator-(const Triple& a, const Triple& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A point of the box in world axes, and the other way round.
inline Triple to_world(const BoxPlace& box, const Triple& p) {
    const double* r = box.rotation;
    return {r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + box.position[0],
            r[3] * p[0] + r[4] * p[1] + r[5] * p[2] + box.position[1],
            r[6] * p[0] + r[7] * p[1] + r[8] * p[2] + box.position[2]};
}

inline Triple to_box(const BoxPlace& box, const Triple& p) {
    const double* r = box.rotation;
    const double x = p[0] - box.position[0];
    const double y = p[1] - box.position[1];
    const double z = p[2] - box.position[2];
    return {r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z};
}

}  // namespace floes
