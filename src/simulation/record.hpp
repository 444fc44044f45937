#pragma once
// What a run yields step by step: the ice load over time, and what is to be seen at one moment.

#include <array>
#include <vector>

#include "core/vector.hpp"
#include "world/state.hpp"

namespace floes {

/// Contact force on the structure in each step, N. Entry k belongs to the step that ends at (k + 1) Δt; where a member
/// keeps means over `analysis.history_steps` = N steps, to the N that end at (k + 1) N Δt. The water's force on the
/// structure is not in it, so there is no open-water resistance to subtract. Beside it, how the ice lies there at the
/// last look (simulation/nearby_ice.hpp).
struct LoadHistory {
    std::vector<double> surge;          ///< positive against the tow (-x)
    std::vector<double> sway;           ///< positive towards +z
    std::vector<double> heave;          ///< positive up
    std::vector<double> concentration;  ///< of ice round the structure
    std::vector<double> pile_height;    ///< of the highest point of that ice above the water, m
    std::vector<double> pile_draught;   ///< of the deepest below it, m
};

inline constexpr int steps_a_look = 10;  ///< from one look at the ice round the structure to the next

inline constexpr std::array load_histories{&LoadHistory::surge,       &LoadHistory::sway,
                                           &LoadHistory::heave,       &LoadHistory::concentration,
                                           &LoadHistory::pile_height, &LoadHistory::pile_draught};

/// Contact force of the ice on the sea bed, N, where there is one; entries like those of LoadHistory. It is no part of
/// the load on the structure.
struct BedHistory {
    std::vector<double> surge;     ///< positive against the tow (-x), as the load on the structure
    std::vector<double> weight;    ///< positive downwards
    std::vector<double> grounded;  ///< area of the elements that bear on the bed, m²
};

inline constexpr std::array bed_histories{&BedHistory::surge, &BedHistory::weight, &BedHistory::grounded};

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

    /// Largest tension of a line over its break load, of those that held until the step; empty where no line breaks.
    std::vector<double> line_use;

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
                                             &MotionHistory::line_use,
                                             &MotionHistory::surge_thrust,
                                             &MotionHistory::sway_thrust,
                                             &MotionHistory::yaw_thrust};

// What is to be seen of a run at the end of a step: how everything lies, moves, bears and touches. Read on request;
// nothing of a run depends on it.

/// What touches an element, where that is no element.
inline constexpr int touches_structure = -1;
inline constexpr int touches_ice_sheet = -2;  ///< or a smooth wall
inline constexpr int touches_bed = -3;

/// A contact that exerted a force during the step.
struct FrameContact {
    int element = 0;               ///< in the order of IceField::elements(); the forces act on it
    int other = 0;                 ///< the other element, or one of touches_structure, touches_ice_sheet, touches_bed
    Vec3 point = Vec3::Zero();     ///< m
    Vec3 normal = Vec3::Zero();    ///< N
    Vec3 friction = Vec3::Zero();  ///< N
};

/// A mooring line that holds.
struct FrameLine {
    int line = 0;                  ///< in the order of moorings.lines and hanging_lines
    Vec3 fairlead = Vec3::Zero();  ///< m; of a line without weight at the height of the water
    Vec3 anchor = Vec3::Zero();    ///< m, likewise
    double tension = 0;            ///< N
};

struct Frame {
    int step = 0;     ///< steps completed; 0: the start
    double time = 0;  ///< s
    StructurePose structure;
    Vec3 load = Vec3::Zero();         ///< contact force on the structure, world axes (surge load: -x), N
    std::vector<BodyState> elements;  ///< in the order of IceField::elements()
    std::vector<int> pieces;          ///< of each element: the first element of its piece
    std::vector<double> utilisation;  ///< of each element: largest λ/ε of its live joints, 0-1
    /// In a field without end, what each of the above is in the numbers of the record (replay/frame_series.hpp), which
    /// `pieces` and `contacts` have too; only what is there stands above. Empty: all elements, in order.
    std::vector<int> ids{};
    std::vector<FrameLine> lines{};      ///< mooring lines that hold
    std::vector<FrameContact> contacts;  ///< of the structure and among the ice, in the order of the solve

    /// The number of the `k`-th element.
    std::size_t id(std::size_t k) const { return ids.empty() ? k : static_cast<std::size_t>(ids[k]); }
};

}  // namespace floes
