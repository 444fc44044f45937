#pragma once
// A campaign file's members as statistics over arrangements: the row of Table 3, with intervals, for every case.
//
// A member that failed or has not run yet is a missing value, never zero. One arrangement is one value: the floes of an
// arrangement are not independent of each other, so the failure ratio's interval is over arrangements too.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_file/campaign_file.hpp"
#include "inference/bootstrap.hpp"
#include "inference/interval.hpp"

namespace floes {

/// Failed joints, totals over the members that are done.
struct FailureCounts {
    std::int64_t bending = 0;
    std::int64_t shear = 0;
    std::int64_t compression = 0;
};

/// A mean over arrangements with Student's intervals and, beside them, the BCa bootstrap's of the mean.
struct Estimate : Interval {
    Limits bca{};
};

/// One case over its arrangements. members = done + failed_members + missing_members.
struct CaseSummary {
    CaseRow about;
    int members = 0;                        ///< that the campaign plans
    int done = 0;                           ///< that the intervals are made of
    int failed_members = 0;                 ///< set aside
    int missing_members = 0;                ///< without a result yet
    int not_steady = 0;                     ///< done, with a load that still had a trend in the window
    Estimate mean{};                        ///< N
    Estimate sd{};                          ///< N
    Estimate maximum{};                     ///< N, over the whole window
    Estimate mean_maximum{};                ///< N, of the segments' maxima
    Estimate sd_maximum{};                  ///< N, of the segments' maxima
    Estimate failure_ratio{};               ///< 0-1
    Estimate bending{};                     ///< joints failed in bending in one run
    Estimate shear{};                       ///< in shear
    Estimate compression{};                 ///< in compression
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

/// A quantity of Table 3 that is a mean over arrangements. Its intervals are cut to [least, most], where it lies.
struct Quantity {
    std::string_view key;    ///< in JSON, and the beginning of the CSV columns; ends in the unit
    std::string_view label;  ///< in the table
    Estimate CaseSummary::*interval;
    double (*value)(const MemberRow&);
    double least = 0;
    double most = std::numeric_limits<double>::infinity();
};

inline constexpr double no_least = -std::numeric_limits<double>::infinity();

inline constexpr std::array<Quantity, 9> quantities{{
    {"mean_N", "mean, N", &CaseSummary::mean, [](const MemberRow& row) { return row.mean_load; }, no_least},
    {"sd_N", "SD, N", &CaseSummary::sd, [](const MemberRow& row) { return row.sd_load; }},
    {"maximum_N", "maximum, N", &CaseSummary::maximum, [](const MemberRow& row) { return row.maximum_load; }, no_least},
    {"mean_maximum_N", "mean maximum, N", &CaseSummary::mean_maximum,
     [](const MemberRow& row) { return row.mean_maximum; }, no_least},
    {"sd_maximum_N", "SD maximum, N", &CaseSummary::sd_maximum, [](const MemberRow& row) { return row.sd_maximum; }},
    {"failure_ratio", "failure ratio, %", &CaseSummary::failure_ratio,
     [](const MemberRow& row) { return row.failure_ratio; }, 0, 1},
    {"failures_bending_per_run", "joints failed in bending", &CaseSummary::bending,
     [](const MemberRow& row) { return static_cast<double>(row.failures_bending); }},
    {"failures_shear_per_run", "  in shear", &CaseSummary::shear,
     [](const MemberRow& row) { return static_cast<double>(row.failures_shear); }},
    {"failures_compression_per_run", "  in compression", &CaseSummary::compression,
     [](const MemberRow& row) { return static_cast<double>(row.failures_compression); }},
}};

/// The quantities that a case's row of Table 3 has: all but the failures by mode.
inline constexpr std::span<const Quantity> table3_quantities{quantities.data(), 6};

/// Statistics of every case, in the order of the file.
Summary summarise(const CampaignTable& table);

/// Index of the case named `name`. Throws InputError with the names there are.
std::size_t case_index(const Summary& summary, std::string_view name);

/// What the brackets of Table 3 show: the difference of the estimate from the reference case's, %, negative when
/// smaller (the paper prints its size). NaN where undefined.
double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference, const Quantity& quantity);

}  // namespace floes
