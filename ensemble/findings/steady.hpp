#pragma once
// Whether loads rise or fall through the measured window (inference/paired.hpp), of a campaign's members.

#include <optional>
#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "inference/paired.hpp"

namespace floes {

/// Of a load that is known to be steady: what the ice ahead lets one conclude. Empty of others, of which warnings_of()
/// tells.
std::string steady_text(const std::string& name, const JointTrend& trend, const CaseRow& about);

/// For a load that rises in a field with an end: what would end it. Empty in a field without end.
std::string end_text(const CaseRow& about);

// When the load of each case became steady, found from its histories, and the statistics in that window.

struct MemberSteady {
    int member = 0;
    std::optional<double> start;    ///< s after the tow began, by MSER; none: no steady part found
    double decorrelation_time = 0;  ///< s, in the window of the case
    double effective_samples = 0;   ///< of that window
};

struct CaseSteady {
    /// s: by MSER of the mean over the members' histories, and not before their load, member by member, no longer has a
    /// trend from there to the end (paired.hpp). None: in no half of the run.
    std::optional<double> start;
    std::optional<double> median_start;    ///< s, of the members that have one
    int without_start = 0;                 ///< members without a start
    double median_decorrelation_time = 0;  ///< s
    double median_effective_samples = 0;
};

struct SteadyReport {
    std::vector<CaseSteady> cases;
    std::vector<MemberSteady> members;  ///< those with a history
};

/// Reads the histories of the file that `sample` was read from. Without histories the report has no members, and its
/// cases have no start.
SteadyReport find_steady(const CampaignFile& file, const Sample& sample);

/// The table with the load statistics of every done member recomputed. The window is as many whole segments, each as
/// long as before, as fit between the start found for the case and the end of the run, counted from the end. A case
/// without a start, or in which no segment fits, keeps its window. The failure ratio and everything else that is not a
/// load stay unchanged. Throws InputError if there are no histories or if they are thinned, since maxima and deviations
/// need every step.
CampaignTable with_automatic_window(const CampaignFile& file, CampaignTable table, const SteadyReport& steady);

/// Of the evidence's file, found once.
const SteadyReport& steady_of(Evidence& evidence);

/// Text has a row for each case, JSON a record for each case and each member, CSV a line for each member.
Section steady_section(Evidence& evidence);

}  // namespace floes
