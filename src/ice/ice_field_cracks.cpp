// How joints of an IceField fail: at once by moment, or as cracks by stress.

#include <algorithm>
#include <cmath>

#include "ice/ice_field.hpp"

namespace floes {
namespace {

Vec2 horizontal(const Vec3& v) {
    return {v.x(), v.z()};
}

}  // namespace

IceField::Turned IceField::turned(const World& world, const Joint& joint) const {
    const auto first = static_cast<std::size_t>(floe_of(joint).first);
    const BodyState a = world.state(elements_[first + static_cast<std::size_t>(joint.grid.a)].body);
    const BodyState b = world.state(elements_[first + static_cast<std::size_t>(joint.grid.b)].body);
    const Mat3 axes = floe_axes(joint, joint.grid.a, a);
    const Mat3 between = axes.transpose() * floe_axes(joint, joint.grid.b, b);
    const Vec2 angles(0.5 * (between(2, 1) - between(1, 2)), 0.5 * (between(1, 0) - between(0, 1)));
    const double angle = angles.norm();
    if (!(angle > 0)) return {};
    return {angle, angles.dot(horizontal(axes.transpose() * (b.angular_velocity - a.angular_velocity))) / angle};
}

std::optional<FailureMode> IceField::failing(World& world, Joint& joint) {
    const JointStrength& strength = strength_of(joint);
    if (!by_stress_) {
        const JointReaction reaction = world.reaction(joint.id);
        peaks_ = raised(peaks_, reaction);
        return failure(reaction, strength.thresholds);
    }
    peaks_ = raised(peaks_, stress_.reaction(joint.place));
    if (joint.crack) return crack_on(world, joint);
    if (!may_fail(stress_.reaction(joint.place), stress_.across(joint.place), stress_.most_by_contacts(joint.place),
                  strength.section, strength.thresholds))
        return std::nullopt;
    const JointLoad load = stress_.load(world, joint.place);
    const Utilisation used = utilisation(load, strength.section, strength.thresholds);
    if (!(used.share > 1)) return std::nullopt;
    if (used.mode != FailureMode::bending) return used.mode;
    const Turned now = turned(world, joint);
    const double smooth = fibre_stress(smoothed(load), strength.section) / strength.section.flexural_strength;
    const double over =
        cracking(used.share, smooth, strength.stiffness, now.angle, strength.crack_energy, strength.length_over_span);
    if (!(over > 1)) return std::nullopt;
    floes_[static_cast<std::size_t>(joint.floe)].cracked = true;
    joint.crack.emplace(cohesive_law(strength.stiffness, now.angle / over, strength.crack_energy));
    return crack_on(world, joint);
}

std::optional<FailureMode> IceField::crack_on(World& world, Joint& joint) {
    const Turned now = turned(world, joint);
    Crack& crack = *joint.crack;
    const double sound = crack.sound();
    const double energy = crack.energy();
    crack.follow(now.angle, now.rate, time_step_);
    fracture_work_ += crack.energy() - energy;
    if (crack.is_open()) return FailureMode::bending;
    if (crack.sound() < sound) world.soften_joint(joint.id, crack.sound());
    // Cracked ice still shears off, and a thrust still crushes it.
    return failure(without_bending(stress_.reaction(joint.place)), strength_of(joint).thresholds);
}

void IceField::read_utilisation(const World& world, std::vector<double>& worst) const {
    worst.assign(elements_.size(), 0.0);
    for (const Joint& joint : joints_) {
        const Sheet& sheet = floe_of(joint);
        double used = 0;
        if (!by_stress_)
            used = utilisation(world.reaction(joint.id), sheet.of(joint).thresholds);
        else if (joint.crack)
            used = 2 - joint.crack->sound();
        else
            used = utilisation(stress_.load(world, joint.place), sheet.of(joint).section, sheet.of(joint).thresholds)
                       .share;
        const auto first = static_cast<std::size_t>(sheet.first);
        for (const int index : {joint.grid.a, joint.grid.b}) {
            double& element = worst[first + static_cast<std::size_t>(index)];
            element = std::max(element, used);
        }
    }
}

}  // namespace floes
