#include "collision/solid_faces.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace floes {
namespace {

// Faces and edges lie on each other where they are parallel within 5 degrees: the cosine of that, and its sine.
constexpr double squarely = 0.996;
constexpr double level = 0.087;

/// A face of the prism, with its corners in order.
struct PrismFace {
    Vec3 normal = Vec3::Zero();
    std::array<Vec3, 2 * most_corners> corners;
    std::size_t count = 0;

    /// That which looks against `direction` most squarely.
    PrismFace(const PrismCorners& prism, const Vec3& direction) {
        std::size_t face = 0;
        double against = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < prism.faces(); ++k) {
            const double along = prism.face_normal(k).dot(direction);
            if (along >= against) continue;
            against = along;
            face = k;
        }
        normal = prism.face_normal(face);
        const std::span all = prism.corners();
        const std::size_t sides = all.size() / 2;
        if (face < 2) {
            for (std::size_t k = 0; k < sides; ++k) corners[count++] = all[2 * k + face];
            return;
        }
        const std::size_t from = face - 2;
        const std::size_t to = from + 1 < sides ? from + 1 : 0;
        for (const std::size_t k : {2 * from, 2 * to, 2 * to + 1, 2 * from + 1}) corners[count++] = all[k];
    }

    bool faces(const Vec3& direction) const { return -normal.dot(direction) >= squarely; }

    /// Keeps what of it has outward · p <= bound, no more corners than there is room for; false where that is nothing.
    bool cut(const Vec3& outward, double bound) {
        const std::array<Vec3, 2 * most_corners> before = corners;
        const std::size_t sides = count;
        count = 0;
        for (std::size_t k = 0; k < sides; ++k) {
            const Vec3& here = before[k];
            const Vec3& next = before[k + 1 < sides ? k + 1 : 0];
            const double over = outward.dot(here) - bound;
            const double beyond = outward.dot(next) - bound;
            if (over <= 0 && count < corners.size()) corners[count++] = here;
            if ((over < 0 && beyond > 0) || (over > 0 && beyond < 0))
                if (count < corners.size()) corners[count++] = here + over / (over - beyond) * (next - here);
        }
        return count > 0;
    }
};

/// A straight line from end to end.
struct Line {
    Vec3 from, to;

    /// Keeps what of it has outward · p <= bound; false where that is nothing.
    bool cut(const Vec3& outward, double bound) {
        const double over = outward.dot(from) - bound;
        const double beyond = outward.dot(to) - bound;
        if (over > 0 && beyond > 0) return false;
        const Vec3 between = from + over / (over - beyond) * (to - from);
        if (over > 0) from = between;
        if (beyond > 0) to = between;
        return true;
    }

    bool lies_across(const Vec3& normal) const {
        return std::abs((to - from).dot(normal)) <= level * (to - from).norm();
    }
};

/// Keeps what of the line or face lies before a convex face with these corners, seen along the normal.
template <class Shape, class Corner>
bool cut_by_sides(Shape& shape, std::size_t count, const Vec3& normal, const Corner& corner) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < count; ++k) middle += corner(k) / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3& from = corner(k);
        Vec3 outward = (corner(k + 1 < count ? k + 1 : 0) - from).cross(normal);
        if (outward.dot(middle - from) > 0) outward = -outward;
        if (!shape.cut(outward, outward.dot(from))) return false;
    }
    return true;
}

/// Ends of what of a line of the solid lies below a face of the ice, as points of that and gaps along the normal.
template <class Take>
void for_ends_below(const PrismFace& ice, Line line, const Vec3& normal, const Take& take) {
    if (!cut_by_sides(line, ice.count, normal, [&](std::size_t k) -> const Vec3& { return ice.corners[k]; })) return;
    for (const Vec3& end : {line.from, line.to}) {
        const double gap = (ice.corners[0] - end).dot(ice.normal) / ice.normal.dot(normal);
        take(end + gap * normal, gap);
    }
}

/// The edge at the corner that lies least far along the normal, that which rises least from there.
Line lowest_edge(const PrismCorners& prism, const Vec3& normal) {
    const std::span all = prism.corners();
    const std::size_t count = all.size();
    std::size_t lowest = 0;
    for (std::size_t k = 1; k < count; ++k)
        if (normal.dot(all[k]) < normal.dot(all[lowest])) lowest = k;
    Line best{all[lowest], all[lowest]};
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : {lowest ^ 1U, (lowest + 2) % count, (lowest + count - 2) % count}) {
        const Vec3 along = all[k] - all[lowest];
        const double rise = normal.dot(along) / along.norm();
        if (rise >= least) continue;
        least = rise;
        best.to = all[k];
    }
    return best;
}

/// The edge of a polyhedron at its farthest corner along the normal, that which falls least from there.
std::optional<Line> highest_edge(const SolidCore& solid, const Vec3& normal) {
    const Vec3 top = solid.farthest(normal);
    std::optional<Line> best;
    double least = std::numeric_limits<double>::infinity();
    for (const SolidCore::Edge& edge : solid.edges()) {
        Line line{edge.end, edge.end + edge.along};
        if (normal.dot(line.to) > normal.dot(line.from)) std::swap(line.from, line.to);
        const double fall = normal.dot(line.from - line.to) / edge.length;
        if (normal.dot(top - line.from) > length_rounding || fall >= least) continue;
        least = fall;
        best = line;
    }
    return best;
}

}  // namespace

BearingPoints::BearingPoints(const SolidCore& solid, const PrismCorners& prism, const SolidGap& found) {
    const Frustum* of = solid.round();
    if (of == nullptr)
        on_flat(solid, prism, found.normal);
    else if (std::abs(found.normal.y()) > squarely)
        on_end(*of, prism, found.normal.y() > 0);
    else
        on_wall(*of, prism, found.normal);
}

void BearingPoints::on_flat(const SolidCore& solid, const PrismCorners& prism, const Vec3& normal) {
    const Polyhedron& body = solid.flat();
    std::size_t face = 0;
    for (std::size_t k = 1; k < body.planes.size(); ++k)
        if (body.planes[k].normal.dot(normal) > body.planes[face].normal.dot(normal)) face = k;
    const Plane& plane = body.planes[face];
    const std::vector<int>& sides = body.faces[face];
    const auto corner = [&](std::size_t k) -> const Vec3& { return body.corners[static_cast<std::size_t>(sides[k])]; };
    const auto add_above_face = [&](const Vec3& point) { add(point, plane.height(point) / plane.normal.dot(normal)); };
    PrismFace ice(prism, normal);
    if (plane.normal.dot(normal) >= squarely) {
        if (ice.faces(normal)) {
            cut_by_sides(ice, sides.size(), normal, corner);
            for (std::size_t k = 0; k < ice.count; ++k) add_above_face(ice.corners[k]);
            return;
        }
        Line edge = lowest_edge(prism, normal);
        if (!edge.lies_across(normal) || !cut_by_sides(edge, sides.size(), normal, corner)) return;
        for (const Vec3& end : {edge.from, edge.to}) add_above_face(end);
    } else if (ice.faces(normal)) {
        const std::optional<Line> edge = highest_edge(solid, normal);
        if (edge && edge->lies_across(normal))
            for_ends_below(ice, *edge, normal, [&](const Vec3& at, double gap) { add(at, gap); });
    }
}

void BearingPoints::on_end(const Frustum& solid, const PrismCorners& prism, bool top) {
    const double radius = top ? solid.top_radius : solid.bottom_radius;
    for (const Vec3& one : prism.corners())
        if (one.x() * one.x() + one.z() * one.z() <= radius * radius)
            add(one, top ? one.y() - solid.top_height : solid.bottom_height - one.y());
}

void BearingPoints::on_wall(const Frustum& solid, const PrismCorners& prism, const Vec3& normal) {
    const double flat = std::sqrt(normal.x() * normal.x() + normal.z() * normal.z());
    const double cosine = normal.x() / flat;
    const double sine = normal.z() / flat;
    const Line wall{Vec3(solid.bottom_radius * cosine, solid.bottom_height, solid.bottom_radius * sine),
                    Vec3(solid.top_radius * cosine, solid.top_height, solid.top_radius * sine)};
    if (!wall.lies_across(normal)) return;
    const PrismFace ice(prism, normal);
    if (ice.faces(normal)) {
        for_ends_below(ice, wall, normal, [&](const Vec3& at, double gap) { add(at, gap); });
        return;
    }
    const Line edge = lowest_edge(prism, normal);
    for (const Vec3& end : {edge.from, edge.to}) {
        if (end.y() < solid.bottom_height || end.y() > solid.top_height) continue;
        const double across = std::sqrt(end.x() * end.x() + end.z() * end.z()) - solid.radius_at(end.y());
        add(end, across * flat);
    }
}

}  // namespace floes
