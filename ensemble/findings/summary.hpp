#pragma once
// Statistics of a campaign file over arrangements: for every case the row of Table 3, with intervals.
//
// A member that failed or has not run yet is a missing value, never zero. One arrangement is one value: the floes of an
// arrangement are not independent of each other, so the failure ratio's interval is over arrangements too.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "findings/estimates.hpp"
#include "inference/bootstrap.hpp"
#include "inference/interval.hpp"
#include "member/quantity.hpp"
#include "tables/section.hpp"

namespace floes {

/// A mean over arrangements with its intervals: Student's, or those of a mixture where members stand out; and the BCa
/// bootstrap interval of the mean.
struct CaseEstimate : Interval {
    Limits bca{};
    std::size_t standing_out = 0;  ///< members that the intervals count as a kind of their own
};

/// One case over its arrangements. members = done + failed_members + missing_members.
struct CaseSummary {
    CaseRow about;
    int members = 0;          ///< planned
    int done = 0;             ///< with a result; the intervals use these
    int failed_members = 0;   ///< set aside
    int missing_members = 0;  ///< without a result yet
    int not_steady = 0;       ///< done, with a load that still had a trend in the window

    /// The estimate of a quantity that is shown in summaries, in its unit.
    const CaseEstimate& of(const Quantity& quantity) const { return estimates.at(std::string{quantity.key.view()}); }

    std::map<std::string, CaseEstimate> estimates;  ///< by key
    std::map<std::string, std::int64_t> totals;     ///< sums of counts over the done members; absent if none is done
};

/// A member that was set aside.
struct SetAside {
    int member = 0;
    std::string reason;
};

struct Summary {
    std::string title;  ///< of the campaign
    std::vector<CaseSummary> cases;
    std::vector<SetAside> failed;
    std::vector<Quantity> quantities;      ///< all that are known of the members, in the order in which they are shown
    std::vector<std::string> labels = {};  ///< of the cases, for people; empty: their names

    bool complete() const;  ///< every planned member is done or set aside
    const std::string& name_of(std::size_t of_case) const { return cases.at(of_case).about.name; }
    /// Both, for a table.
    Named named(std::size_t of_case) const { return {name_of(of_case), label_of(of_case)}; }
    /// What people call the case: of a design's point its keys, "thickness 0.02 m, speed 0.05 m/s".
    const std::string& label_of(std::size_t of_case) const {
        return labels.empty() ? name_of(of_case) : labels.at(of_case);
    }
};

/// Statistics of every case, in the order of the file.
Summary summarise(const CampaignTable& table);

/// Done members of a case in order of arrangement.
std::vector<const MemberRow*> done_members(const CampaignTable& table, std::size_t of_case);

/// Colour and name of every case; none of more than twelve, which could not be told apart.
std::vector<std::pair<std::string, std::string>> case_legend(const Summary& summary);

/// Index of the case named `name`. Throws InputError that lists the names of all cases.
std::size_t case_index(const Summary& summary, std::string_view name);

/// Index of the case that the others are compared with, as Table 3 does; none: no comparison.
using Reference = std::optional<std::size_t>;

/// What the brackets of Table 3 show: the difference of the estimate from the reference case's, %, negative when
/// smaller (the paper prints the magnitude). NaN if undefined.
double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference, const Quantity& quantity);

// Which intervals say something. One that says nothing is not printed as numbers: people quote what they see.

/// The same for the limits of a quantity, which may have its sign by its nature, as a correlation has.
bool says_something(const Quantity& quantity, double estimate, Limits limits, int runs);

/// About how many arrangements give the mean to ± `share` of itself, from the scatter of `runs` so far; 0: unknown.
int arrangements_for(const Interval& found, int runs, double share);

}  // namespace floes
