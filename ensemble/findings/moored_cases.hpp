#pragma once
// Moored hulls over the members of a campaign file: a line for each case, the response spectrum, and peaks for design
// loads.

#include <optional>
#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "findings/evidence.hpp"
#include "findings/moored.hpp"
#include "tables/section.hpp"

namespace floes {

struct MooredCase {
    std::size_t case_index = 0;
    double separation = 0;  ///< s, of the peaks of k x
    double drift = 0;       ///< m/s, of the ice past the hull: structure.speed_m_s
    std::vector<MooredRun> runs;
    std::string refused;  ///< why there are none that count; empty: they do

    double velocity_ratio() const;  ///< rms velocity of the hull, over all runs, to the drift
};

/// Beside this velocity ratio the load of a fixed hull is no longer that of a moored one.
inline constexpr double much_motion = 0.2;

/// One for each case with stored histories. Reads the file. Throws InputError for a hull that is none, for a file
/// without histories, and where no case can be answered.
std::vector<MooredCase> find_moored(const Evidence& evidence, const MooredRequest& request);

/// The peaks of k x as tails are fitted to them, one for each case of the table, at the scale of the campaign.
std::vector<CasePeaks> moored_peaks(const CampaignTable& table, const std::vector<MooredCase>& found);

/// The same of what the simulation has of a structure that gives way: the force of springs and lines, or a motion.
/// Reads the file. Throws InputError where there is none, and for histories or windows too coarse or too short for the
/// natural period.
std::vector<CasePeaks> simulated_peaks(const Evidence& evidence, const DesignOf& of);

/// The design values of the cases that give way in the motion of `request.of`, which is not the load. Throws as
/// simulated_peaks() does.
std::vector<CaseDesignLoad> find_simulated_designs(const Evidence& evidence, const DesignLoadRequest& request);

/// Sentences on cases in which lines broke, whose force is that of what was left, or which thrusters alone hold, so
/// that there is none; empty without such cases.
std::string mooring_notes(const Evidence& evidence);

/// All design values of structures that give way, over 3 h and exceeded with 10 %, for people; `design --of` has them
/// for programs. Empty where nothing gives way or the file keeps no histories.
std::vector<Section> simulated_designs(Evidence& evidence);

/// What they are made of, once; none where nothing gives way or the file keeps no histories.
const std::vector<SimulatedDesign>& simulated_of(Evidence& evidence);

/// The line of each case.
Section moored_section(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request);

/// Largest k x over the largest averaged load, over the natural period. Reads the file.
Section moored_spectrum(const Evidence& evidence, double damping_ratio, double averaging, double scale);

/// For cases whose structure gave way in the simulation; none where there are none.
std::optional<Section> moored_runs_section(const Evidence& evidence);

/// For Evidence::moored; without it, only the spectrum, at a tenth of the critical damping and the scale of the
/// campaign.
std::vector<Section> moored_sections(Evidence& evidence);

}  // namespace floes
