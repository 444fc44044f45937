#pragma once
// The design load of each case: the largest averaged load in an exposure, by every method, and what it rests on.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findings/evidence.hpp"
#include "inference/design_load.hpp"
#include "tables/section.hpp"

namespace floes {

/// Why a case has no design value, not for want of loads; of nothing by default.
struct Lack {
    std::string why{};       ///< without a full stop
    std::string in_brief{};  ///< as a cell of a table says it

    explicit operator bool() const { return !why.empty(); }
};

struct CasePeaks {
    std::vector<PeakRow> rows;
    std::vector<int> arrangements;         ///< of the rows, in their order
    std::vector<int> members;              ///< the same
    std::vector<MemberTrend> trends = {};  ///< the same; empty: as the load's
    Measured measured;
    Lack lacks = {};

    /// A row of a member whose load has this mean; average() then makes the mean of all.
    void add(int member, int arrangement, PeakRow row, double mean);
    void average();
};

/// In the window of a case, without the mean; `separation` of peaks, s.
Measured measured_in(const Analysis& analysis, double separation);

/// Of a member, at that place of the arrays "averaged/..." or "responses/..."; empty where it has none.
PeakRow peak_row(const Sample& sample, std::string_view arrays, std::size_t member, std::size_t place);

/// Design load of the done members that averaged their load over `time`, s.
CasePeaks case_peaks(const Sample& sample, std::size_t of_case, double time);

/// The mooring force k x that stored loads of a fixed hull make.
extern const DesignOf design_of_k_x;

struct CaseDesignLoad {
    std::size_t case_index = 0;
    double separation = 0;          ///< s, between peaks
    std::vector<int> arrangements;  ///< of the rows, in their order
    std::vector<int> members;       ///< the same
    std::vector<double> peaks;      ///< of all rows, falling, N
    DesignLoad load;                ///< at the scale of the campaign; not valid if refused
    JointTrend trend;
    bool refused = false;  ///< it rises, and nobody asked for it to be extrapolated
    Lack lacks = {};
    /// Whether all members are of one kind, which the other methods and pairs take for granted.
    bool of_one_kind() const { return load.unlike.out.empty(); }

    std::vector<double> over_shares;  ///< the first quantile with more and fewer peaks, to defend the threshold
};

/// The first quantile of a case less that of another, at full scale and in the unit that people are shown.
struct DesignDifference {
    Estimate difference;
    bool paired = false;  ///< over the same arrangements; otherwise of cases that have nothing in common
};

/// With members taken as alike; none where a case has no value or members that stand out, or where cases share some of
/// their arrangements.
std::optional<DesignDifference> difference_of(const CaseDesignLoad& first, const CaseDesignLoad& second,
                                              const DesignLoadRequest& request);

/// How many arrangements more than it has would give a value, or an interval half as wide where it has a value; 0:
/// more of them would not help.
int more_arrangements(const CaseDesignLoad& one);

/// "2 of 50 members carry the 14 highest peaks: replay 17 and 31.", and what follows from it; empty if none stands out.
std::string standing_out_text(const CaseDesignLoad& one);

/// How far the methods lie apart, relative to the load by both tails; of the first quantile. `load` is valid.
double disagreement(const DesignLoad& load);

/// Why there is none, of a load that is not valid: "too few peaks (3 of 20) to fit; about 27 arrangements would do."
std::string none_text(const CaseDesignLoad& one, const CaseRow& about);

/// A disagreement that is said beside the load.
inline constexpr double much_disagreement = 0.25;

/// The campaign's own averaging time that the request means, s at the campaign's scale. Throws InputError if there is
/// none.
double averaging_time(const CampaignCases& cases, const DesignLoadRequest& request);

/// The time that a page averages the load over where nobody says another, s: the usual one, or the longest that the
/// members have.
double usual_averaging(const CampaignCases& cases);

/// The design values of a campaign.
struct DesignLoads {
    DesignLoadRequest asked = {};
    std::vector<CaseDesignLoad> of_cases = {};
    std::string refused = {};  ///< why there are none, a sentence

    bool known() const;  ///< of some case
};

/// Of each case. Throws InputError if the members did not average over that time.
DesignLoads find_design_loads(const Sample& sample, const DesignLoadRequest& request);

/// The same of other peaks, one for each case.
DesignLoads find_design_loads(const Sample& sample, const DesignLoadRequest& request,
                              const std::vector<CasePeaks>& peaks);

/// As requested, else as `floes design` has them by default, over the longest averaging time where the members did not
/// take 1 s; found once; of no case where the members did not average their load. Throws InputError if the members did
/// not take the averaging time that is requested.
const DesignLoads& designs_of(Evidence& evidence);

// The design loads of a campaign as output.

/// That suit these loads at full scale; `otherwise` where there are none.
Units design_units(const DesignLoads& designs, const Units& otherwise);

/// The design values of each case alone, the second of the sections below.
Section design_values_section(const Summary& summary, const DesignLoads& designs);

/// The loads, what they rest on, and the differences between cases with the same arrangements whose members are of one
/// kind. For programs "design/loads" at full scale, with a `reason` in the place of a load that there is not, and at
/// the scale of the campaign "design/basis", "design/over_thresholds" and "design/rates".
std::vector<Section> design_load_sections(const Summary& summary, const DesignLoads& designs);

}  // namespace floes
