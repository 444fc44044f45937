#include "collision/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "shapes/elements.hpp"

namespace floes {
namespace {

Triple scaled(const Triple& a, double s) {
    return {s * a[0], s * a[1], s * a[2]};
}

constexpr double edges_over_faces = 1.05;  // an edge has to be that much better: faces give four points
constexpr double parallel = 1e-4;          // axes that differ by less make no axis of their own

Triple own_normal(const PrismShape& shape, int face) {
    if (face < 2) return {0, face == 0 ? 1.0 : -1.0, 0};
    const Corner& normal = shape.normals[static_cast<std::size_t>(face - 2)];
    return {normal.x, 0, normal.z};
}

int faces_of(const PrismShape& shape) {
    return 2 + static_cast<int>(shape.corners.size());
}

/// Least and largest of d . p over the prism, d in its axes.
struct Reach {
    double low, high;
};
Reach reach_along(const PrismShape& shape, const Triple& d) {
    Reach reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Corner& one : shape.corners) {
        const double at = d[0] * one.x + d[2] * one.z;
        reach.low = std::min(reach.low, at);
        reach.high = std::max(reach.high, at);
    }
    const double up = std::abs(d[1]) * shape.half_thickness;
    return {reach.low - up, reach.high + up};
}

/// The corner that lies farthest along d, world.
Triple farthest(const PrismPlace& prism, const Triple& d) {
    const Triple own = into(prism, d);
    const Corner* best = &prism.shape->corners.front();
    for (const Corner& one : prism.shape->corners)
        if (own[0] * one.x + own[2] * one.z > own[0] * best->x + own[2] * best->z) best = &one;
    const double y = own[1] > 0 ? prism.shape->half_thickness : -prism.shape->half_thickness;
    return to_world(prism, {best->x, y, best->z});
}

double face_offset(const PrismShape& shape, int face) {
    if (face < 2) return shape.half_thickness;
    const auto k = static_cast<std::size_t>(face - 2);
    return dot(shape.normals[k], shape.corners[k]);
}

/// A face of one of two prisms: 0 upper, 1 lower, 2 + k: edge k.
struct PrismFace {
    bool of_a = true;
    int face = 0;
};

/// What a search found: an axis from a to b, of length 1, world.
struct Best {
    double gap = -std::numeric_limits<double>::infinity();
    Triple axis{};
    PrismFace face;
    bool edges = false;
    Triple along_a{}, along_b{};  // of the edges, world
};

double gap_along(const PrismPlace& one, const PrismPlace& other, int face) {
    const Triple own = own_normal(*one.shape, face);
    const Triple axis = out_of(one, own);
    const Triple between = centre_of(other) - centre_of(one);
    return dot(axis, between) + reach_along(*other.shape, into(other, axis)).low - face_offset(*one.shape, face);
}

/// Directions of the edges: along the thickness, then along each edge of the polygon, world.
std::size_t edge_directions(const PrismPlace& prism, std::array<Triple, 40>& found) {
    found[0] = out_of(prism, {0, 1, 0});
    std::size_t count = 1;
    for (const Corner& normal : prism.shape->normals) found[count++] = out_of(prism, {-normal.z, 0, normal.x});
    return count;
}

/// False where an axis of two edges parts them.
bool look_at_edges(const PrismPlace& a, const PrismPlace& b, Best& best) {
    std::array<Triple, 40> of_a;
    std::array<Triple, 40> of_b;
    const std::size_t count_a = edge_directions(a, of_a);
    const std::size_t count_b = edge_directions(b, of_b);
    const Triple tilt = cross(of_a[0], of_b[0]);
    if (dot(tilt, tilt) < parallel * parallel) return true;  // flat on each other: edges say what faces say
    const Triple between = centre_of(b) - centre_of(a);
    double face_gap = best.gap;
    for (std::size_t i = 0; i < count_a; ++i) {
        for (std::size_t k = 0; k < count_b; ++k) {
            Triple axis = cross(of_a[i], of_b[k]);
            const double length = std::sqrt(dot(axis, axis));
            if (length < parallel) continue;
            axis = scaled(axis, 1 / length);
            const Reach at_a = reach_along(*a.shape, into(a, axis));
            const Reach at_b = reach_along(*b.shape, into(b, axis));
            const double apart = dot(axis, between);
            const double onward = apart + at_b.low - at_a.high;
            const double back = at_a.low - at_b.high - apart;
            const double gap = std::max(onward, back);
            if (gap > 0) return false;
            if (!(gap * edges_over_faces > face_gap)) continue;
            face_gap = gap;
            best = {gap, onward >= back ? axis : scaled(axis, -1), {}, true, of_a[i], of_b[k]};
        }
    }
    return true;
}

void touch_by_edges(const PrismPlace& a, const PrismPlace& b, const Best& best, Overlap& found) {
    const Triple on_a = farthest(a, best.axis);
    Triple on_b = farthest(b, scaled(best.axis, -1));
    const Triple between = on_b - on_a;
    const double together = dot(best.along_a, best.along_b);
    const double rest = 1 - together * together;
    if (rest > 1e-4)
        on_b = on_b + scaled(best.along_b, (together * dot(best.along_a, between) - dot(best.along_b, between)) / rest);
    found.count = 1;
    found.points[0] = {on_b, -best.gap};
}

/// Points in order, in place of a vector: every pair that touches needs some in every step.
class Points {
  public:
    /// Does nothing where the room is used up. Each edge of the one face adds a point at most to those of the other.
    void add(const Triple& point) {
        if (count_ < room) points_[count_++] = point;
    }
    void keep(std::size_t count) { count_ = count; }
    std::size_t size() const { return count_; }
    Triple& operator[](std::size_t i) { return points_[i]; }
    const Triple& operator[](std::size_t i) const { return points_[i]; }

    static constexpr std::size_t room = 2 * most_corners;

  private:
    std::array<Triple, room> points_;
    std::size_t count_ = 0;
};

/// Corners of a face in order, world.
void corners_of(const PrismPlace& prism, int face, Points& corners) {
    const PrismShape& shape = *prism.shape;
    const double half = shape.half_thickness;
    if (face < 2) {
        for (const Corner& one : shape.corners) corners.add(to_world(prism, {one.x, face == 0 ? half : -half, one.z}));
        return;
    }
    const auto k = static_cast<std::size_t>(face - 2);
    const Corner& from = shape.corners[k];
    const Corner& to = after(shape.corners, k);
    corners.add(to_world(prism, {from.x, half, from.z}));
    corners.add(to_world(prism, {to.x, half, to.z}));
    corners.add(to_world(prism, {to.x, -half, to.z}));
    corners.add(to_world(prism, {from.x, -half, from.z}));
}

/// What of `polygon` lies below the bound along the normal, into `rest`.
void cut(const Points& polygon, Points& rest, const Triple& normal, double bound) {
    rest.keep(0);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Triple& here = polygon[k];
        const Triple& next = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        const double room = bound - dot(normal, here);
        const double room_next = bound - dot(normal, next);
        if (room >= 0) rest.add(here);
        if ((room >= 0) != (room_next >= 0)) rest.add(here + scaled(next - here, room / (room - room_next)));
    }
}

/// The deepest point, the one farthest from it, and the two farthest on either side of the line between them.
std::array<int, 4> spread(const Points& points, std::span<const double> depth, const Triple& normal, int& count) {
    const auto farthest_by = [&](const auto& measure) {
        int best = -1;
        double most = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double value = measure(points[k]);
            if (value <= most) continue;
            most = value;
            best = static_cast<int>(k);
        }
        return best;
    };
    std::array<int, 4> chosen{static_cast<int>(std::ranges::max_element(depth) - depth.begin()), -1, -1, -1};
    const Triple& first = points[static_cast<std::size_t>(chosen[0])];
    const int far = farthest_by([&](const Triple& p) { return dot(p - first, p - first); });
    count = 1;
    if (far < 0) return chosen;
    chosen[static_cast<std::size_t>(count++)] = far;
    const Triple side = cross(normal, points[static_cast<std::size_t>(far)] - first);
    for (const double sign : {1.0, -1.0}) {
        const int next = farthest_by([&](const Triple& p) { return sign * dot(side, p - first); });
        if (next >= 0 && next != far) chosen[static_cast<std::size_t>(count++)] = next;
    }
    return chosen;
}

void touch_by_face(const PrismPlace& a, const PrismPlace& b, const Best& best, Overlap& found) {
    const PrismPlace& one = best.face.of_a ? a : b;
    const PrismPlace& other = best.face.of_a ? b : a;
    const Triple out = best.face.of_a ? best.axis : scaled(best.axis, -1);
    const Triple seen = into(other, out);
    int incident = seen[1] > 0 ? 1 : 0;
    double against = -std::abs(seen[1]);
    for (std::size_t k = 0; k < other.shape->normals.size(); ++k) {
        const double along = other.shape->normals[k].x * seen[0] + other.shape->normals[k].z * seen[2];
        if (along >= against) continue;
        against = along;
        incident = static_cast<int>(k) + 2;
    }
    std::array<Points, 2> buffers;
    std::size_t now = 0;
    corners_of(other, incident, buffers[now]);
    const Triple centre = centre_of(one);
    const auto cut_by = [&](const Triple& own, double offset) {
        const Triple normal = out_of(one, own);
        cut(buffers[now], buffers[1 - now], normal, offset + dot(normal, centre));
        now = 1 - now;
    };
    const int face = best.face.face;
    if (face < 2) {
        for (int k = 2; k < faces_of(*one.shape); ++k) cut_by(own_normal(*one.shape, k), face_offset(*one.shape, k));
    } else {
        const auto k = static_cast<std::size_t>(face - 2);
        const Corner& normal = one.shape->normals[k];
        const Corner along{-normal.z, normal.x};
        const double from = dot(along, one.shape->corners[k]);
        const double to = dot(along, after(one.shape->corners, k));
        cut_by({along.x, 0, along.z}, std::max(from, to));
        cut_by({-along.x, 0, -along.z}, -std::min(from, to));
        for (const int flat : {0, 1}) cut_by(own_normal(*one.shape, flat), one.shape->half_thickness);
    }
    const double surface = face_offset(*one.shape, face) + dot(out, centre);
    Points& points = buffers[now];
    std::array<double, Points::room> depth;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double deep = surface - dot(out, points[i]);
        if (!(deep >= 0)) continue;
        points[kept] = points[i];
        depth[kept++] = deep;
    }
    points.keep(kept);
    if (kept == 0) return;
    const std::array<int, 4> chosen = spread(points, {depth.data(), kept}, out, found.count);
    for (int i = 0; i < found.count; ++i) {
        const auto from = static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)]);
        Overlap::Point& to = found.points[static_cast<std::size_t>(i)];
        to.depth = depth[from];
        to.on_b = best.face.of_a ? points[from] : points[from] + scaled(out, depth[from]);
    }
}

}  // namespace

int face_axes(const PrismShape& of, const PrismShape& other) {
    return of.is_box && other.is_box ? 3 : faces_of(of);
}

double face_gap(const PrismPlace& a, const PrismPlace& b, int axis) {
    if (a.shape->is_box && b.shape->is_box) return box_face_gap(a, b, axis);
    const int of_a = faces_of(*a.shape);
    return axis < of_a ? gap_along(a, b, axis) : gap_along(b, a, axis - of_a);
}

void find_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found) {
    if (a.shape->is_box && b.shape->is_box) return find_box_overlap(a, b, found);
    found.count = 0;
    Best best;
    for (const bool of_a : {true, false}) {
        const PrismPlace& one = of_a ? a : b;
        const PrismPlace& other = of_a ? b : a;
        for (int face = 0; face < faces_of(*one.shape); ++face) {
            const double gap = gap_along(one, other, face);
            if (gap > 0) return;
            if (gap <= best.gap) continue;
            const Triple axis = out_of(one, own_normal(*one.shape, face));
            best = {gap, of_a ? axis : scaled(axis, -1), {of_a, face}};
        }
    }
    if (!look_at_edges(a, b, best)) return;
    found.normal = best.axis;
    if (best.edges)
        touch_by_edges(a, b, best, found);
    else
        touch_by_face(a, b, best, found);
}

}  // namespace floes
