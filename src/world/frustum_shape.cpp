#include "world/frustum_shape.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

namespace {

/// The frustum whose wall lies `depth` inside the given one, measured along the wall's normal.
Frustum inside(const Frustum& f, double depth) {
    const double rise = f.top_height - f.bottom_height;
    const double spread = f.top_radius - f.bottom_radius;
    const double inset = depth * std::hypot(rise, spread) / rise;  // along the radius
    Frustum core = f;
    core.bottom_radius = std::max(0.0, f.bottom_radius - inset);
    core.top_radius = std::max(0.0, f.top_radius - inset);
    // Where the wall meets the axis the tip moves along it.
    if (f.bottom_radius < inset)
        core.bottom_height += std::min(rise, (inset - f.bottom_radius) * rise / std::abs(spread));
    if (f.top_radius < inset) core.top_height -= std::min(rise, (inset - f.top_radius) * rise / std::abs(spread));
    return core;
}

}  // namespace

FrustumShape::FrustumShape(const Frustum& frustum) : core_(inside(frustum, margin)) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin);
}

btVector3 FrustumShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
    const double across = std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
    const double bottom = core_.bottom_radius * across + core_.bottom_height * direction.y();
    const double top = core_.top_radius * across + core_.top_height * direction.y();
    const double radius = top > bottom ? core_.top_radius : core_.bottom_radius;
    const double height = top > bottom ? core_.top_height : core_.bottom_height;
    if (across == 0) return {radius, height, 0};
    return {radius * direction.x() / across, height, radius * direction.z() / across};
}

void FrustumShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices,
                                                                     int count) const {
    for (int i = 0; i < count; ++i) vertices[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void FrustumShape::calculateLocalInertia(btScalar, btVector3& inertia) const {
    inertia.setZero();
}

}  // namespace floes
