#include "world/bullet_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

PrismHull::PrismHull(const Outline& corners, double half_thickness)
    : corners_(corners), half_thickness_(half_thickness) {
    const double share = 0.1;  // of the smallest half extent, as of a btBoxShape
    const double margin = share * std::min(half_thickness, inner_radius(corners));
    const double half = half_thickness - margin;
    for (const Corner& one : eroded(corners, margin)) {
        addPoint({one.x, half, one.z}, false);
        addPoint({one.x, -half, one.z}, false);
    }
    setMargin(margin);
    recalcLocalAabb();
}

void PrismHull::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
    const Measures of = measures_of(corners_);
    const double thin = half_thickness_ * half_thickness_ / 3;
    inertia = mass * btVector3(of.zz / of.area + thin, (of.xx + of.zz) / of.area, of.xx / of.area + thin);
}

namespace {

/// Half the sides of a rectangle about its centre of mass and along its axes, wherever its corners begin.
std::optional<Corner> half_sides(const Outline& corners) {
    if (corners.size() != 4) return {};
    const Corner half{0.5 * std::abs(corners[0].x - corners[2].x), 0.5 * std::abs(corners[0].z - corners[2].z)};
    const auto fits = [&](const Corner& one) {
        return std::abs(std::abs(one.x) - half.x) < length_rounding &&
               std::abs(std::abs(one.z) - half.z) < length_rounding;
    };
    return std::ranges::all_of(corners, fits) ? std::optional(half) : std::nullopt;
}

}  // namespace

IceShape::IceShape(const Outline& corners, double half_thickness) {
    if (const std::optional<Corner> half = half_sides(corners)) {
        box_.emplace(btVector3(half->x, half_thickness, half->z));
        const btVector3 with_margin = box_->getHalfExtentsWithMargin();
        prism_ = PrismShape(corners_of(with_margin.x(), with_margin.z()), with_margin.y());
    } else {
        hull_.emplace(corners, half_thickness);
        prism_ = PrismShape(corners, half_thickness);
    }
    const double margin = convex().getMargin();
    core_ = {eroded(prism_.corners, margin), prism_.half_thickness - margin, margin};
}

namespace {

/// The plane that touches the wall where it faces the point.
Plane wall_facing(const Vec3& point, const Frustum& round) {
    const double across = std::hypot(point.x(), point.z());
    const double rise = round.top_height - round.bottom_height;
    const double ahead = across > 0 ? point.x() / across : 1;
    const double aside = across > 0 ? point.z() / across : 0;
    const Vec3 normal = Vec3(rise * ahead, round.bottom_radius - round.top_radius, rise * aside).normalized();
    return {normal, normal.dot(round.farthest(normal))};
}

}  // namespace

SolidShape::SolidShape(const ConvexSolid& solid) : core_(solid.inside(margin)), place_(solid.place) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin);
    for (int i = 0; i < 3; ++i) {
        low_[i] = core_.farthest(-Vec3::Unit(i))[i] - margin - margin;
        high_[i] = core_.farthest(Vec3::Unit(i))[i] + margin + margin;
    }
}

double SolidShape::gap_to(const btTransform& box, const Triple& half_extent) const {
    const Vec3 centre = from_bullet(box.getOrigin());
    const Mat3 axes = from_bullet(box.getBasis());
    const Vec3 half(half_extent[0], half_extent[1], half_extent[2]);
    const Vec3 reach = axes.cwiseAbs() * half;
    const auto across = [&](const Plane& plane) {
        return plane.height(centre) - (axes.transpose() * plane.normal).cwiseAbs().dot(half) - margin;
    };
    double gap = std::max((centre - reach - high_).maxCoeff(), (low_ - centre - reach).maxCoeff());
    if (const Frustum* round = core_.round()) return std::max(gap, across(wall_facing(centre, *round)));
    for (const Plane& face : core_.flat().planes) gap = std::max(gap, across(face));
    return gap;
}

btTransform SolidShape::place() const {
    btTransform place = btTransform::getIdentity();
    place.setOrigin(to_bullet(place_));
    return place;
}

btVector3 SolidShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
    return to_bullet(core_.farthest(from_bullet(direction)));
}

void SolidShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices,
                                                                   int count) const {
    for (int i = 0; i < count; ++i) vertices[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void SolidShape::calculateLocalInertia(btScalar, btVector3& inertia) const {
    inertia.setZero();
}

}  // namespace floes
