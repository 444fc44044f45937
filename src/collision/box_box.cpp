// After ODE's box-box test as redistributed with Bullet 3.24 under the zlib licence (btBoxBoxDetector.cpp; original
// version Copyright (C) 2001, 2002 Russell L. Smith, Bullet Copyright (c) 2003-2006 Erwin Coumans). Altered: written
// anew, with the same operations in the same order, so that it finds the same to the last bit.

#include "collision/box_box.hpp"

#include <cmath>

#include "collision/box_axes.hpp"
#include "collision/face_clip.hpp"

namespace floes {
namespace {

double along_axis(const Triple& v, const double* rotation, int axis) {
    return v[0] * rotation[axis] + v[1] * rotation[3 + axis] + v[2] * rotation[6 + axis];
}

double of_axes(const double* one, int i, const double* other, int k) {
    return one[i] * other[k] + one[3 + i] * other[3 + k] + one[6 + i] * other[6 + k];
}

/// The corner of the box that lies farthest along `side` times the normal.
Triple farthest(const BoxPlace& box, const Triple& normal, double side) {
    Triple corner{box.position[0], box.position[1], box.position[2]};
    for (int axis = 0; axis < 3; ++axis) {
        const double sign = along_axis(normal, box.rotation, axis) > 0 ? side : -side;
        for (std::size_t i = 0; i < 3; ++i)
            corner[i] += sign * box.half_extent[axis] * box.rotation[3 * i + static_cast<std::size_t>(axis)];
    }
    return corner;
}

/// The point of an edge of b that is nearest to an edge of a.
void touch_by_edges(const BoxPlace& a, const BoxPlace& b, const LeastOverlap& least, BoxOverlap& found) {
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
void keep_points(const FacePoints& face, const double* position, bool of_a, BoxOverlap& found) {
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
        BoxOverlap::Point& to = found.points[static_cast<std::size_t>(i)];
        to.depth = face.depth[from];
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = face.points[from][k] + position[k];
            to.on_b[k] = of_a ? at : at - found.normal[k] * face.depth[from];
        }
    }
}

/// The face of one box, the reference, that the other's incident face overlaps, and the points of that one within it.
void touch_by_face(const BoxPlace& a, const BoxPlace& b, const LeastOverlap& least, BoxOverlap& found) {
    const bool of_a = least.code <= 3;
    const BoxPlace& one = of_a ? a : b;
    const BoxPlace& other = of_a ? b : a;
    Triple out = found.normal;  // of the reference face
    if (!of_a) out = {-out[0], -out[1], -out[2]};
    const Incident incident = incident_face(
        {along_axis(out, other.rotation, 0), along_axis(out, other.rotation, 1), along_axis(out, other.rotation, 2)});
    const double side = along_axis(out, other.rotation, incident.normal) < 0 ? 1.0 : -1.0;
    Triple centre;  // of the incident face, from the reference box
    for (std::size_t i = 0; i < 3; ++i) {
        const double half =
            other.half_extent[incident.normal] * other.rotation[3 * i + static_cast<std::size_t>(incident.normal)];
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
    const double k1 = m11 * other.half_extent[incident.first];
    const double k2 = m21 * other.half_extent[incident.first];
    const double k3 = m12 * other.half_extent[incident.second];
    const double k4 = m22 * other.half_extent[incident.second];
    const double corners[8] = {c1 - k1 - k3, c2 - k2 - k4, c1 - k1 + k3, c2 - k2 + k4,
                               c1 + k1 + k3, c2 + k2 + k4, c1 + k1 - k3, c2 + k2 - k4};
    const double half[2] = {one.half_extent[first], one.half_extent[second]};
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
        face.depth[at] = one.half_extent[normal_axis] - dot(out, face.points[at]);
        if (!(face.depth[at] >= 0)) continue;
        face.flat[2 * face.count] = face.flat[2 * i];
        face.flat[2 * face.count + 1] = face.flat[2 * i + 1];
        ++face.count;
    }
    if (face.count > 0) keep_points(face, one.position, of_a, found);
}

}  // namespace

double face_gap(const BoxPlace& a, const BoxPlace& b, int axis) {
    const BoxPlace& one = axis < 3 ? a : b;
    const BoxPlace& other = axis < 3 ? b : a;
    const int i = axis % 3;
    const Triple out{one.rotation[i], one.rotation[3 + i], one.rotation[6 + i]};
    const Triple between{b.position[0] - a.position[0], b.position[1] - a.position[1], b.position[2] - a.position[2]};
    double gap = std::abs(dot(out, between)) - one.half_extent[i];
    for (int k = 0; k < 3; ++k) gap -= other.half_extent[k] * std::abs(along_axis(out, other.rotation, k));
    return gap;
}

void find_overlap(const BoxPlace& a, const BoxPlace& b, BoxOverlap& found) {
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
