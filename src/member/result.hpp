#pragma once
// What one member gives: a row of Table 3, its load histories, its break log and the arrangement it began from.

#include <limits>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "ice/failure_mode.hpp"
#include "ice/peak_reactions.hpp"
#include "simulation/load_history.hpp"
#include "statistics/level_counts.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

enum class MemberStatus : std::int8_t { done = 0, failed = 1 };

/// The result of one member. Of a failed member only status, reason, arrangement and what was recorded before count.
struct MemberResult {
    static constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

    MemberStatus status = MemberStatus::done;
    std::string reason;              ///< of a failure, a sentence; empty when done
    LoadStatistics load;             ///< of the surge load in the window
    std::vector<LevelCount> levels;  ///< of the surge load in the window, in the order of analysis.exceedance_levels
    double mean_sway = 0;            ///< N, over the window
    double mean_heave = 0;           ///< N, over the window
    double failure_ratio = 0;        ///< broken floes / floes at the end of the run, 0-1
    int failures_bending = 0;        ///< failed joints by mode; the sum over all modes is breaks.size()
    int failures_shear = 0;
    int failures_compression = 0;
    PeakReactions peaks;
    LoadHistory history;                  ///< from t = 0 to the end of the run, as analysis keeps it
    std::vector<BreakEvent> breaks;       ///< in order of time, then floe, then joint
    std::vector<PlanarPose> arrangement;  ///< floe poses at t = 0
    double psi4 = 0;                      ///< of the arrangement
    double wall_time = 0;                 ///< s; provenance only
    double cpu_time = not_measured;       ///< s, of the thread that computed it; provenance only
};

}  // namespace floes
