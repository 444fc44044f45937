#pragma once
// Between Bullet's bodies, the solver's and the World's. Only for files inside this module.

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btTransformUtil.h>

#include <tuple>

#include "solver/body_motion.hpp"
#include "solver/solver_parts.hpp"
#include "world/conversion.hpp"
#include "world/state.hpp"

namespace floes {

inline std::array<double, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline std::array<double, 9> rows_of(const btMatrix3x3& m) {
    return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

inline SolverState state_of(const btRigidBody& body) {
    const btTransform& pose = body.getWorldTransform();
    return {array_of(pose.getOrigin()), rows_of(pose.getBasis()), array_of(body.getLinearVelocity()),
            array_of(body.getAngularVelocity())};
}

/// Puts a body of Bullet's where it has not come by itself.
inline void place(btRigidBody& body, const BodyState& state) {
    const btTransform transform(to_bullet(state.rotation), to_bullet(state.position));
    body.setWorldTransform(transform);
    body.setInterpolationWorldTransform(transform);  // what Bullet takes the structure's velocity from
    body.setLinearVelocity(to_bullet(state.velocity));
    body.setAngularVelocity(to_bullet(state.angular_velocity));
    body.setInterpolationLinearVelocity(body.getLinearVelocity());
    body.setInterpolationAngularVelocity(body.getAngularVelocity());
    body.updateInertiaTensor();
}

inline SolverState solver_state(const BodyState& state) {
    SolverState to;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        to.position[i] = state.position[at];
        to.velocity[i] = state.velocity[at];
        to.angular_velocity[i] = state.angular_velocity[at];
        for (std::size_t k = 0; k < 3; ++k) to.rotation[3 * i + k] = state.rotation(at, static_cast<Eigen::Index>(k));
    }
    return to;
}

/// The state with its pose moved by a velocity and angular velocity that only open a penetration (split impulse).
inline SolverState pushed(SolverState state, const std::array<double, 6>& push, double time_step) {
    const auto& r = state.rotation;
    const btTransform before(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                             {state.position[0], state.position[1], state.position[2]});
    btTransform after;
    btTransformUtil::integrateTransform(
        before, {push[0], push[1], push[2]},
        btVector3(push[3], push[4], push[5]) * btContactSolverInfo().m_splitImpulseTurnErp, time_step, after);
    state.position = array_of(after.getOrigin());
    state.rotation = rows_of(after.getBasis());
    return state;
}

/// From a SolverState or a BodyMotion.
template <class Motion>
BodyState body_state(const Motion& from) {
    const auto& [p, r, v, w] = std::tie(from.position, from.rotation, from.velocity, from.angular_velocity);
    BodyState state;
    state.position = {p[0], p[1], p[2]};
    state.rotation << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
    state.velocity = {v[0], v[1], v[2]};
    state.angular_velocity = {w[0], w[1], w[2]};
    return state;
}

}  // namespace floes
