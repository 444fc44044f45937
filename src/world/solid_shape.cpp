#include "world/solid_shape.hpp"

#include <algorithm>
#include <cmath>

#include "world/conversion.hpp"

namespace floes {
namespace {

double gap_across(const Plane& plane, const BoxBeside& box) {
    return plane.height(box.centre) - (box.axes.transpose() * plane.normal).cwiseAbs().dot(box.half_extent);
}

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

SolidShape::SolidShape(const ConvexSolid& solid) : core_(solid.inside(margin)) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin);
    for (int i = 0; i < 3; ++i) {
        low_[i] = core_.farthest(-Vec3::Unit(i))[i] - margin - margin;
        high_[i] = core_.farthest(Vec3::Unit(i))[i] + margin + margin;
    }
}

double SolidShape::gap_to(const BoxBeside& box) const {
    const Vec3 reach = box.axes.cwiseAbs() * box.half_extent;
    const double apart = std::max((box.centre - reach - high_).maxCoeff(), (low_ - box.centre - reach).maxCoeff());
    if (const auto* round = std::get_if<Frustum>(&core_.form))
        return std::max(apart, gap_across(wall_facing(box.centre, *round), box) - margin);
    double gap = apart;
    for (const Plane& face : std::get<Polyhedron>(core_.form).planes)
        gap = std::max(gap, gap_across(face, box) - margin);
    return gap;
}

btTransform SolidShape::place() const {
    btTransform place = btTransform::getIdentity();
    place.setOrigin(to_bullet(core_.place));
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
