#pragma once
// A hull on its moorings under the stored loads of a fixed one: what the moorings feel. m ẍ + c ẋ + k x = F(t), one
// direction, linear (statistics/oscillator.hpp). docs/moorings.md says where that holds.
//
// The motion starts from rest with the run, before the hull meets the ice: there it is true, and no start is made up.
// Its entry into the ice swings the hull; the run-up, from the first load to the window, is cut off, and has to be long
// enough for that swing to fade. Started in the window, at rest or at the mean offset, the hull would have less than
// its usual motion for some 1/(ζω).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/case_words.hpp"
#include "findings/design_load.hpp"
#include "inference/interval.hpp"
#include "scenario/scenario.hpp"
#include "statistics/averaged_load.hpp"
#include "tables/section.hpp"

namespace floes {

/// Throws InputError unless stiffness and mass are above 0 and the damping ratio is above 0 and below 1: without
/// damping no swing fades.
void check_hull(const Oscillator& hull);

/// Fewest values of a history in a natural period: with fewer, the largest offset between two is missed by over 1.2 %.
inline constexpr double fewest_values = 20;

/// For one member, at the scale of the campaign.
struct MooredRun {
    int member = 0;
    double first_load = 0;    ///< s, as first_load()
    double mean_offset = 0;   ///< m, in the window like what follows
    double sd_offset = 0;     ///< m
    double rms_velocity = 0;  ///< m/s
    AveragedLoad force;       ///< k x as it is, N
    AveragedLoad load;        ///< of load_in_window() over the averaging time asked for

    /// NaN of a run in which ice never pressed on the hull.
    double amplification() const { return load.mean_maximum > 0 ? force.mean_maximum / load.mean_maximum : undefined; }
};

/// `surge`: load from the start to the end of the window, N, means over `step` s. `analysis`: window and segments. The
/// peaks of k x are those that moored_separation() keeps apart.
MooredRun moored_run(std::span<const double> surge, double step, const Analysis& analysis,
                     const MooredRequest& request);

/// k x in the window, N, of the same arguments.
std::vector<double> mooring_force(std::span<const double> surge, double step, const Analysis& analysis,
                                  const MooredRequest& request);

/// The load of the window, of the arguments of moored_run(), averaged over `time`, but at least over one value and at
/// most over a segment.
AveragedLoad load_in_window(std::span<const double> surge, double step, const Analysis& analysis, double time);

/// s after the start at which the hull meets ice; the length of the run if it never does.
double first_load(std::span<const double> surge, double step);

/// When the last of a case's members that meet ice does so, s after the start; infinite while none does.
struct LastEntry {
    double time = HUGE_VAL;

    /// `met`: first_load() of a member whose run ends at `end`, s.
    void add(double met, double end) {
        if (met < end) time = std::isinf(time) ? met : std::max(time, met);
    }
};

/// s, at the scale of the campaign, between peaks of k x that count as two: not below analysis.peak_separation, the
/// natural period, and the time 1/(ζω) in which free motion falls to 1/e, since the swings of one event are one.
double moored_separation(const Analysis& analysis, const Oscillator& model);

/// One sentence, or nothing: why a natural period, s, is too short for histories of such steps, or too long for the
/// window; `to_full`: times at full scale over those of the campaign.
std::string period_refusal(const Analysis& analysis, double step, double period, double to_full);

/// One sentence, or nothing: why the window of such histories says nothing of this hull. `step`: of the history, s;
/// `last_entry`: LastEntry::time; all at the scale of the campaign, the sentence at full scale.
std::string moored_refusal(const Analysis& analysis, double step, double last_entry, const MooredRequest& request);

// Moored hulls over the members of a campaign file: a line for each case, the response spectrum, and peaks for design
// loads.

struct MooredCase {
    std::size_t case_index = 0;
    double separation = 0;  ///< s, of the peaks of k x
    double drift = 0;       ///< m/s, of the ice past the hull: Scenario::drift()
    std::vector<MooredRun> runs;
    std::string refused;  ///< why there are none that count; empty: they do

    double velocity_ratio() const;  ///< rms velocity of the hull, over all runs, to the drift
};

/// One for each case with stored histories. Reads the file. Throws InputError for a hull that is none, for a file
/// without histories, and where no case can be answered.
std::vector<MooredCase> find_moored(const Evidence& evidence, const MooredRequest& request);

/// The peaks of k x as tails are fitted to them, one for each case of the sample, at the scale of the campaign.
std::vector<CasePeaks> moored_peaks(const Sample& sample, const std::vector<MooredCase>& found);

/// The same of what the simulation has of a structure that gives way: the force of springs and lines, or a motion.
/// Reads the file. Throws InputError where there is none, and for histories or windows too coarse or too short for the
/// natural period.
std::vector<CasePeaks> simulated_peaks(const Evidence& evidence, const DesignOf& of);

/// The design values of the cases that give way in the motion of `request.of`, which is not the load. Throws as
/// simulated_peaks() does.
DesignLoads find_simulated_designs(const Evidence& evidence, const DesignLoadRequest& request);

/// Sentences on cases in which lines broke, so that fewer hold the hull from then on, and on those that
/// thrusters alone hold, so that there is none; empty without such cases.
std::string mooring_notes(const Evidence& evidence);

/// All design values of structures that give way, over 3 h and exceeded with 10 %, for people; `design --of` has them
/// for programs. Empty where nothing gives way or the file keeps no histories.
std::vector<Section> simulated_designs(Evidence& evidence);

/// What they are made of, once; none where nothing gives way or the file keeps no histories.
const std::vector<DesignLoads>& simulated_of(Evidence& evidence);

/// The line of each case.
Section moored_section(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request);

/// Largest k x over the largest averaged load, over the natural period. Reads the file.
Section moored_spectrum(const Evidence& evidence, double damping_ratio, double averaging, double scale);

/// For cases whose structure gave way in the simulation; none where there are none.
std::optional<Section> moored_runs_section(const Evidence& evidence);

/// The largest tension of each line over a run, over its break load where it has one; none where there are no lines.
/// Reads the file.
std::optional<Section> mooring_lines_section(const Evidence& evidence);

/// For Evidence::moored; without it, only the spectrum, at a tenth of the critical damping and the scale of the
/// campaign.
std::vector<Section> moored_sections(Evidence& evidence);

}  // namespace floes
