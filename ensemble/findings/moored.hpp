#pragma once
// A hull on its moorings under the stored loads of a fixed one: what the moorings feel. m ẍ + c ẋ + k x = F(t), one
// direction, linear (statistics/oscillator.hpp). docs/moorings.md says where that holds.
//
// The motion starts from rest with the run, before the hull meets the ice: there it is true, and no start is made up.
// Its entry into the ice swings the hull; the run-up, from the first load to the window, is cut off, and has to be long
// enough for that swing to fade. Started in the window, at rest or at the mean offset, the hull would have less than
// its usual motion for some 1/(ζω).

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "campaign/advice.hpp"
#include "inference/interval.hpp"
#include "scenario/scenario.hpp"
#include "statistics/averaged_load.hpp"
#include "statistics/oscillator.hpp"

namespace floes {

struct MooredRequest {
    Oscillator hull;       ///< at full scale
    double scale = 1;      ///< length at full scale / length in the campaign
    double averaging = 1;  ///< s at full scale: the load that the mooring force is compared with

    /// The hull at the scale of the campaign: stiffness over λ², mass over λ³, the same damping ratio.
    Oscillator model() const;
    double model_averaging() const;  ///< s
    double time_factor() const;      ///< of times and speeds
    double force_factor() const;
};

/// Throws InputError unless stiffness and mass are above 0 and the damping ratio is above 0 and below 1: without
/// damping no swing fades.
void check_hull(const Oscillator& hull);

/// Fewest values of a history in a natural period: with fewer, the largest offset between two is missed by over 1.2 %.
inline constexpr double fewest_values = 20;
/// Most of the entry's swing that may be left when the window begins.
inline constexpr double most_left = 0.05;

/// For one member, at the scale of the campaign.
struct MooredRun {
    int member = 0;
    double first_load =
        0;  ///< s after the start at which the hull meets ice; the length of the run where it never does
    double mean_offset = 0;   ///< m, in the window like what follows
    double sd_offset = 0;     ///< m
    double rms_velocity = 0;  ///< m/s
    AveragedLoad force;       ///< k x as it is, N
    AveragedLoad load;        ///< F averaged over that time, but at least over one value and at most over a segment

    double amplification() const { return force.mean_maximum / load.mean_maximum; }
};

/// `surge`: load from the start to the end of the window, N, means over `step` s. `analysis`: window and segments. The
/// peaks of k x are those that moored_separation() keeps apart.
MooredRun moored_run(std::span<const double> surge, double step, const Analysis& analysis,
                     const MooredRequest& request);

/// k x in the window, N, of the same arguments.
std::vector<double> mooring_force(std::span<const double> surge, double step, const Analysis& analysis,
                                  const MooredRequest& request);

/// s, at the scale of the campaign, between peaks of k x that count as two: not below analysis.peak_separation, the
/// natural period, and the time 1/(ζω) in which free motion falls to 1/e, since the swings of one event are one.
double moored_separation(const Analysis& analysis, const Oscillator& model);

/// One sentence, or nothing: why a natural period, s, is too short for histories of such steps, or too long for the
/// window; `to_full`: times at full scale over those of the campaign.
std::string period_refusal(const Analysis& analysis, double step, double period, double to_full);

/// One sentence, or nothing: why the window of such histories says nothing of this hull. `step`: of the history, s;
/// `first_load`: s after the start; all at the scale of the campaign, the sentence at full scale.
std::string moored_refusal(const Analysis& analysis, double step, double first_load, const MooredRequest& request);

}  // namespace floes
