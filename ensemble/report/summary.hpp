#pragma once
// A campaign file's members as statistics over arrangements: the row of Table 3, with intervals, for every case.
//
// A member that failed or has not run yet is a missing value, never zero. One arrangement is one value: the floes of an
// arrangement are not independent of each other, so the failure ratio's interval is over arrangements too.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inference/interval.hpp"
#include "store/campaign_file.hpp"

namespace floes {

/// Failed joints, totals over the members that are done.
struct FailureCounts {
    std::int64_t bending = 0;
    std::int64_t shear = 0;
    std::int64_t compression = 0;
};

/// One case over its arrangements. members = done + failed_members + missing_members.
struct CaseSummary {
    CaseRow about;
    int members = 0;                        ///< that the campaign plans
    int done = 0;                           ///< that the intervals are made of
    int failed_members = 0;                 ///< set aside
    int missing_members = 0;                ///< without a result yet
    int not_steady = 0;                     ///< done, with a load that still had a trend in the window
    Interval mean{};                        ///< N
    Interval sd{};                          ///< N
    Interval maximum{};                     ///< N, over the whole window
    Interval mean_maximum{};                ///< N, of the segments' maxima
    Interval sd_maximum{};                  ///< N, of the segments' maxima
    Interval failure_ratio{};               ///< 0-1; both intervals are cut to that range
    std::optional<FailureCounts> failures;  ///< none when no member is done
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

    bool complete() const;  ///< every planned member is done or set aside
};

/// A quantity of Table 3 that is a mean over arrangements.
struct Quantity {
    std::string_view key;    ///< in JSON, and the beginning of the CSV columns; ends in the unit
    std::string_view label;  ///< in the table
    Interval CaseSummary::*interval;
    double MemberRow::*value;
};

inline constexpr std::array<Quantity, 6> quantities{{
    {"mean_N", "mean, N", &CaseSummary::mean, &MemberRow::mean_load},
    {"sd_N", "SD, N", &CaseSummary::sd, &MemberRow::sd_load},
    {"maximum_N", "maximum, N", &CaseSummary::maximum, &MemberRow::maximum_load},
    {"mean_maximum_N", "mean maximum, N", &CaseSummary::mean_maximum, &MemberRow::mean_maximum},
    {"sd_maximum_N", "SD maximum, N", &CaseSummary::sd_maximum, &MemberRow::sd_maximum},
    {"failure_ratio", "failure ratio, %", &CaseSummary::failure_ratio, &MemberRow::failure_ratio},
}};

/// Statistics of every case, in the order of the file.
Summary summarise(const CampaignTable& table);

/// Index of the case named `name`. Throws InputError with the names there are.
std::size_t case_index(const Summary& summary, std::string_view name);

/// What the brackets of Table 3 show: the difference of the estimate from the reference case's, %, negative when
/// smaller (the paper prints its size). NaN where undefined.
double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference, const Quantity& quantity);

}  // namespace floes
