#include "structure/thrusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {

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
