// Where two boxes overlap.
//
// After ODE's box-box test as redistributed with Bullet 3.24 under the zlib licence (btBoxBoxDetector.cpp; original
// version Copyright (C) 2001, 2002 Russell L. Smith, Bullet Copyright (c) 2003-2006 Erwin Coumans). Altered: written
// anew, with the same operations in the same order, so that it finds the same to the last bit.

#include "collision/overlap.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace floes {

namespace {

constexpr int most_points = 8;

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
            if (++found == most_points) return found;
        }
        if (inside != (sign * next[axis] < half)) {
            to[2 * found + other] =
                here[other] + (next[other] - here[other]) / (next[axis] - here[axis]) * (sign * half - here[axis]);
            to[2 * found + axis] = sign * half;
            if (++found == most_points) return found;
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

/// Corners of what the rectangle |x| <= half[0], |y| <= half[1] has in common with a parallelogram of four corners (x,
/// y), at most eight; an edge of the rectangle itself is outside. Returns their number.
int clip_to_rectangle(const double* half, const double* corners, double* found) {
    std::array<double, 2 * most_points> buffer;
    const double* from = corners;
    double* to = found;
    int count = 4;
    for (int axis = 0; axis <= 1; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            count = cut(from, count, axis, sign, half[axis], to);
            from = to;
            if (count == most_points) {
                if (from != found) std::copy_n(from, 2 * count, found);
                return count;
            }
            to = from == found ? buffer.data() : found;
        }
    }
    if (from != found) std::copy_n(from, 2 * count, found);
    return count;
}

/// Chooses `wanted` of `count` points in a plane, spread evenly by angle round their middle; the first is `first`.
void spread_evenly(int count, const double* points, int wanted, int first, int* chosen) {
    constexpr double pi = static_cast<double>(3.14159265F);
    const Middle middle = middle_of(count, points);
    std::array<double, most_points> angle;
    std::array<bool, most_points> free{};
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

const double* half_of(const PrismPlace& box) {
    return box.shape->half_extent.data();
}

// Which of the fifteen axes of two boxes separates them, or along which they overlap least.

/// Two boxes as seen from a.
struct BoxPair {
    Triple between;  ///< from the centre of a to that of b, axes of a
    double turn[9];  ///< axes of b -> axes of a, row by row
};

/// The axis of least overlap.
struct LeastOverlap {
    /// 1, 2, 3: a face normal of a; 4, 5, 6: of b; 7 to 15: edge of a times edge of b, those of b change first; 0: the
    /// boxes are apart.
    int code = 0;
    double depth = 0;      ///< m
    bool turned = false;   ///< the axis points from b to a
    Triple edge_normal{};  ///< of codes above 6: the axis, unit, axes of a
};

BoxPair seen_from_a(const PrismPlace& a, const PrismPlace& b) {
    BoxPair pair;
    const Triple p = centre_of(b) - centre_of(a);
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

bool every_face(const PrismPlace& one, const PrismPlace& other, const BoxPair& pair, const double* q, Search& search) {
    const double* a = half_of(one);
    const double* b = half_of(other);
    const Triple& pp = pair.between;
    const Triple p = centre_of(other) - centre_of(one);
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

LeastOverlap least_overlap(const PrismPlace& a, const PrismPlace& b) {
    const BoxPair pair = seen_from_a(a, b);
    double q[9];
    for (int i = 0; i < 9; ++i) q[i] = std::abs(pair.turn[i]);
    Search search;
    if (!every_face(a, b, pair, q, search)) return {};
    for (double& entry : q) entry += static_cast<double>(1e-5F);  // so that parallel edges do not divide by nothing
    if (!every_pair_of_edges(half_of(a), half_of(b), pair, q, search)) return {};
    return search.found();
}

// The points of that overlap.

double along_axis(const Triple& v, const double* rotation, int axis) {
    return v[0] * rotation[axis] + v[1] * rotation[3 + axis] + v[2] * rotation[6 + axis];
}

double of_axes(const double* one, int i, const double* other, int k) {
    return one[i] * other[k] + one[3 + i] * other[3 + k] + one[6 + i] * other[6 + k];
}

/// The corner of the box that lies farthest along `side` times the normal.
Triple farthest(const PrismPlace& box, const Triple& normal, double side) {
    Triple corner = centre_of(box);
    for (int axis = 0; axis < 3; ++axis) {
        const double sign = along_axis(normal, box.rotation, axis) > 0 ? side : -side;
        for (std::size_t i = 0; i < 3; ++i)
            corner[i] += sign * half_of(box)[axis] * box.rotation[3 * i + static_cast<std::size_t>(axis)];
    }
    return corner;
}

/// The point of an edge of b that is nearest to an edge of a.
void touch_by_edges(const PrismPlace& a, const PrismPlace& b, const LeastOverlap& least, Overlap& found) {
    const Triple on_a = farthest(a, found.normal, 1);
    Triple on_b = farthest(b, found.normal, -1);
    const int axis_a = (least.code - 7) / 3;
    const int axis_b = (least.code - 7) % 3;
    const Triple along_a{a.rotation[axis_a], a.rotation[3 + axis_a], a.rotation[6 + axis_a]};
    const Triple along_b{b.rotation[axis_b], b.rotation[3 + axis_b], b.rotation[6 + axis_b]};
    const Triple between = on_b - on_a;
    const double parallel = dot(along_a, along_b);
    const double by_a = dot(along_a, between);
    const double by_b = -dot(along_b, between);
    double d = 1 - parallel * parallel;
    double beta = 0;
    if (!(d <= static_cast<double>(0.0001F))) {
        d = 1.0 / d;
        beta = (parallel * by_a + by_b) * d;
    }
    for (std::size_t i = 0; i < 3; ++i) on_b[i] += along_b[i] * beta;
    found.count = 1;
    found.points[0] = {on_b, least.depth};
}

/// The face of `box` that looks most against a normal: its own normal, and the other two axes.
struct Incident {
    int normal, first, second;
};

Incident incident_face(const Triple& along) {
    const Triple size{std::abs(along[0]), std::abs(along[1]), std::abs(along[2])};
    if (size[1] > size[0]) return size[1] > size[2] ? Incident{1, 0, 2} : Incident{2, 0, 1};
    return size[0] > size[2] ? Incident{0, 1, 2} : Incident{2, 0, 1};
}

/// What of an incident face lies within the reference box.
struct FacePoints {
    int count;
    double flat[16];               ///< places on the reference face
    std::array<Triple, 8> points;  ///< from the reference box's centre
    std::array<double, 8> depth;
};

/// At most four of the points, the deepest among them, into `found`.
void keep_points(const FacePoints& face, const double* position, bool of_a, Overlap& found) {
    constexpr int most = 4;
    int chosen[8] = {0, 1, 2, 3};
    if (face.count > most) {
        int deepest = 0;
        for (int i = 1; i < face.count; ++i) {
            if (face.depth[static_cast<std::size_t>(i)] > face.depth[static_cast<std::size_t>(deepest)]) deepest = i;
        }
        spread_evenly(face.count, face.flat, most, deepest, chosen);
    }
    found.count = face.count < most ? face.count : most;
    for (int i = 0; i < found.count; ++i) {
        const auto from = static_cast<std::size_t>(chosen[i]);
        Overlap::Point& to = found.points[static_cast<std::size_t>(i)];
        to.depth = face.depth[from];
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = face.points[from][k] + position[k];
            to.on_b[k] = of_a ? at : at - found.normal[k] * face.depth[from];
        }
    }
}

/// The face of one box, the reference, that the other's incident face overlaps, and the points of that one within it.
void touch_by_face(const PrismPlace& a, const PrismPlace& b, const LeastOverlap& least, Overlap& found) {
    const bool of_a = least.code <= 3;
    const PrismPlace& one = of_a ? a : b;
    const PrismPlace& other = of_a ? b : a;
    Triple out = found.normal;  // of the reference face
    if (!of_a) out = {-out[0], -out[1], -out[2]};
    const Incident incident = incident_face(
        {along_axis(out, other.rotation, 0), along_axis(out, other.rotation, 1), along_axis(out, other.rotation, 2)});
    const double side = along_axis(out, other.rotation, incident.normal) < 0 ? 1.0 : -1.0;
    Triple centre;  // of the incident face, from the reference box
    for (std::size_t i = 0; i < 3; ++i) {
        const double half =
            half_of(other)[incident.normal] * other.rotation[3 * i + static_cast<std::size_t>(incident.normal)];
        centre[i] = side > 0 ? other.position[i] - one.position[i] + half : other.position[i] - one.position[i] - half;
    }
    const int normal_axis = of_a ? least.code - 1 : least.code - 4;
    const int first = normal_axis == 0 ? 1 : 0;
    const int second = normal_axis == 2 ? 1 : 2;

    const double c1 = along_axis(centre, one.rotation, first);
    const double c2 = along_axis(centre, one.rotation, second);
    double m11 = of_axes(one.rotation, first, other.rotation, incident.first);
    double m12 = of_axes(one.rotation, first, other.rotation, incident.second);
    double m21 = of_axes(one.rotation, second, other.rotation, incident.first);
    double m22 = of_axes(one.rotation, second, other.rotation, incident.second);
    const double k1 = m11 * half_of(other)[incident.first];
    const double k2 = m21 * half_of(other)[incident.first];
    const double k3 = m12 * half_of(other)[incident.second];
    const double k4 = m22 * half_of(other)[incident.second];
    const double corners[8] = {c1 - k1 - k3, c2 - k2 - k4, c1 - k1 + k3, c2 - k2 + k4,
                               c1 + k1 + k3, c2 + k2 + k4, c1 + k1 - k3, c2 + k2 - k4};
    const double half[2] = {half_of(one)[first], half_of(one)[second]};
    FacePoints face;
    const int clipped = clip_to_rectangle(half, corners, face.flat);

    // Back into space; only points within the reference box stay.
    const double inverse = 1.0 / (m11 * m22 - m12 * m21);
    m11 *= inverse;
    m12 *= inverse;
    m21 *= inverse;
    m22 *= inverse;
    face.count = 0;
    for (int i = 0; i < clipped; ++i) {
        const double u = m22 * (face.flat[2 * i] - c1) - m12 * (face.flat[2 * i + 1] - c2);
        const double v = -m21 * (face.flat[2 * i] - c1) + m11 * (face.flat[2 * i + 1] - c2);
        const auto at = static_cast<std::size_t>(face.count);
        for (std::size_t k = 0; k < 3; ++k) {
            face.points[at][k] = centre[k] + u * other.rotation[3 * k + static_cast<std::size_t>(incident.first)] +
                                 v * other.rotation[3 * k + static_cast<std::size_t>(incident.second)];
        }
        face.depth[at] = half_of(one)[normal_axis] - dot(out, face.points[at]);
        if (!(face.depth[at] >= 0)) continue;
        face.flat[2 * face.count] = face.flat[2 * i];
        face.flat[2 * face.count + 1] = face.flat[2 * i + 1];
        ++face.count;
    }
    if (face.count > 0) keep_points(face, one.position, of_a, found);
}

}  // namespace

void find_box_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found) {
    found.count = 0;
    const LeastOverlap least = least_overlap(a, b);
    if (least.code == 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t row = 3 * i;
        const auto column = static_cast<std::size_t>((least.code - 1) % 3);
        if (least.code <= 3)
            found.normal[i] = a.rotation[row + column];
        else if (least.code <= 6)
            found.normal[i] = b.rotation[row + column];
        else
            found.normal[i] = a.rotation[row] * least.edge_normal[0] + a.rotation[row + 1] * least.edge_normal[1] +
                              a.rotation[row + 2] * least.edge_normal[2];
        if (least.turned) found.normal[i] = -found.normal[i];
    }
    if (least.code > 6)
        touch_by_edges(a, b, least, found);
    else
        touch_by_face(a, b, least, found);
}

}  // namespace floes
