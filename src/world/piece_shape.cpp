#include "world/piece_shape.hpp"

#include "world/conversion.hpp"

namespace floes {

PieceShape::PieceShape(const ConvexPiece& piece) : core_(piece.inside(margin)) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(margin);
}

btVector3 PieceShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
    return to_bullet(core_.farthest(from_bullet(direction)));
}

void PieceShape::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices,
                                                                   int count) const {
    for (int i = 0; i < count; ++i) vertices[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void PieceShape::calculateLocalInertia(btScalar, btVector3& inertia) const {
    inertia.setZero();
}

}  // namespace floes
