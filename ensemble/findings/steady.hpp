#pragma once
// When the load of each case became steady, as its histories tell, and the campaign as it looks in that window.

#include <filesystem>
#include <optional>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

struct MemberSteady {
    int member = 0;
    std::optional<double> start;    ///< s after the tow began, by MSER; none: no steady part seen
    double decorrelation_time = 0;  ///< s, in the window of the case
    double effective_samples = 0;   ///< of that window
};

struct CaseSteady {
    std::optional<double> start;           ///< s, by MSER of the mean over the members' histories
    std::optional<double> median_start;    ///< s, of the members that have one
    int without_start = 0;                 ///< members that have none
    double median_decorrelation_time = 0;  ///< s
    double median_effective_samples = 0;
};

struct SteadyReport {
    std::vector<CaseSteady> cases;
    std::vector<MemberSteady> members;  ///< those with a history
};

/// Reads the histories of the file that `table` is of. Where there are none it has no members, and its cases have no
/// start.
SteadyReport find_steady(const std::filesystem::path& path, const CampaignTable& table);

/// The table with every done member's load measured anew: in the whole segments, each as long as before, that fit
/// between the start found for its case and the end of the run, counted from the end. A case without a start, or in
/// which no segment fits, keeps its window. The failure ratio and what else is not of the load stay.
/// Throws InputError for histories that are thinned, since maxima and deviations need every step, and where there are
/// none.
CampaignTable with_automatic_window(const std::filesystem::path& path, CampaignTable table, const SteadyReport& steady);

/// A line a case for people, a record a case and one a member in JSON, and in CSV a line a member.
Section steady_section(const Summary& summary, const CampaignTable& table, const SteadyReport& steady);

}  // namespace floes
