#include "collision/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "shapes/elements.hpp"

namespace floes {
namespace {

constexpr double edges_over_faces = 1.05;  // an edge has to be that much better: faces give four points
constexpr double parallel = 1e-4;          // axes that differ by less make no axis of their own

Triple own_normal(const PrismShape& shape, int face) {
    if (face < 2) return {0, face == 0 ? 1.0 : -1.0, 0};
    const Corner& normal = shape.edges[static_cast<std::size_t>(face - 2)].normal;
    return {normal.x, 0, normal.z};
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
    return dot(shape.edges[k].normal, shape.corners[k]);
}

double gap_along(const PrismPlace& one, const PrismPlace& other, int face) {
    const Triple own = own_normal(*one.shape, face);
    const Triple axis = out_of(one, own);
    const Triple between = centre_of(other) - centre_of(one);
    return dot(axis, between) + reach_along(*other.shape, into(other, axis)).low - face_offset(*one.shape, face);
}

/// What a search found: an axis from a to b, of length 1, world.
struct Best {
    double gap;
    Triple axis;
    int face;                     ///< of face_gap(); -1: of two edges
    Triple along_a{}, along_b{};  ///< of these, world
};

// Most axes cannot win. What they would do at most is found first, from few products, in axes of the prisms and without
// a square root; only gaps that may count are found themselves.

constexpr double slack = 1e-9;  // of bounds, m: rounding

/// One of two prisms, and the other as seen from it.
struct View {
    const PrismShape& shape;
    const PrismShape& other;
    Triple x, y, z;  ///< axes of the other
    Triple between;  ///< centres, m

    // Of each edge:
    std::array<double, most_corners> along;  ///< its normal times `between`, m
    std::array<double, most_corners> lean;   ///< its normal times y
    std::array<double, most_corners> climb;  ///< its direction times y

    View(const PrismPlace& one, const PrismPlace& seen)
        : shape(*one.shape), other(*seen.shape), between(to_own(one, centre_of(seen))) {
        const double* r = seen.rotation;
        x = into(one, {r[0], r[3], r[6]});
        y = into(one, {r[1], r[4], r[7]});
        z = into(one, {r[2], r[5], r[8]});
        for (std::size_t k = 0; k < shape.edges.size(); ++k) {
            const Corner& n = shape.edges[k].normal;
            along[k] = n.x * between[0] + n.z * between[2];
            lean[k] = n.x * y[0] + n.z * y[2];
            climb[k] = n.x * y[2] - n.z * y[0];
        }
    }

    /// At least as large as the gap along a face's normal: the other reaches as far as a circle within it.
    void most_gaps(double* gaps) const {
        const auto reach = [&](double up) {
            return other.inner_radius * (1 - up * up) + other.half_thickness * std::abs(up) - slack;
        };
        gaps[0] = between[1] - shape.half_thickness - reach(y[1]);
        gaps[1] = -between[1] - shape.half_thickness - reach(y[1]);
        for (std::size_t k = 0; k < shape.edges.size(); ++k)
            gaps[2 + k] = along[k] - shape.edges[k].half_width - shape.edges[k].middle - reach(lean[k]);
    }

    /// Whether edge k and the thickness of the other may have a gap of more than -depth: by that circle, then by
    /// corners.
    bool edge_may_win(std::size_t k, double depth) const {
        const double flat = std::abs(y[1]);
        const double rise = y[1] < 0 ? lean[k] : -lean[k];
        const double at = flat * (along[k] - shape.edges[k].middle) + rise * between[1];
        const double reach = flat * shape.edges[k].half_width + shape.half_thickness * std::abs(rise) - slack;
        if (std::abs(at) - reach - other.inner_radius * (1 - climb[k] * climb[k]) + depth < 0) return false;
        const Corner& n = shape.edges[k].normal;
        const Triple axis{flat * (n.x * x[0] + n.z * x[2]) + rise * x[1], 0,
                          flat * (n.x * z[0] + n.z * z[2]) + rise * z[1]};
        const auto [low, high] = reach_along(other, axis);
        const double gap = std::max(at + low, -at - high) - reach;
        return gap * std::abs(gap) + depth * depth * dot(axis, axis) > 0;
    }
};

/// Which axes of an edge of a with those of b may have a gap of more than -depth: positive where they may. Edge 0 is
/// the thickness, 1 + k that of the polygon.
using EdgeRow = std::array<double, 1 + most_corners>;

/// The flat part of such an axis is a normal of the edge in each prism, along which its polygon's reach is known.
void look_along_edge(const View& a, const View& b, std::size_t i, double depth, EdgeRow& may) {
    const Corner& n = a.shape.edges[i].normal;
    const Corner normal{n.x * a.x[0] + n.z * a.x[2], n.x * a.z[0] + n.z * a.z[2]};  // of the edge, in the axes of b
    const Corner along{n.x * a.x[2] - n.z * a.x[0], n.x * a.z[2] - n.z * a.z[0]};   // and its direction
    const double middle = a.along[i] - a.shape.edges[i].middle;
    const double half_width = a.shape.edges[i].half_width;
    const double height = a.between[1];
    const double by_b = a.climb[i];
    const double half_a = a.shape.half_thickness;
    const double half_b = b.shape.half_thickness;
    const std::size_t count = b.shape.edges.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Corner& m = b.shape.edges[k].normal;
        const double up_a = cross(m, normal);
        const double up_b = dot(m, along);
        const double by_a = b.climb[k];
        const double reach = std::abs(by_a) * half_width + std::abs(by_b) * b.shape.edges[k].half_width +
                             std::abs(up_a) * half_a + std::abs(up_b) * half_b;
        const double gap = std::abs(up_a * height - by_a * middle + by_b * b.shape.edges[k].middle) - reach;
        may[1 + k] = gap * std::abs(gap) + depth * depth * (up_a * up_a + by_a * by_a);
    }
}

void look_along(const View& a, const View& b, std::size_t edge, double depth, EdgeRow& may) {
    if (edge > 0) {
        may[0] = a.edge_may_win(edge - 1, depth) ? 1 : -1;
        return look_along_edge(a, b, edge - 1, depth, may);
    }
    const double at = a.y[2] * a.between[0] - a.y[0] * a.between[2];
    const double least = std::max(a.shape.inner_radius + b.shape.inner_radius - depth, 0.0);
    may[0] = at * at - least * least * (a.y[0] * a.y[0] + a.y[2] * a.y[2]);
    for (std::size_t k = 0; k < b.shape.edges.size(); ++k) may[1 + k] = b.edge_may_win(k, depth) ? 1 : -1;
}

/// Direction of an edge: of the thickness, then along each edge of the polygon, world.
Triple edge_direction(const PrismPlace& prism, std::size_t edge) {
    if (edge == 0) return out_of(prism, {0, 1, 0});
    const Corner& normal = prism.shape->edges[edge - 1].normal;
    return out_of(prism, {-normal.z, 0, normal.x});
}

/// False where an axis of two edges parts them.
bool look_at_edges(const PrismPlace& a, const PrismPlace& b, const View& from_a, const View& from_b, Best& best) {
    const Triple tilt = cross(out_of(a, {0, 1, 0}), out_of(b, {0, 1, 0}));
    if (dot(tilt, tilt) < parallel * parallel) return true;  // flat on each other: edges say what faces say
    EdgeRow may;
    const Triple between = centre_of(b) - centre_of(a);
    for (std::size_t i = 0; i <= a.shape->edges.size(); ++i) {
        look_along(from_a, from_b, i, slack - best.gap / edges_over_faces, may);
        for (std::size_t k = 0; k <= b.shape->edges.size(); ++k) {
            if (!(may[k] > 0)) continue;
            const Triple along_a = edge_direction(a, i);
            const Triple along_b = edge_direction(b, k);
            Triple axis = cross(along_a, along_b);
            const double length = std::sqrt(dot(axis, axis));
            if (length < parallel) continue;
            axis = (1 / length) * axis;
            const Reach at_a = reach_along(*a.shape, into(a, axis));
            const Reach at_b = reach_along(*b.shape, into(b, axis));
            const double apart = dot(axis, between);
            const double onward = apart + at_b.low - at_a.high;
            const double back = at_a.low - at_b.high - apart;
            const double gap = std::max(onward, back);
            if (gap > 0) return false;
            if (!(gap * edges_over_faces > best.gap)) continue;
            best = {gap, onward >= back ? axis : -1 * axis, -1, along_a, along_b};
        }
    }
    return true;
}

void touch_by_edges(const PrismPlace& a, const PrismPlace& b, const Best& best, Overlap& found) {
    const Triple on_a = farthest(a, best.axis);
    Triple on_b = farthest(b, -1 * best.axis);
    const Triple between = on_b - on_a;
    const double together = dot(best.along_a, best.along_b);
    const double rest = 1 - together * together;
    if (rest > 1e-4)
        on_b = on_b + ((together * dot(best.along_a, between) - dot(best.along_b, between)) / rest) * best.along_b;
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

/// What of `polygon` lies below the bound along the normal, into `rest`; false where all of it does.
bool cut(const Points& polygon, Points& rest, const Triple& normal, double bound) {
    std::array<double, Points::room + 1> room;
    const std::size_t count = polygon.size();
    bool whole = true;
    for (std::size_t k = 0; k < count; ++k) {
        room[k] = bound - dot(normal, polygon[k]);
        whole = whole && room[k] >= 0;
    }
    if (whole) return false;
    room[count] = room[0];
    rest.keep(0);
    for (std::size_t k = 0; k < count; ++k) {
        const Triple& here = polygon[k];
        if (room[k] >= 0) rest.add(here);
        if ((room[k] >= 0) == (room[k + 1] >= 0)) continue;
        const Triple& next = polygon[k + 1 < count ? k + 1 : 0];
        rest.add(here + (room[k] / (room[k] - room[k + 1])) * (next - here));
    }
    return true;
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
    const bool of_a = best.face < face_axes(*a.shape);
    const PrismPlace& one = of_a ? a : b;
    const PrismPlace& other = of_a ? b : a;
    const Triple out = of_a ? best.axis : -1 * best.axis;
    const Triple seen = into(other, out);
    const int edge = edge_towards(*other.shape, -1 * seen);
    const int incident = edge >= 0 ? edge + 2 : seen[1] > 0 ? 1 : 0;
    std::array<Points, 2> buffers;
    std::size_t now = 0;
    corners_of(other, incident, buffers[now]);
    const Triple centre = centre_of(one);
    const auto cut_by = [&](const Triple& own, double offset) {
        const Triple normal = out_of(one, own);
        if (cut(buffers[now], buffers[1 - now], normal, offset + dot(normal, centre))) now = 1 - now;
    };
    const int face = of_a ? best.face : best.face - face_axes(*a.shape);
    if (face < 2) {
        for (int k = 2; k < face_axes(*one.shape); ++k) cut_by(own_normal(*one.shape, k), face_offset(*one.shape, k));
    } else {
        const auto k = static_cast<std::size_t>(face - 2);
        const Corner& normal = one.shape->edges[k].normal;
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
        to.on_b = of_a ? points[from] : points[from] + depth[from] * out;
    }
}

}  // namespace

int face_axes(const PrismShape& of) {
    return 2 + static_cast<int>(of.corners.size());
}

double face_gap(const PrismPlace& a, const PrismPlace& b, int axis) {
    const int of_a = face_axes(*a.shape);
    return axis < of_a ? gap_along(a, b, axis) : gap_along(b, a, axis - of_a);
}

namespace {

FaceGap widest_gap(const PrismPlace& a, const PrismPlace& b, const View& from_a, const View& from_b, int first,
                   int end) {
    std::array<double, 2 * (2 + most_corners)> most;
    from_a.most_gaps(most.data());
    from_b.most_gaps(most.data() + face_axes(*a.shape));
    const auto likely = static_cast<int>(std::max_element(most.begin() + first, most.begin() + end) - most.begin());
    FaceGap widest{face_gap(a, b, likely), likely};
    for (int axis = first; axis < end; ++axis) {
        if (axis == likely || most[static_cast<std::size_t>(axis)] < widest.gap) continue;
        const double gap = face_gap(a, b, axis);
        if (gap > widest.gap || (gap == widest.gap && axis < widest.axis)) widest = {gap, axis};
    }
    return widest;
}

}  // namespace

FaceGap widest_face_gap(const PrismPlace& a, const PrismPlace& b, int first, int end) {
    return widest_gap(a, b, View(a, b), View(b, a), first, end);
}

void find_overlap(const PrismPlace& a, const PrismPlace& b, Overlap& found) {
    if (a.shape->is_box && b.shape->is_box) return find_box_overlap(a, b, found);
    found.count = 0;
    const View from_a(a, b);
    const View from_b(b, a);
    const int of_a = face_axes(*a.shape);
    const auto [gap, face] = widest_gap(a, b, from_a, from_b, 0, of_a + face_axes(*b.shape));
    if (gap > 0) return;
    Best best{gap,
              face < of_a ? out_of(a, own_normal(*a.shape, face)) : -1 * out_of(b, own_normal(*b.shape, face - of_a)),
              face};
    if (!look_at_edges(a, b, from_a, from_b, best)) return;
    found.normal = best.axis;
    if (best.face < 0)
        touch_by_edges(a, b, best, found);
    else
        touch_by_face(a, b, best, found);
}

}  // namespace floes
