#pragma once
// Sums and products of vectors, and directions in the axes of a body. Only for this module.

#include "collision/prism.hpp"

namespace floes {

inline Triple scaled(const Triple& a, double s) {
    return {s * a[0], s * a[1], s * a[2]};
}

inline Triple sum(const Triple& a, const Triple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Triple cross_of(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A direction of the world in the axes of the body, and back.
inline Triple into(const PrismPlace& body, const Triple& d) {
    const double* r = body.rotation;
    return {r[0] * d[0] + r[3] * d[1] + r[6] * d[2], r[1] * d[0] + r[4] * d[1] + r[7] * d[2],
            r[2] * d[0] + r[5] * d[1] + r[8] * d[2]};
}

inline Triple out_of(const PrismPlace& body, const Triple& d) {
    const double* r = body.rotation;
    return {r[0] * d[0] + r[1] * d[1] + r[2] * d[2], r[3] * d[0] + r[4] * d[1] + r[5] * d[2],
            r[6] * d[0] + r[7] * d[1] + r[8] * d[2]};
}

}  // namespace floes
