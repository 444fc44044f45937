#pragma once
// A convex solid of the structure as a smooth shape for collision. Only for files inside this module.
//
// Known to Bullet by its support function, so a contact normal on a round wall is its true normal and does not step
// from facet to facet. As with all round shapes of Bullet the outermost layer, the margin, is a sphere swept over a
// core. The core is smaller such that the wall is exact; flat ends of a round solid stand out by the margin and rims
// are rounded with it. All faces of a polyhedron are exact, and its edges rounded; one that is thinner than twice the
// margin stands out by it.

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include "shapes/convex_solid.hpp"

namespace floes {

/// A box that may touch a solid, in the solid's axes. Lengths in m.
struct BoxBeside {
    Vec3 centre;
    Mat3 axes;  ///< of the box, as columns
    Vec3 half_extent;
};

ATTRIBUTE_ALIGNED16(class) SolidShape final : public btConvexInternalShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    /// Below this depth (with the margin of the other shape) contact is found exactly, without Bullet's EPA. In units
    /// of the World, 1 mm beside ice as thick as the paper's.
    static constexpr double margin = 1e-3;

    explicit SolidShape(const ConvexSolid& solid);

    /// In the structure.
    btTransform place() const;

    /// No point of the box is nearer, m; 0 or less where it may touch. The width of the gap across one plane: a face of
    /// a polyhedron, the wall of a round solid where it faces the box, or the bounds of either.
    double gap_to(const BoxBeside& box) const;

    /// As btConvexInternalShape finds them along the solid's own axes, with the margin twice.
    const Vec3& low() const {
        return low_;
    }
    const Vec3& high() const {
        return high_;
    }

    btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
    void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* vertices, int count)
        const override;
    /// Zero: the structure is moved, not pushed.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;
    const char* getName() const override {
        return "ConvexSolid";
    }

  private:
    ConvexSolid core_;
    Vec3 low_;
    Vec3 high_;
};

}  // namespace floes
