#include "shapes/moorings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floes {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// On the curve, straight on beyond its ends but never below 0.
double on_curve(const std::vector<TensionPoint>& curve, double extension) {
    std::size_t next = 1;
    while (next + 1 < curve.size() && curve[next].extension < extension) ++next;
    const TensionPoint& a = curve[next - 1];
    const TensionPoint& b = curve[next];
    const double slope = (b.tension - a.tension) / (b.extension - a.extension);
    return std::max(0.0, a.tension + slope * (extension - a.extension));
}

/// Where the curve has the tension, m.
double extension_at(const std::vector<TensionPoint>& curve, double tension) {
    std::size_t next = 1;
    while (next + 1 < curve.size() && curve[next].tension < tension) ++next;
    const TensionPoint& a = curve[next - 1];
    const TensionPoint& b = curve[next];
    return a.extension + (tension - a.tension) * (b.extension - a.extension) / (b.tension - a.tension);
}

}  // namespace

Vec3 Moorings::inertia() const {
    return {mass + added_surge, mass + added_sway, mass * gyration * gyration + added_yaw};
}

Vec3 Moorings::quadratic() const {
    return {quadratic_surge, quadratic_sway, quadratic_yaw};
}

Vec3 Moorings::stiffness() const {
    Vec3 found(surge, sway, yaw);
    for (const MooringLine& line : lines) {
        for (int k = 0; k < 3; ++k) {
            // Far above rounding, far below what a line's direction changes by.
            Vec3 aside = Vec3::Zero();
            aside[k] = 1e-5 * (k < 2 ? line.distance : 1.0);
            found[k] -= (pull(*this, line, aside).force[k] - pull(*this, line, -aside).force[k]) / (2 * aside[k]);
        }
    }
    if (!turret_curve.empty()) {
        const TensionPoint& first = turret_curve.at(1);
        const double slope = first.tension / first.extension;
        found += Vec3(slope, slope, slope * turret * turret);
    }
    return found;
}

Vec3 Moorings::periods() const {
    const Vec3 held = stiffness() + thrusters.gain;
    const Vec3 moved = inertia();
    Vec3 found;
    for (int k = 0; k < 3; ++k)
        found[k] = held[k] > 0 ? 2 * std::numbers::pi * std::sqrt(moved[k] / held[k]) : infinite;
    return found;
}

double tension(const Moorings& moorings, const MooringLine& line, double longer) {
    if (moorings.curve.empty()) return std::max(0.0, line.pretension + line.stiffness * longer);
    return on_curve(moorings.curve, extension_at(moorings.curve, line.pretension) + longer);
}

Vec2 turned(const Vec2& point, double yaw) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    return {c * point.x() + s * point.y(), c * point.y() - s * point.x()};
}

Vec3 turret_pull(const Moorings& moorings, const Vec3& offset) {
    if (moorings.turret_curve.empty()) return Vec3::Zero();
    const Vec2 arm = turned({moorings.turret, 0}, offset[2]);
    const Vec2 aside = Vec2(offset[0] - moorings.turret, offset[1]) + arm;
    const double distance = aside.norm();
    if (distance == 0) return Vec3::Zero();
    const Vec2 force = -on_curve(moorings.turret_curve, distance) / distance * aside;
    return {force.x(), force.y(), arm.y() * force.x() - arm.x() * force.y()};
}

LinePull pull(const Moorings& moorings, const MooringLine& line, const Vec3& offset) {
    const Vec2 without(line.x, line.z);
    const Vec2 arm = turned(without, offset[2]);
    LinePull found;
    found.anchor = without + line.distance * Vec2(std::cos(line.azimuth), std::sin(line.azimuth));
    found.fairlead = Vec2(offset[0], offset[1]) + arm;
    const Vec2 way = found.anchor - found.fairlead;
    const double distance = way.norm();
    found.tension = tension(moorings, line, distance - line.distance);
    if (distance == 0) return found;
    const Vec2 force = found.tension / distance * way;
    found.force = {force.x(), force.y(), arm.y() * force.x() - arm.x() * force.y()};
    return found;
}

ThrustLaw thrust_law(const Thrusters& thrusters, int direction, double inertia) {
    const double gain = thrusters.gain[direction];
    const double limit = thrusters.limit[direction];
    return {gain, 2 * thrusters.damping * std::sqrt(gain * inertia),
            limit > 0 ? limit : std::numeric_limits<double>::infinity()};
}

double thrust(const ThrustLaw& law, double offset, double velocity) {
    return -std::clamp(law.gain * offset + law.damping * velocity, -law.limit, law.limit);
}

double velocity_under_thrust(const ThrustLaw& law, double offset, double velocity, double inertia, double time) {
    if (law.damping == 0) return velocity + thrust(law, offset, velocity) / inertia * time;
    const double rate = law.damping / inertia;
    const double wanted = law.gain * offset + law.damping * velocity;
    const double above = std::max(0.0, std::abs(wanted) - law.limit);
    const double time_above = above > 0 ? std::min(time, above / (rate * law.limit)) : 0.0;
    const double linear = above > 0 ? std::abs(wanted) - rate * law.limit * time_above : std::abs(wanted);
    const double left = std::copysign(linear * std::exp(-rate * (time - time_above)), wanted);
    return velocity + (left - wanted) / law.damping;
}

}  // namespace floes
