#pragma once
// Prisms that move at random, for us and for Bullet.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <LinearMath/btTransform.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "collision/prism.hpp"
#include "solver/body_motion.hpp"

namespace floes::test {

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max()));
    }
    btVector3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  private:
    std::mt19937 engine_;
};

/// About the origin, with a corner half a turn between corners from +x.
inline Outline regular(int corners, double radius) {
    Outline outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / corners;
        outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return outline;
}

/// Moves the pose by `step` and turns it by `turn`, rad.
inline btTransform moved(const btTransform& pose, const btVector3& step, const btVector3& turn) {
    const double angle = turn.length();
    const btQuaternion by = angle > 0 ? btQuaternion(turn / angle, angle) : btQuaternion::getIdentity();
    return btTransform((by * pose.getRotation()).normalized(), pose.getOrigin() + step);
}

/// With the way and the turn that led there.
inline BodyMotion motion_of(const btTransform& pose, const btVector3& step = {0, 0, 0},
                            const btVector3& turn = {0, 0, 0}) {
    BodyMotion motion{};
    for (int i = 0; i < 3; ++i) {
        motion.position[i] = pose.getOrigin()[i];
        for (int k = 0; k < 3; ++k) motion.rotation[3 * i + k] = pose.getBasis()[i][k];
    }
    motion.way = step.length();
    motion.turn = turn.length();
    return motion;
}

inline PrismShape prism_of(const btBoxShape& shape) {
    const btVector3 half = shape.getHalfExtentsWithMargin();
    return {corners_of(half.x(), half.z()), half.y()};
}

}  // namespace floes::test
