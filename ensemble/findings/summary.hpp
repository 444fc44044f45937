#pragma once
// Means over members, each with the interval that fits its values, and the columns that show them.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "inference/interval.hpp"
#include "inference/paired.hpp"
#include "member/quantity.hpp"
#include "tables/section.hpp"

namespace floes {

/// Fewest arrangements whose interval is printed: of two, Student's t makes it 13 standard errors wide on either side.
inline constexpr int fewest_for_interval = 3;

/// What values can be, which decides their interval and whether it says something.
struct Kind {
    double least = no_least;
    double most = no_most;
    bool positive = false;  ///< above 0 in any run: the range of one further run is taken on a logarithmic scale
    bool load = false;      ///< members may be of two kinds, as where ice jams in some: the interval of a mixture
};

/// The kind of a quantity of members.
Kind kind_of(const Quantity& quantity);

/// Those of the values that were measured: the finite ones.
std::vector<double> measured(std::vector<double> values);

/// Whether the 95 % limits of an estimate over `runs` arrangements say something: at least three runs, which differ,
/// and limits no further apart than four times the estimate, or than what values of the kind can have. What says
/// nothing is not printed as numbers: people quote what they see.
bool says_something(double estimate, Limits limits, int runs, const Kind& kind = {});

/// As one cell of a table; its limits are said, or only if they say something of so many runs.
Estimate estimate(const Interval& found);
Estimate estimate(const Interval& found, int runs, const Kind& kind = {});
/// The mean of the finite ones among the values as one cell, with the interval of their kind: Student's t or a
/// mixture's, cut to the range that values can have.
Estimate over(const std::vector<double>& values, const Kind& kind = {});
/// The mean of a quantity over members as one cell.
Estimate over(const Sample& sample, const Members& members, const Quantity& quantity);

/// Its column: key, words and unit as the quantity has them.
ResultColumn column_of(const Quantity& quantity, ResultColumn::Holds holds = ResultColumn::Holds::estimates);
/// Its unit as Units takes it: "share" of a ratio.
std::string unit_of(const Quantity& quantity);

/// "+5.4 N (+2.1 to +8.7)": a change of a load in a sentence.
std::string change_text(const Estimate& change, const Units& units);

/// A column of values with their intervals.
ResultColumn estimates(std::string key, std::string words, std::string unit = "1", int decimals = -1);

// Statistics of a campaign file over arrangements: for every case the row of Table 3, with intervals.
//
// A member that failed or has not run yet is a missing value, never zero. One arrangement is one value: the floes of an
// arrangement are not independent of each other, so the failure ratio's interval is over arrangements too.

/// A mean over arrangements with its intervals: Student's, or those of a mixture where members stand out.
struct CaseEstimate : Interval {
    std::size_t standing_out = 0;  ///< members that the intervals count as a kind of their own
};

/// members = done + failed_members + missing_members.
struct MemberCounts {
    int members = 0;          ///< planned
    int done = 0;             ///< with a result; the intervals use these
    int failed_members = 0;   ///< set aside
    int missing_members = 0;  ///< without a result yet
    int not_steady = 0;       ///< done, with a load that by itself has a trend in the window (load_statistics.hpp)
};

/// One case over its arrangements.
struct CaseSummary : MemberCounts {
    CaseRow about;
    JointTrend trend;  ///< of the load through the measured window

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

    MemberCounts counts() const;                                     ///< of all cases together
    bool complete() const { return counts().missing_members == 0; }  ///< every planned member is done or set aside
    const std::string& name_of(std::size_t of_case) const { return cases.at(of_case).about.name; }
    /// Both, for a table.
    Named named(std::size_t of_case) const { return {name_of(of_case), label_of(of_case)}; }
    /// What people call the case: of a design's point its keys, "thickness 0.02 m, speed 0.05 m/s".
    const std::string& label_of(std::size_t of_case) const {
        return labels.empty() ? name_of(of_case) : labels.at(of_case);
    }
};

/// Whether the load of a case rises or falls through the measured window.
JointTrend joint_trend(const Sample& sample, std::size_t of_case);

/// Statistics of every case, in the order of the file.
Summary summarise(const Sample& sample);

/// What `of` gives of 0 to `count` - 1, each value once, in order of appearance, with the numbers that have it.
auto grouped(std::size_t count, const auto& of) {
    using Group = std::pair<std::decay_t<decltype(of(std::size_t{}))>, std::vector<std::size_t>>;
    std::vector<Group> groups;
    for (std::size_t k = 0; k < count; ++k) {
        auto value = of(k);
        auto known = std::ranges::find(groups, value, &Group::first);
        if (known == groups.end()) known = groups.insert(known, {std::move(value), {}});
        known->second.push_back(k);
    }
    return groups;
}

/// The cases in a message: "E30, E60".
std::string label_list(const Summary& summary, const std::vector<std::size_t>& cases);

/// Colour and name of every case; none of more than twelve, which could not be told apart.
std::vector<std::pair<std::string, std::string>> case_legend(const Summary& summary);

/// Index of the case named `name`. Throws InputError that lists the names of all cases.
std::size_t case_index(const Summary& summary, std::string_view name);

/// Index of the case that the others are compared with, as Table 3 does; none: no comparison.
using Reference = std::optional<std::size_t>;

/// What the brackets of Table 3 show: the difference of the estimate from the reference case's, %, negative when
/// smaller (the paper prints the magnitude). NaN if undefined.
double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference, const Quantity& quantity);

/// About how many arrangements give the mean to ± `share` of itself, from the scatter of `runs` so far; 0: unknown.
int arrangements_for(const Interval& found, int runs, double share);

}  // namespace floes
