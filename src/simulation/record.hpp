#pragma once
// What a run yields step by step: the ice load over time, and what is to be seen at one moment.

#include <array>
#include <string_view>
#include <vector>

#include "core/vector.hpp"
#include "world/state.hpp"

namespace floes {

/// What has a history of some kind.
enum class HistoryOf { every_run, water_with_bed, motion, moorings, breaking_lines, thrusters, floating_hull };

inline constexpr int steps_a_look = 10;  ///< from one look at the ice round the structure to the next

/// A value for each step, and what files call it. A new history is its field, one line of its list, and its value in
/// Simulation::record().
template <class Owner>
struct History {
    std::vector<double> Owner::*values;
    std::string_view path;  ///< in campaign files
    std::string_view unit;  ///< there
    std::string_view long_name;
    HistoryOf of = HistoryOf::every_run;
    int held_steps = 1;  ///< a value is that of so many steps
};

/// Contact force on the structure in each step, N. Entry k belongs to the step that ends at (k + 1) Δt; where a member
/// keeps means over `analysis.history_steps` = N steps, to the N that end at (k + 1) N Δt. The water's force on the
/// structure is not in it, so there is no open-water resistance to subtract. Beside it, how the ice lies there at the
/// last look (simulation/nearby_ice.hpp).
struct LoadHistory {
    std::vector<double> surge, sway, heave, concentration, pile_height, pile_draught;
};

inline constexpr std::array load_histories{
    History{&LoadHistory::surge, "history/surge_load", "N", "contact force on the structure against the tow"},
    History{&LoadHistory::sway, "history/sway_load", "N", "contact force on the structure towards +z"},
    History{&LoadHistory::heave, "history/heave_load", "N", "contact force on the structure upwards"},
    History{&LoadHistory::concentration, "history/concentration", "1",
            "concentration of ice in a box round the structure", HistoryOf::every_run, steps_a_look},
    History{&LoadHistory::pile_height, "history/pile_height", "m",
            "height above the water of the highest ice in that box", HistoryOf::every_run, steps_a_look},
    History{&LoadHistory::pile_draught, "history/pile_draught", "m",
            "depth below the water of the deepest ice in that box", HistoryOf::every_run, steps_a_look}};

/// Contact force of the ice on the sea bed, where there is one; entries like those of LoadHistory. It is no part of the
/// load on the structure.
struct BedHistory {
    std::vector<double> surge, weight, grounded;
};

inline constexpr std::array bed_histories{
    History{&BedHistory::surge, "history/bed_surge", "N", "contact force on the bed against the tow",
            HistoryOf::water_with_bed},
    History{&BedHistory::weight, "history/bed_weight", "N", "contact force on the bed downwards",
            HistoryOf::water_with_bed},
    History{&BedHistory::grounded, "history/grounded", "m2", "area of the elements that bear on the bed",
            HistoryOf::water_with_bed}};

/// How a structure that is not towed straight on moved, and what its moorings bore, at the end of each step. What a
/// structure does not have is empty. Offsets are from the moorings' place, positive along the load; mooring forces are
/// what springs and lines bear of the load.
struct MotionHistory {
    std::vector<double> x, z, yaw, yaw_load;
    std::vector<double> surge_offset, sway_offset, surge_mooring, sway_mooring, yaw_mooring;
    std::vector<double> heave, pitch, roll;
    std::vector<double> line_use;
    std::vector<double> surge_thrust, sway_thrust, yaw_thrust;
};

inline constexpr std::array motion_histories{
    History{&MotionHistory::x, "history/structure_x", "m", "x of the structure's axis", HistoryOf::motion},
    History{&MotionHistory::z, "history/structure_z", "m", "z of the structure's axis", HistoryOf::motion},
    History{&MotionHistory::yaw, "history/structure_yaw", "rad", "yaw of the structure, positive where +z turns to +x",
            HistoryOf::motion},
    History{&MotionHistory::yaw_load, "history/yaw_load", "N m",
            "moment of the contact forces about the structure's axis, positive where it turns +z to +x",
            HistoryOf::motion},
    History{&MotionHistory::surge_offset, "history/surge_offset", "m",
            "offset of the moored structure along the surge load", HistoryOf::moorings},
    History{&MotionHistory::sway_offset, "history/sway_offset", "m", "offset of the moored structure towards +z",
            HistoryOf::moorings},
    History{&MotionHistory::surge_mooring, "history/surge_mooring", "N",
            "force of springs and lines against the surge load", HistoryOf::moorings},
    History{&MotionHistory::sway_mooring, "history/sway_mooring", "N",
            "force of springs and lines against the sway load", HistoryOf::moorings},
    History{&MotionHistory::yaw_mooring, "history/yaw_mooring", "N m",
            "moment of springs and lines against the yaw load", HistoryOf::moorings},
    History{&MotionHistory::line_use, "history/line_use", "1",
            "largest tension of a line over its break load, of the lines that hold", HistoryOf::breaking_lines},
    History{&MotionHistory::surge_thrust, "history/surge_thrust", "N",
            "force of thrusters against the surge load, in the structure's axes", HistoryOf::thrusters},
    History{&MotionHistory::sway_thrust, "history/sway_thrust", "N",
            "force of thrusters against the sway load, in the structure's axes", HistoryOf::thrusters},
    History{&MotionHistory::yaw_thrust, "history/yaw_thrust", "N m", "moment of thrusters against the yaw load",
            HistoryOf::thrusters},
    History{&MotionHistory::heave, "history/heave_offset", "m", "heave of the floating structure, upwards",
            HistoryOf::floating_hull},
    History{&MotionHistory::pitch, "history/pitch", "rad", "pitch of the floating structure, positive with the bow up",
            HistoryOf::floating_hull},
    History{&MotionHistory::roll, "history/roll", "rad",
            "roll of the floating structure, positive with starboard (+z) down", HistoryOf::floating_hull}};

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
