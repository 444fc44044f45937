#pragma once
// A prism of ice as Bullet sees it where it meets the structure, with its exact inertia. Only for files inside this
// room.
//
// As of btBoxShape the outermost layer, the margin, is a sphere swept over a core that is smaller by as much: flat
// faces are exact, and corners and rims are rounded by the margin.

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <deque>
#include <vector>

#include "collision/prism.hpp"
#include "world/definitions.hpp"

namespace floes {

ATTRIBUTE_ALIGNED16(class) PrismHull final : public btConvexHullShape {
  public:
    BT_DECLARE_ALIGNED_ALLOCATOR();

    explicit PrismHull(const PrismDefinition& prism);

    const PrismShape& prism() const {
        return prism_;
    }

    /// Principal, about the centre of mass.
    void calculateLocalInertia(btScalar mass, btVector3 & inertia) const override;

  private:
    PrismShape prism_;
};

/// Hulls, one a body; one that was given back is used for another prism.
class PrismHulls {
  public:
    PrismHull* take(const PrismDefinition& prism);
    void give_back(const btCollisionShape* shape);

  private:
    std::deque<PrismHull> hulls_;
    std::vector<PrismHull*> unused_;
};

}  // namespace floes
