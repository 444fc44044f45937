#pragma once
// Between the vectors of floes and those of Bullet. Only for files inside this module.

#include <LinearMath/btTransform.h>

#include <array>

#include "core/vector.hpp"

namespace floes {

inline btVector3 to_bullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

inline btTransform to_bullet(const Pose& pose) {
    const Quat q = pose.orientation.normalized();
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(pose.position));
}

/// Of a position, and a rotation row by row.
inline btTransform transform_of(const double* position, const double* r) {
    return btTransform(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                       {position[0], position[1], position[2]});
}

inline btMatrix3x3 to_bullet(const Mat3& m) {
    return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

inline std::array<double, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline Vec3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline Mat3 from_bullet(const btMatrix3x3& m) {
    Mat3 result;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result(row, column) = m[row][column];
    }
    return result;
}

}  // namespace floes
