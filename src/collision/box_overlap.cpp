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

/// Of two columns.
double of_axes(const double* one, std::size_t i, const double* other, std::size_t k) {
    return one[i] * other[k] + one[3 + i] * other[3 + k] + one[6 + i] * other[6 + k];
}

BoxPair seen_from_a(const PrismPlace& a, const PrismPlace& b) {
    BoxPair pair;
    pair.between = into(a, centre_of(b) - centre_of(a));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) pair.turn[3 * i + k] = of_axes(a.rotation, i, b.rotation, k);
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
    const Triple along_b = into(other, centre_of(other) - centre_of(one));
    for (int i = 0; i < 3; ++i) {
        const double* row = q + 3 * i;
        if (!search.face(pp[static_cast<std::size_t>(i)], a[i] + b[0] * row[0] + b[1] * row[1] + b[2] * row[2], 1 + i))
            return false;
    }
    for (int i = 0; i < 3; ++i) {
        if (!search.face(along_b[static_cast<std::size_t>(i)], a[0] * q[i] + a[1] * q[3 + i] + a[2] * q[6 + i] + b[i],
                         4 + i))
            return false;
    }
    return true;
}

bool every_pair_of_edges(const double* a, const double* b, const BoxPair& pair, const double* q, Search& search) {
    const Triple& pp = pair.between;
    const double* r = pair.turn;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t u = i == 2 ? 0 : i + 1;  // the other two axes of a, in turn ...
        const std::size_t v = i == 0 ? 2 : i - 1;
        const std::size_t s = i == 0 ? 1 : 0;  // ... and rising
        const std::size_t t = i == 2 ? 1 : 2;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t m = k == 0 ? 1 : 0;
            const std::size_t n = k == 2 ? 1 : 2;
            Triple axis{};
            axis[u] = -r[3 * v + k];
            axis[v] = r[3 * u + k];
            if (!search.edges(pp[v] * r[3 * u + k] - pp[u] * r[3 * v + k],
                              a[s] * q[3 * t + k] + a[t] * q[3 * s + k] + b[m] * q[3 * i + n] + b[n] * q[3 * i + m],
                              axis, static_cast<int>(7 + 3 * i + k)))
                return false;
        }
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

/// Of the box, world.
Triple axis_of(const PrismPlace& box, int axis) {
    return {box.rotation[axis], box.rotation[3 + axis], box.rotation[6 + axis]};
}

/// The corner of the box that lies farthest along `side` times the normal.
Triple farthest(const PrismPlace& box, const Triple& normal, double side) {
    Triple corner = centre_of(box);
    const Triple along = into(box, normal);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double sign = along[axis] > 0 ? side : -side;
        for (std::size_t i = 0; i < 3; ++i) corner[i] += sign * half_of(box)[axis] * box.rotation[3 * i + axis];
    }
    return corner;
}

/// The point of an edge of b that is nearest to an edge of a.
void touch_by_edges(const PrismPlace& a, const PrismPlace& b, const LeastOverlap& least, Overlap& found) {
    const Triple on_a = farthest(a, found.normal, 1);
    const Triple on_b = farthest(b, found.normal, -1);
    const Triple along_a = axis_of(a, (least.code - 7) / 3);
    const Triple along_b = axis_of(b, (least.code - 7) % 3);
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
    found.count = 1;
    found.points[0] = {on_b + beta * along_b, least.depth};
}

/// The face of `box` that looks most against a normal: its own normal, and the other two axes.
struct Incident {
    std::size_t normal, first, second;
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
    const Triple out = of_a ? found.normal : -1 * found.normal;  // of the reference face
    const Triple along = into(other, out);
    const Incident incident = incident_face(along);
    const double side = along[incident.normal] < 0 ? 1.0 : -1.0;
    Triple centre;  // of the incident face, from the reference box
    for (std::size_t i = 0; i < 3; ++i) {
        const double half = half_of(other)[incident.normal] * other.rotation[3 * i + incident.normal];
        centre[i] = side > 0 ? other.position[i] - one.position[i] + half : other.position[i] - one.position[i] - half;
    }
    const int normal_axis = of_a ? least.code - 1 : least.code - 4;
    const std::size_t first = normal_axis == 0 ? 1 : 0;
    const std::size_t second = normal_axis == 2 ? 1 : 2;

    const double c1 = into(one, centre)[first];
    const double c2 = into(one, centre)[second];
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
            face.points[at][k] =
                centre[k] + u * other.rotation[3 * k + incident.first] + v * other.rotation[3 * k + incident.second];
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
    found.normal =
        least.code > 6 ? out_of(a, least.edge_normal) : axis_of(least.code > 3 ? b : a, (least.code - 1) % 3);
    if (least.turned) found.normal = -1 * found.normal;
    if (least.code > 6)
        touch_by_edges(a, b, least, found);
    else
        touch_by_face(a, b, least, found);
}

}  // namespace floes
