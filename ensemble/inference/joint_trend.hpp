#pragma once
// Whether the load of a case rises or falls through the measured window, over all its members: a single member's load
// wanders too slowly to tell. Each member gives one slope, and one difference of segment maxima, and these are tested.

#include <cstddef>
#include <string>
#include <vector>

#include "inference/interval.hpp"
#include "member/member_outputs.hpp"

namespace floes {

/// What a member says of it.
struct MemberTrend {
    double mean = 0;     ///< load, N
    double rise = 0;     ///< slope of the load times the window, N
    double growth = 0;   ///< largest load of the last segment less that of the first, N; NaN of one segment
    double largest = 0;  ///< mean of the segment maxima, N
};

/// Maxima of the load averaged over the shortest time where members have them, else of single steps. `window`: s.
MemberTrend member_trend(const MemberOutputs& outputs, double window);

/// The change over the measured window, N, mean over members with Student's interval, and its two-sided p; NaN for
/// fewer than 3 members or if all are equal.
struct Change {
    Interval over_window{};
    double p = 1;
};

struct JointTrend {
    std::size_t case_index = 0;
    int members = 0;
    double mean = 0;     ///< load, N
    double largest = 0;  ///< mean of the segment maxima that are tested, N
    Change load;         ///< slope of the load times the window
    Change maxima;       ///< largest load of the last segment less that of the first, averaged over the shortest time
    bool significant = false;  ///< of either, by Holm's adjustment over all cases at 1 %
    bool seen = false;         ///< significant, and not sure to be negligible

    bool by_load = true;  ///< whether the load tells more of it than the maxima

    bool rises() const { return seen && (by_load ? load : maxima).over_window.estimate > 0; }
    bool negligible() const { return significant && !seen; }
};

/// A change that is surely smaller, relative to the mean load or to the mean of the maxima, is negligible. A long
/// exposure passes through one arrangement after another (docs/design_load.md), so a rise does not go on for longer
/// than a passage: it lifts the load of the window's end above that of its middle by half of this, which is less than
/// intervals of design loads say.
inline constexpr double negligible_change = 0.02;

/// The mean of these changes, one of each member, with its interval and p.
Change change_of(const std::vector<double>& values);

/// Whether the interval has a change that matters to a figure of that size.
bool matters(const Change& change, double figure);

/// For each case, in their order, from its members.
std::vector<JointTrend> joint_trends(const std::vector<std::vector<MemberTrend>>& cases);

/// "the load rises by 14 N of 24 N over the measured window (24 members, p = 2e-07)", without a full stop.
std::string trend_text(const JointTrend& trend);

}  // namespace floes
