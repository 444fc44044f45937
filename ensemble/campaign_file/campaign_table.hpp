#pragma once
// What a campaign file says of its cases and members: members as rows, as they are stored, and in columns, as
// statistics take them. Every dataset, unit and attribute: docs/campaign_file.md.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/campaign.hpp"
#include "member/quantity.hpp"
#include "store/member_record.hpp"

namespace floes {

/// Σ of joints that follow it; NaN for beams, which have none.
inline double followed_cfm(const Joint& joint) {
    return joint.model == JointModel::cfm ? joint.cfm : std::numeric_limits<double>::quiet_NaN();
}

enum class RowStatus : std::int8_t { missing = -1, done = 0, failed = 1 };

/// A case as the file has it.
struct CaseRow {
    std::string name;
    double cfm = 0;              ///< Σ; NaN where joints are beams
    double elastic_modulus = 0;  ///< Pa
    FarEnd far_end = FarEnd::ice_sheet;
    ContactLaw contact;    ///< only its laws, Γ and crushing pressure; the pressure is the one in force
    Shape shape;           ///< of the structure
    Analysis analysis;     ///< when the load was measured; its levels are those of CampaignTable
    double time_step = 0;  ///< Δt, s
    Field field = {};
    double field_length = 0;          ///< m; 0: unknown
    std::optional<BankGap> gap = {};  ///< Scenario::gap()
    Vec2 current = Vec2::Zero();      ///< along x and z, m/s
    Wind wind = {};
    Joint joint = {};
    Words floes = {};     ///< floe_words()
    Words motion = {};    ///< motion_words()
    int most_sweeps = 0;  ///< of a step, where a tolerance ends them; 0: all steps take as many
    /// Where the window of `analysis` is from: the configuration, or the steady part that was looked for in it.
    enum class Window { given, steady, none_steady } window = Window::given;

    double window_steps() const { return analysis.window / time_step; }
    /// By --window auto, which was not asked for yet and needs the load of every step.
    bool can_be_measured_later() const {
        return window == Window::given && analysis.keep_history && analysis.history_stride == 1;
    }
};

/// A member as the file has it. Unless the member is done, its outputs are unmeasured().
struct MemberRow : MemberOutputs {
    int case_index = 0;   ///< row of CampaignTable::cases
    int arrangement = 0;  ///< row of /arrangements; equal for members that began from the same floes
    RowStatus status = RowStatus::missing;
    std::string reason;               ///< of a failure
    std::vector<double> steps_above;  ///< of each of CampaignTable::levels; NaN where the case does not count it
    std::vector<double> upcrossings;  ///< likewise

    bool done() const { return status == RowStatus::done; }
    /// The quantity; NaN unless the member is done, counts too.
    double value(const Quantity& quantity) const;
    /// The load averaged over `time`, s; nullptr unless the member is done and took it.
    const AveragedLoad* averaged_over(double time) const;
};

/// Puts `counts`, which belong to the levels `own`, to their places among `all` levels, which have them all.
void set_levels(MemberRow& row, std::span<const double> all, std::span<const double> own,
                std::span<const LevelCount> counts);

/// A campaign file without its members.
struct CampaignCases {
    std::string title;
    std::vector<CaseRow> cases;
    std::vector<double> levels;                ///< N, rising: every level that some case counts steps above
    std::vector<double> averaging_times = {};  ///< s, rising: every time that some case averages the load over

    /// The list of quantities, with those of the averaged load.
    std::vector<Quantity> quantities() const { return quantities_with(averaging_times); }
};

/// What summaries need of a campaign file.
struct CampaignTable : CampaignCases {
    std::vector<MemberRow> members;  ///< in member order
};

/// The table that read_campaign_file() gives after publish() of the same members.
CampaignTable campaign_table(const Campaign& campaign, const StoredMembers& members);

// The rows of /arrangements: cases that begin from the same floes share a row.

/// Rows are ordered by arrangement number, then by sharing_groups().
class ArrangementRows {
  public:
    explicit ArrangementRows(const Campaign& campaign);

    /// Rows of each arrangement number.
    int groups() const { return groups_; }
    int row(MemberKey member) const;
    /// Arrangement number of a row.
    int number(int row) const { return row / groups_; }

  private:
    std::vector<int> group_of_case_;
    int groups_;
};

// Rows of members, made of their records one by one. For this module only.

/// What a function gives of the scenarios of all cases, rising, each value once.
std::vector<double> of_all_cases(const Campaign& campaign,
                                 const std::function<std::vector<double>(const Scenario&)>& of);

class MemberRows {
  public:
    /// `campaign` must outlive the rows.
    explicit MemberRows(const Campaign& campaign);

    const CampaignCases& cases() const { return cases_; }
    const ArrangementRows& arrangements() const { return arrangements_; }
    /// `record`: nullptr where there is none.
    MemberRow row(std::size_t member, const MemberRecord* record) const;
    MemberRow row(std::size_t member, RowStatus status, const MemberResult& result) const;

  private:
    const Campaign& campaign_;
    CampaignCases cases_;
    ArrangementRows arrangements_;
};

// The members of a campaign in columns: a value of each member, or a row of values along the axes that its array lies
// along (segments, averaging times, parts, levels ...). Statistics take groups of members and a column:
//
//     const Sample sample(table);
//     std::vector<double> means = sample.values(sample.done(0), quantity("mean_load"));
//     std::span<const double> maxima = sample.along("members/segment_maximum", member);

/// Members by number.
using Members = std::vector<std::size_t>;

class Sample : public CampaignCases {
  public:
    Sample() = default;
    /// The table's members: their quantities by key, the arrays that are read with them by path.
    Sample(const CampaignTable& table);  // NOLINT: a table is a sample

    std::size_t members() const { return case_of_.size(); }
    /// Done members of a case by arrangement.
    const Members& done(std::size_t of_case) const { return done_.at(of_case); }
    std::size_t case_of(std::size_t member) const { return case_of_.at(member); }
    /// Equal for members that began from the same floes.
    int arrangement_of(std::size_t member) const { return arrangement_of_.at(member); }
    /// The number of the member's arrangement, as people name it: that of its case.
    int number_of(std::size_t member) const { return static_cast<int>(member / cases.size()); }
    RowStatus status(std::size_t member) const { return status_.at(member); }
    const std::string& reason(std::size_t member) const { return reason_.at(member); }
    /// Whether its load by itself has no trend in the window; false unless it is done.
    bool steady(std::size_t member) const { return steady_.at(member); }

    /// For each of the members; NaN where it was not measured.
    std::vector<double> values(const Members& members, const Quantity& quantity) const;
    double value(std::size_t member, const Quantity& quantity) const;

    /// All numbers of a member in that array, row-major; none where it does not have it.
    std::span<const double> along(std::string_view array, std::size_t member) const;
    /// Row `place` of an array along two axes, without what only fills it up.
    std::span<const double> along(std::string_view array, std::size_t member, std::size_t place) const;
    /// Where a member has the averaging time along the arrays "averaged/..."; none where it did not take it.
    std::optional<std::size_t> place_of_time(std::size_t member, double time) const;
    /// The place of each member along an array of one axis, or at `second` along the other of two; NaN where it ends
    /// before.
    std::vector<double> values(const Members& members, std::string_view array, std::size_t place,
                               std::size_t second = 0) const;

  private:
    struct Array {
        std::vector<std::size_t> first;  ///< of each member, and the end
        std::vector<std::size_t> width;  ///< of each member: places along the last axis
        std::vector<double> values;
    };

    void add(std::string_view path, std::span<const double> values, std::size_t width);

    std::vector<Members> done_;
    std::vector<std::size_t> case_of_;
    std::vector<int> arrangement_of_;
    std::vector<RowStatus> status_;
    std::vector<std::string> reason_;
    std::vector<bool> steady_;
    std::map<std::string, std::vector<double>, std::less<>> columns_;  ///< by key, a value of each member
    std::map<std::string, Array, std::less<>> arrays_;                 ///< by path
};

}  // namespace floes
