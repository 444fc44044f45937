#include "collision/solid_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

/// A face of the prism, with its corners in order.
struct PrismFace {
    Vec3 normal = Vec3::Zero();
    std::array<Vec3, 2 * most_corners> corners;
    std::size_t count = 0;

    Vec3 middle() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < count; ++k) sum += corners[k];
        return sum / static_cast<double>(count);
    }

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
        const Vec3* const all = prism.begin();
        const auto sides = static_cast<std::size_t>(prism.end() - prism.begin()) / 2;
        if (face < 2) {
            for (std::size_t k = 0; k < sides; ++k) corners[count++] = all[2 * k + face];
            return;
        }
        const std::size_t from = face - 2;
        const std::size_t to = from + 1 < sides ? from + 1 : 0;
        for (const std::size_t k : {2 * from, 2 * to, 2 * to + 1, 2 * from + 1}) corners[count++] = all[k];
    }

    /// Keeps what of it has outward · p <= bound; no more corners than there is room for.
    void cut(const Vec3& outward, double bound) {
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
    }
};

/// Of faces that look at each other less squarely than this, 5 degrees, none lies on the other.
constexpr double squarely = 0.996;

}  // namespace

BearingPoints::BearingPoints(const SolidCore& solid, const PrismCorners& prism, const SolidGap& found) {
    if (const Frustum* of = solid.round())
        on_round(*of, prism, found.normal);
    else
        on_flat(solid.flat(), prism, found.normal);
}

void BearingPoints::on_flat(const Polyhedron& solid, const PrismCorners& prism, const Vec3& normal) {
    std::size_t face = 0;
    for (std::size_t k = 1; k < solid.planes.size(); ++k)
        if (solid.planes[k].normal.dot(normal) > solid.planes[face].normal.dot(normal)) face = k;
    const Plane& plane = solid.planes[face];
    PrismFace ice(prism, normal);
    if (-ice.normal.dot(plane.normal) < squarely || plane.normal.dot(normal) < squarely) return;
    const std::vector<int>& sides = solid.faces[face];
    for (std::size_t k = 0; k < sides.size() && ice.count > 0; ++k) {
        const Vec3& from = solid.corners[static_cast<std::size_t>(sides[k])];
        const Vec3& to = solid.corners[static_cast<std::size_t>(sides[k + 1 < sides.size() ? k + 1 : 0])];
        const Vec3 outward = (to - from).cross(normal);
        ice.cut(outward, outward.dot(from));
    }
    for (std::size_t k = 0; k < ice.count; ++k)
        points_[count_++] = {ice.corners[k], plane.height(ice.corners[k]) / plane.normal.dot(normal)};
}

void BearingPoints::on_round(const Frustum& solid, const PrismCorners& prism, const Vec3& normal) {
    const PrismFace ice(prism, normal);
    if (std::abs(normal.y()) > squarely) {  // an end
        const bool top = normal.y() > 0;
        const double radius = top ? solid.top_radius : solid.bottom_radius;
        const double height = top ? solid.top_height : solid.bottom_height;
        if (-ice.normal.dot(normal) < squarely) return;
        for (std::size_t k = 0; k < ice.count; ++k) {
            const Vec3& corner = ice.corners[k];
            if (corner.x() * corner.x() + corner.z() * corner.z() > radius * radius) continue;
            points_[count_++] = {corner, top ? corner.y() - height : height - corner.y()};
        }
        return;
    }
    const double flat = std::sqrt(normal.x() * normal.x() + normal.z() * normal.z());
    const double cosine = normal.x() / flat;
    const double sine = normal.z() / flat;
    const Vec3 foot(solid.bottom_radius * cosine, solid.bottom_height, solid.bottom_radius * sine);
    const Vec3 rise = Vec3(solid.top_radius * cosine, solid.top_height, solid.top_radius * sine) - foot;
    const double against = ice.normal.dot(normal);
    if (-against < squarely || std::abs(rise.dot(normal)) > 0.09 * rise.norm()) return;
    const Vec3 middle = ice.middle();
    double from = 0;
    double to = 1;
    for (std::size_t k = 0; k < ice.count; ++k) {
        const Vec3& here = ice.corners[k];
        const Vec3& next = ice.corners[k + 1 < ice.count ? k + 1 : 0];
        Vec3 outward = (next - here).cross(normal);
        if (outward.dot(middle - here) > 0) outward = -outward;
        const double over = outward.dot(foot - here);
        const double gain = outward.dot(rise);
        if (gain > 0) to = std::min(to, -over / gain);
        if (gain < 0) from = std::max(from, -over / gain);
        if (gain == 0 && over > 0) return;
    }
    if (from > to) return;
    for (const double share : {from, to}) {
        const Vec3 on_solid = foot + share * rise;
        const double gap = (ice.corners[0] - on_solid).dot(ice.normal) / against;
        points_[count_++] = {on_solid + gap * normal, gap};
    }
}

}  // namespace floes
