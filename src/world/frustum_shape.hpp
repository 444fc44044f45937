#pragma once
// A frustum as a smooth convex shape for collision. Only for files inside this room.
//
// Two circles about the y axis and their convex hull, known to Bullet by its support function, so a contact normal on
// the wall is the true normal of the cone and does not step from facet to facet. As with all round shapes of Bullet the
// outermost layer, the margin, is a sphere swept over a core. The core is smaller such that the wall is exact; the flat
// ends stand out by the margin and rims are rounded with it.

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include "core/frustum.hpp"

namespace floes {

ATTRIBUTE_ALIGNED16(class) FrustumShape final : public btConvexInternalShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    /// Below this depth (with the margin of the other shape) contact is found exactly, without Bullet's EPA. 1 mm.
    static constexpr double margin = 1e-3;

    explicit FrustumShape(const Frustum& frustum);

    btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
    void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices, int count)
        const override;
    /// Zero: the structure is moved, not pushed.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;
    const char* getName() const override {
        return "Frustum";
    }

  private:
    Frustum core_;
};

}  // namespace floes
