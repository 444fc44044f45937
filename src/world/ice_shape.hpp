#pragma once
// An element of ice as Bullet sees it. Only for files inside this module.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <optional>

#include "collision/prism.hpp"
#include "core/vector.hpp"

namespace floes {

/// A prism that is no box. As of btBoxShape the outermost layer, the margin, is a sphere swept over a core that is
/// smaller by as much: flat faces are exact, and corners and rims are rounded by the margin.
ATTRIBUTE_ALIGNED16(class) PrismHull final : public btConvexHullShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    /// Corners in its own x and z about the centre of mass, along principal axes; m.
    PrismHull(const Outline& corners, double half_thickness);

    /// Principal, about the centre of mass, and exact.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;

  private:
    Outline corners_;
    double half_thickness_;
};

class IceShape {
  public:
    IceShape(const Outline& corners, double half_thickness);
    IceShape(const IceShape&) = delete;  // Bullet holds its address
    IceShape& operator=(const IceShape&) = delete;

    btConvexShape& convex() {
        if (box_) return *box_;
        return *hull_;
    }
    const btConvexShape& convex() const { return const_cast<IceShape*>(this)->convex(); }

    /// The same for the narrow phase of ice on ice. A box is as long as Bullet's, which rounds.
    const PrismShape& prism() const { return prism_; }

    /// A point of contact lasts while its halves are nearer than this, m.
    double reach() const { return convex().getContactBreakingThreshold(gContactBreakingThreshold); }

    /// Principal, kg m².
    btVector3 inertia(double mass) const {
        btVector3 inertia;
        convex().calculateLocalInertia(mass, inertia);
        return inertia;
    }

  private:
    std::optional<btBoxShape> box_;
    std::optional<PrismHull> hull_;
    PrismShape prism_;
};

}  // namespace floes
