#pragma once
// The numbers that a member measures. quantity.hpp lists those with a name and where they appear.

#include <array>
#include <limits>
#include <vector>

#include "ice/failure_mode.hpp"
#include "statistics/averaged_load.hpp"
#include "statistics/load_statistics.hpp"
#include "statistics/oscillator.hpp"
#include "statistics/work_shares.hpp"

namespace floes {

/// How a structure gave way, or what then held it, in the window: of one of response_kinds() (design_of.hpp), in its
/// unit and of single steps. NaN and empty: not measured.
struct Response {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double rise = std::numeric_limits<double>::quiet_NaN();  ///< slope of least squares times the window
    std::vector<double> segment_maximum{};                   ///< largest of each segment of the window
    std::vector<double> peaks{};                             ///< declustered, above the mean, falling
};

/// For a failed member only the order of its floes, the failures and the peaks are valid: they were recorded before it
/// failed.
struct MemberOutputs {
    LoadStatistics load;                 ///< of the surge load in the window
    std::vector<AveragedLoad> averaged;  ///< the same load over each averaging time, rising
    std::vector<PartLoad> parts;         ///< loads on each part of a structure of several
    Swing yaw, roll, pitch;              ///< of the moments on the structure, in the window
    double mean_sway = 0;                ///< N, over the window
    double mean_heave = 0;               ///< N, over the window
    double failure_ratio = 0;            ///< broken floes / floes_entered, 0-1
    double split_ratio = 0;              ///< floes in more than one piece / floes_entered, 0-1
    double cracked_ratio = 0;            ///< floes that began to crack / floes_entered, 0-1
    double pieces = 0;                   ///< of ice, at the end of the run
    double floes_entered = 0;            ///< that were computed, at any time of the run
    double floes_met = 0;                ///< of these, that touched the structure at any time
    double met_failure_ratio = 0;        ///< broken floes among those met / those met, 0-1
    double mean_concentration = 0;       ///< of ice round the structure, over the window
    double pile_height = 0;              ///< m above the water of the highest point of that ice, likewise
    double pile_draught = 0;             ///< m below it of the deepest, likewise
    double mean_bed_surge = 0;           ///< N, of the ice on the bed against the tow, over the window; NaN: no bed
    double mean_bed_weight = 0;          ///< N, likewise downwards
    double mean_grounded = 0;            ///< m², of the elements that bear on the bed, likewise
    double ice_flux = 0;       ///< m²/s of ice that fell astern of the structure, over the window; NaN on a path
    double floes_astern = 0;   ///< that did so; likewise
    double fracture_work = 0;  ///< J, taken by cracks over the run
    std::array<double, failure_mode_names.size()> failures{};  ///< failed joints by mode
    double local_order = 0;           ///< of the arrangement, arrangement/order.hpp; its psi4 is stored with the poses
    double coverage_ahead = 0;        ///< share of the structure's path covered by ice at t = 0, 0-1
    WorkShares work;                  ///< where the work of the tow went in the window
    double mean_sweeps = 0;           ///< of the solver a step, over the run
    MooredResponse moored;            ///< of a structure that gives way
    std::vector<Response> responses;  ///< likewise, one of each of response_kinds()
    PeakReactions peaks;              ///< over all joints and the whole run
};

}  // namespace floes
