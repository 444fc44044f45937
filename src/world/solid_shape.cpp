#include "world/solid_shape.hpp"

#include "world/conversion.hpp"

namespace floes {

SolidShape::SolidShape(const ConvexSolid& solid) : core_(solid.inside(margin)) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin);
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
