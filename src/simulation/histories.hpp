#pragma once
// The ice load of a run over time.

#include <array>
#include <vector>

namespace floes {

/// Contact force on the structure in each step, N. Entry k belongs to the step that ends at (k + 1) Δt; where a member
/// keeps means over `analysis.history_steps` = N steps, to the N that end at (k + 1) N Δt. The water's force on the
/// structure is not in it, so there is no open-water resistance to subtract.
struct LoadHistory {
    std::vector<double> surge;  ///< positive against the tow (-x)
    std::vector<double> sway;   ///< positive towards +z
    std::vector<double> heave;  ///< positive up
};

inline constexpr std::array load_histories{&LoadHistory::surge, &LoadHistory::sway, &LoadHistory::heave};

// How a structure that is not towed straight on moved, and what its moorings bore, over time.

/// A value for each step, like those of LoadHistory; at the end of the step. Empty for the straight tow; without
/// moorings those of offsets and mooring forces are empty, without thrusters those of thrust, and those of heave, pitch
/// and roll where none of these is free.
struct MotionHistory {
    std::vector<double> x;         ///< of the structure's axis, m
    std::vector<double> z;         ///< likewise
    std::vector<double> yaw;       ///< about +y: +z turns to +x, rad
    std::vector<double> yaw_load;  ///< moment of the ice about the axis and +y, N m

    std::vector<double> surge_offset;   ///< from the moorings' place along the load: positive against the tow (-x), m
    std::vector<double> sway_offset;    ///< likewise, positive towards +z, m
    std::vector<double> surge_mooring;  ///< what springs and lines bear of the surge load, N
    std::vector<double> sway_mooring;   ///< likewise of the sway load, N
    std::vector<double> yaw_mooring;    ///< likewise of the yaw load, N m

    std::vector<double> heave;  ///< of a hull that heaves, pitches or rolls, upwards, m
    std::vector<double> pitch;  ///< likewise, positive with the bow up, rad
    std::vector<double> roll;   ///< likewise, positive with starboard (+z) down, rad

    std::vector<double> surge_thrust;  ///< of thrusters against the surge load, in the structure's axes: ahead, N
    std::vector<double> sway_thrust;   ///< likewise against the sway load, N
    std::vector<double> yaw_thrust;    ///< likewise against the yaw load, N m
};

inline constexpr std::array motion_histories{&MotionHistory::x,
                                             &MotionHistory::z,
                                             &MotionHistory::yaw,
                                             &MotionHistory::yaw_load,
                                             &MotionHistory::surge_offset,
                                             &MotionHistory::sway_offset,
                                             &MotionHistory::surge_mooring,
                                             &MotionHistory::sway_mooring,
                                             &MotionHistory::yaw_mooring,
                                             &MotionHistory::heave,
                                             &MotionHistory::pitch,
                                             &MotionHistory::roll,
                                             &MotionHistory::surge_thrust,
                                             &MotionHistory::sway_thrust,
                                             &MotionHistory::yaw_thrust};

}  // namespace floes
