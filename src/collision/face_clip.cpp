// After ODE's box-box test as redistributed with Bullet 3.24 under the zlib licence (btBoxBoxDetector.cpp; original
// version Copyright (C) 2001, 2002 Russell L. Smith, Bullet Copyright (c) 2003-2006 Erwin Coumans). Altered: written
// anew, with the same operations in the same order, so that it finds the same to the last bit.

#include "collision/face_clip.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace floes {
namespace {

constexpr int most = 8;

/// What is left of a polygon on the inner side of sign * x = half, where x is coordinate `axis`. Stops at eight points.
int cut(const double* from, int count, int axis, double sign, double half, double* to) {
    const int other = 1 - axis;
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const double* here = from + 2 * i;
        const double* next = i + 1 < count ? here + 2 : from;
        const bool inside = sign * here[axis] < half;
        if (inside) {
            to[2 * found] = here[0];
            to[2 * found + 1] = here[1];
            if (++found == most) return found;
        }
        if (inside != (sign * next[axis] < half)) {
            to[2 * found + other] =
                here[other] + (next[other] - here[other]) / (next[axis] - here[axis]) * (sign * half - here[axis]);
            to[2 * found + axis] = sign * half;
            if (++found == most) return found;
        }
    }
    return found;
}

struct Middle {
    double x, y;
};

/// Centroid of the polygon.
Middle middle_of(int count, const double* p) {
    if (count == 1) return {p[0], p[1]};
    if (count == 2) return {0.5 * (p[0] + p[2]), 0.5 * (p[1] + p[3])};
    double area = 0;
    double x = 0;
    double y = 0;
    for (int i = 0; i < count - 1; ++i) {
        const double q = p[2 * i] * p[2 * i + 3] - p[2 * i + 2] * p[2 * i + 1];
        area += q;
        x += q * (p[2 * i] + p[2 * i + 2]);
        y += q * (p[2 * i + 1] + p[2 * i + 3]);
    }
    const double q = p[2 * count - 2] * p[1] - p[0] * p[2 * count - 1];
    const double scale = std::abs(area + q) > DBL_EPSILON ? 1.0 / (3.0 * (area + q)) : 1e30;
    return {scale * (x + q * (p[2 * count - 2] + p[0])), scale * (y + q * (p[2 * count - 1] + p[1]))};
}

}  // namespace

int clip_to_rectangle(const double* half, const double* corners, double* found) {
    std::array<double, 2 * most> buffer;
    const double* from = corners;
    double* to = found;
    int count = 4;
    for (int axis = 0; axis <= 1; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            count = cut(from, count, axis, sign, half[axis], to);
            from = to;
            if (count == most) {
                if (from != found) std::copy_n(from, 2 * count, found);
                return count;
            }
            to = from == found ? buffer.data() : found;
        }
    }
    if (from != found) std::copy_n(from, 2 * count, found);
    return count;
}

void spread_evenly(int count, const double* points, int wanted, int first, int* chosen) {
    constexpr double pi = static_cast<double>(3.14159265F);
    const Middle middle = middle_of(count, points);
    std::array<double, most> angle;
    std::array<bool, most> free{};
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        angle[at] = std::atan2(points[2 * i + 1] - middle.y, points[2 * i] - middle.x);
        free[at] = i != first;
    }
    chosen[0] = first;
    for (int k = 1; k < wanted; ++k) {
        double aim = k * (2 * pi / wanted) + angle[static_cast<std::size_t>(first)];
        if (aim > pi) aim -= 2 * pi;
        double nearest = 1e9;
        chosen[k] = first;
        for (int i = 0; i < count; ++i) {
            if (!free[static_cast<std::size_t>(i)]) continue;
            double apart = std::abs(angle[static_cast<std::size_t>(i)] - aim);
            if (apart > pi) apart = 2 * pi - apart;
            if (apart < nearest) {
                nearest = apart;
                chosen[k] = i;
            }
        }
        free[static_cast<std::size_t>(chosen[k])] = false;
    }
}

}  // namespace floes
