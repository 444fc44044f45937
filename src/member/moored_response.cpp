#include "member/moored_response.hpp"

#include <array>
#include <cmath>

#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

/// They are at their limit to the bit where they want more. `histories`: in surge, sway and yaw, in the window.
double share_at_limit(const Vec3& limits, const std::array<std::span<const double>, 3>& histories) {
    std::size_t at_limit = 0;
    for (std::size_t step = 0; step < histories[0].size(); ++step) {
        bool ended = false;
        for (std::size_t k = 0; k < histories.size(); ++k) {
            const double limit = limits[static_cast<Eigen::Index>(k)];
            ended = ended || (limit > 0 && std::abs(histories.at(k)[step]) == limit);
        }
        at_limit += ended ? 1 : 0;
    }
    return static_cast<double>(at_limit) / static_cast<double>(histories[0].size());
}

}  // namespace

MooredResponse moored_response(const Scenario& scenario, const MotionHistory& motion) {
    const double step = scenario.general.time_step;
    MooredResponse response{
        .surge_offset = swing_of(in_window(scenario, motion.surge_offset)),
        .sway_offset = swing_of(in_window(scenario, motion.sway_offset)),
        .yaw = swing_of(in_window(scenario, motion.yaw)),
        .surge_mooring = swing_of(in_window(scenario, motion.surge_mooring)),
        .sway_mooring = swing_of(in_window(scenario, motion.sway_mooring)),
        .mean_maximum =
            load_statistics(in_window(scenario, motion.surge_mooring), step, scenario.analysis.segments).mean_maximum,
        .rms_velocity = rms_rate(in_window(scenario, motion.surge_offset), step)};
    if (scenario.moorings.floats()) {
        response.heave = swing_of(in_window(scenario, motion.heave));
        response.pitch = swing_of(in_window(scenario, motion.pitch));
        response.roll = swing_of(in_window(scenario, motion.roll));
    }
    if (scenario.moorings.thrusters.any()) {
        const std::array thrust{in_window(scenario, motion.surge_thrust), in_window(scenario, motion.sway_thrust),
                                in_window(scenario, motion.yaw_thrust)};
        response.surge_thrust = swing_of(thrust[0]);
        response.sway_thrust = swing_of(thrust[1]);
        response.yaw_thrust = swing_of(thrust[2]);
        response.thrust_at_limit = share_at_limit(scenario.moorings.thrusters.limit, thrust);
    }
    return response;
}

}  // namespace floes
