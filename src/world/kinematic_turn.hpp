#pragma once
// How the structure turns from step to step. Only for files inside this module.

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cmath>
#include <numbers>

#include "core/vector.hpp"

namespace floes {

class KinematicTurn {
  public:
    /// The orientation at this yaw about +y, rad, to which the coming step turns it.
    Quat to(double yaw) {
        turn_ = std::remainder(yaw - yaw_, 2 * std::numbers::pi);
        yaw_ = yaw;
        return yaw == 0 ? Quat::Identity() : Quat(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
    }

    /// It has been put here; a rotation about +y.
    void place(const Mat3& rotation) { yaw_ = std::atan2(rotation(0, 2), rotation(0, 0)); }

    /// Gives the body the velocities of the step that begins. Bullet takes an angle from its cosine, which does not see
    /// 1e-8 rad.
    void save(btRigidBody& structure, double time_step) {
        structure.saveKinematicState(time_step);
        if (turn_ != 0) structure.setAngularVelocity({0, turn_ / time_step, 0});
        turn_ = 0;
    }

  private:
    double yaw_ = 0;
    double turn_ = 0;  ///< of the coming step, rad
};

}  // namespace floes
