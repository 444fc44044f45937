#pragma once
// The result of one member: a row of Table 3, its load histories, its break log and its initial arrangement.

#include <limits>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "ice/failure_mode.hpp"
#include "ice/piece_area.hpp"
#include "quantities/member_outputs.hpp"
#include "simulation/load_history.hpp"
#include "simulation/motion_history.hpp"
#include "statistics/level_counts.hpp"
#include "statistics/load_map.hpp"

namespace floes {

enum class MemberStatus : std::int8_t { done = 0, failed = 1 };

/// The result of one member. For a failed member only status, reason, arrangement and what was recorded before the
/// failure are valid.
struct MemberResult : MemberOutputs {
    static constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

    MemberStatus status = MemberStatus::done;
    std::string reason;                ///< of a failure, a sentence; empty when done
    std::vector<LevelCount> levels;    ///< of the surge load in the window, in the order of analysis.exceedance_levels
    LoadMap load_map;                  ///< empty: of an earlier version
    LoadHistory history;               ///< from t = 0 to the end of the run, as analysis keeps it
    MotionHistory motion;              ///< likewise, of a structure that is not towed straight on
    std::vector<double> line_tension;  ///< largest of each mooring line, N
    std::vector<double> line_broken_at;   ///< s, of each mooring line; NaN: it holds
    std::vector<BreakEvent> breaks;       ///< in order of time, then floe, then joint
    std::vector<PieceArea> piece_areas;   ///< of the floes that are cracked through at the end, by floe
    std::vector<PlanarPose> arrangement;  ///< floe poses at t = 0
    std::vector<double> floe_properties;  ///< properties_of() the floes
    double psi4 = 0;                      ///< of the arrangement
    double wall_time = 0;                 ///< s; provenance only
    double cpu_time = not_measured;       ///< s, of the thread that computed it; provenance only
};

}  // namespace floes
