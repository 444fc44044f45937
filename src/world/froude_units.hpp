#pragma once
// Between SI, in which a World is spoken to, and the units in which it computes. Only for files inside this module.
//
// Bullet has lengths of its own, fixed for bodies of centimetres to a metre: contact points live up to 20 mm, shapes
// have margins of millimetres, its narrow phase has tolerances. So a World, its solvers included, measures lengths in a
// unit u (m) that grows with the ice, times in √u (s) and masses in kg: accelerations and forces have the same numbers
// in both. A scene scaled by Froude, lengths by s and times by √s, then has the same lengths, times and speeds again,
// at s³ times the masses and forces. Whatever a definition has with another unit needs its line in the .cpp.

#include <cmath>

#include "shapes/convex_solid.hpp"
#include "solver/carried_water.hpp"
#include "world/definitions.hpp"
#include "world/state.hpp"

namespace floes {

class FroudeUnits {
  public:
    /// length: u, m, above 0. 1 is SI, to the bit.
    explicit FroudeUnits(double length) : length_(length), time_(std::sqrt(length)) {}

    Vec3 to_own(const Vec3& position) const { return position / length_; }
    Pose to_own(const Pose& pose) const { return {to_own(pose.position), pose.orientation}; }
    WorldDefinition to_own(WorldDefinition definition) const;
    ElementDefinition to_own(ElementDefinition element) const;
    FixedBoxDefinition to_own(FixedBoxDefinition box) const;
    SlidingBoxDefinition to_own(SlidingBoxDefinition box) const;
    JointDefinition to_own(JointDefinition joint) const;
    ConvexSolid to_own(const ConvexSolid& solid) const { return solid.scaled(1 / length_); }
    CarriedWater to_own(CarriedWater water) const;
    BodyState to_own(const BodyState& state) const;
    Wrench to_own(const Wrench& wrench) const { return {wrench.force, wrench.moment / length_}; }

    Vec3 to_si(const Vec3& position) const { return position * length_; }
    BodyState to_si(const BodyState& state) const;
    JointReaction to_si(JointReaction reaction) const;

  private:
    double length_;
    double time_;
};

}  // namespace floes
