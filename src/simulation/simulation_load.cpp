// What a step of a simulation leaves: the ice load, where it acts, and the histories.

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "simulation/simulation.hpp"

namespace floes {

void Simulation::read_ice_load() {
    ice_load_ = world_.contact_force(structure_);
    if (motion_.is_free()) {
        const PlanarPose& axis = motion_.after();
        ice_moment_ = 0;
        for (const ContactForce& one : structure_contacts_) {
            const Vec3 on_a = one.normal + one.friction;
            const double moment = (one.point.z() - axis.z) * on_a.x() - (one.point.x() - axis.x) * on_a.z();
            ice_moment_ += one.a == structure_ ? moment : -moment;
        }
    }
    if (!ice_load_.allFinite() || !std::isfinite(ice_moment_)) {
        throw MemberFailure(fmt::format("The load on the structure is not a number (t = {:.2f} s).", step_end()));
    }
}

void Simulation::map_contacts() {
    const PlanarPose& axis = motion_.after();  // where contacts were looked for
    for (const ContactForce& one : structure_contacts_) {
        const Vec3 arm = motion_.in_own_axes(one.point - Vec3(axis.x, 0, axis.z));
        const double surge = -motion_.in_own_axes(one.normal + one.friction).x();  // of a; on b the opposite
        contact_bins_.add(arm.x(), arm.y(), arm.z(), one.a == structure_ ? surge : -surge, one.normal.norm());
    }
    hull_loads_.add(structure_contacts_, structure_, motion_);
    ++steps_in_window_;
}

void Simulation::record() {
    const Vec3 load = motion_.in_own_axes(ice_load_);
    loads_.surge.push_back(-load.x());
    loads_.sway.push_back(load.z());
    loads_.heave.push_back(load.y());
    if (motion_.is_free()) record_motion();
    ++steps_;
}

void Simulation::record_motion() {
    const PlanarPose& pose = motion_.after();
    motions_.x.push_back(pose.x);
    motions_.z.push_back(pose.z);
    motions_.yaw.push_back(pose.yaw);
    motions_.yaw_load.push_back(ice_moment_);
    if (!motion_.moored()) return;
    const Vec3& offset = motion_.moored()->state().offset;
    const Vec3 restoring = motion_.moored()->restoring();
    motions_.surge_offset.push_back(-offset[0]);
    motions_.sway_offset.push_back(offset[1]);
    motions_.surge_mooring.push_back(restoring[0]);
    motions_.sway_mooring.push_back(-restoring[1]);
    motions_.yaw_mooring.push_back(-restoring[2]);
    if (!motion_.moored()->has_thrusters()) return;
    const Vec3 thrust = motion_.moored()->thrust();
    motions_.surge_thrust.push_back(thrust[0]);
    motions_.sway_thrust.push_back(-thrust[1]);
    motions_.yaw_thrust.push_back(-thrust[2]);
}

}  // namespace floes
