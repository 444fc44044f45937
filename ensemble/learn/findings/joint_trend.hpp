#pragma once
// Whether the load of a case rises or falls through the measured window, over all its members: a single member's load
// wanders too slowly to tell. Each member gives one slope, and one difference of segment maxima, and these are tested.

#include <cstddef>
#include <string>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

/// The change over the measured window, N, mean over members with Student's interval, and its two-sided p; NaN for
/// fewer than 3 members or if all are equal.
struct Change {
    Interval over_window{};
    double p = 1;
};

struct JointTrend {
    std::size_t case_index = 0;
    int members = 0;
    double mean = 0;    ///< load, N
    Change load;        ///< slope of the load times the window
    Change maxima;      ///< largest load of the last segment less that of the first, averaged over the shortest time
    bool seen = false;  ///< of either, by Holm's adjustment over all cases at 1 %

    /// Whether the load tells more than the maxima.
    bool by_load() const { return load.p <= maxima.p || !(maxima.p == maxima.p); }
    bool rises() const { return seen && (by_load() ? load : maxima).over_window.estimate > 0; }
};

/// Of each case, in their order. Maxima of averaged loads where members have them, else of single steps.
std::vector<JointTrend> joint_trends(const CampaignTable& table);

/// "the load rises by 14 N of 24 N over the measured window (24 members, p = 2e-07)", without a full stop.
std::string trend_text(const JointTrend& trend);

}  // namespace floes
