// After ODE's box-box test as redistributed with Bullet 3.24 under the zlib licence (btBoxBoxDetector.cpp; original
// version Copyright (C) 2001, 2002 Russell L. Smith, Bullet Copyright (c) 2003-2006 Erwin Coumans). Altered: written
// anew, with the same operations in the same order, so that it finds the same to the last bit.

#include "collision/box_axes.hpp"

#include <cfloat>
#include <cmath>

namespace floes {

BoxPair seen_from_a(const BoxPlace& a, const BoxPlace& b) {
    BoxPair pair;
    const Triple p{b.position[0] - a.position[0], b.position[1] - a.position[1], b.position[2] - a.position[2]};
    const double* ra = a.rotation;
    const double* rb = b.rotation;
    for (std::size_t i = 0; i < 3; ++i) {
        pair.between[i] = ra[i] * p[0] + ra[3 + i] * p[1] + ra[6 + i] * p[2];
        for (std::size_t k = 0; k < 3; ++k) {
            pair.turn[3 * i + k] = ra[i] * rb[k] + ra[3 + i] * rb[3 + k] + ra[6 + i] * rb[6 + k];
        }
    }
    return pair;
}

namespace {

/// Takes the axes one by one.
class Search {
  public:
    /// A face normal. False if it separates the boxes.
    bool face(double between, double reach, int code) {
        const double overlap = std::abs(between) - reach;
        if (overlap > 0) return false;
        if (overlap > least_) take(overlap, code, between < 0);
        return true;
    }

    /// The product of two edges, of any length. False if it separates the boxes. Faces are preferred.
    bool edges(double between, double reach, const Triple& axis, int code) {
        double overlap = std::abs(between) - reach;
        if (overlap > DBL_EPSILON) return false;
        const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        if (length > DBL_EPSILON) {
            overlap /= length;
            if (overlap * 1.05 > least_) {
                take(overlap, code, between < 0);
                found_.edge_normal = {axis[0] / length, axis[1] / length, axis[2] / length};
            }
        }
        return true;
    }

    LeastOverlap found() {
        found_.depth = -least_;
        return found_;
    }

  private:
    void take(double overlap, int code, bool turned) {
        least_ = overlap;
        found_.code = code;
        found_.turned = turned;
    }

    double least_ = -static_cast<double>(FLT_MAX);
    LeastOverlap found_;
};

bool every_face(const BoxPlace& one, const BoxPlace& other, const BoxPair& pair, const double* q, Search& search) {
    const double* a = one.half_extent;
    const double* b = other.half_extent;
    const Triple& pp = pair.between;
    const Triple p{other.position[0] - one.position[0], other.position[1] - one.position[1],
                   other.position[2] - one.position[2]};
    for (int i = 0; i < 3; ++i) {
        const double* row = q + 3 * i;
        if (!search.face(pp[static_cast<std::size_t>(i)], a[i] + b[0] * row[0] + b[1] * row[1] + b[2] * row[2], 1 + i))
            return false;
    }
    for (int i = 0; i < 3; ++i) {
        const double* r = other.rotation + i;
        if (!search.face(r[0] * p[0] + r[3] * p[1] + r[6] * p[2],
                         a[0] * q[i] + a[1] * q[3 + i] + a[2] * q[6 + i] + b[i], 4 + i))
            return false;
    }
    return true;
}

bool every_pair_of_edges(const double* a, const double* b, const BoxPair& pair, const double* q, Search& search) {
    const Triple& pp = pair.between;
    const double* r = pair.turn;
    for (int k = 0; k < 3; ++k) {  // first axis of a times the three of b
        const int m = k == 0 ? 1 : 0;
        const int n = k == 2 ? 1 : 2;
        if (!search.edges(pp[2] * r[3 + k] - pp[1] * r[6 + k],
                          a[1] * q[6 + k] + a[2] * q[3 + k] + b[m] * q[n] + b[n] * q[m], {0, -r[6 + k], r[3 + k]},
                          7 + k))
            return false;
    }
    for (int k = 0; k < 3; ++k) {
        const int m = k == 0 ? 1 : 0;
        const int n = k == 2 ? 1 : 2;
        if (!search.edges(pp[0] * r[6 + k] - pp[2] * r[k],
                          a[0] * q[6 + k] + a[2] * q[k] + b[m] * q[3 + n] + b[n] * q[3 + m], {r[6 + k], 0, -r[k]},
                          10 + k))
            return false;
    }
    for (int k = 0; k < 3; ++k) {
        const int m = k == 0 ? 1 : 0;
        const int n = k == 2 ? 1 : 2;
        if (!search.edges(pp[1] * r[k] - pp[0] * r[3 + k],
                          a[0] * q[3 + k] + a[1] * q[k] + b[m] * q[6 + n] + b[n] * q[6 + m], {-r[3 + k], r[k], 0},
                          13 + k))
            return false;
    }
    return true;
}

}  // namespace

LeastOverlap least_overlap(const BoxPlace& a, const BoxPlace& b) {
    const BoxPair pair = seen_from_a(a, b);
    double q[9];
    for (int i = 0; i < 9; ++i) q[i] = std::abs(pair.turn[i]);
    Search search;
    if (!every_face(a, b, pair, q, search)) return {};
    for (double& entry : q) entry += static_cast<double>(1e-5F);  // so that parallel edges do not divide by nothing
    if (!every_pair_of_edges(a.half_extent, b.half_extent, pair, q, search)) return {};
    return search.found();
}

}  // namespace floes
