#pragma once
// The campaign file: one HDF5 file for a whole campaign. Every dataset, unit and attribute: docs/campaign_file.md.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "quantities/quantity.hpp"
#include "records/calibration_record.hpp"
#include "records/member_record.hpp"
#include "records/session.hpp"

namespace floes {

/// Version of the layout, {major, minor}: a new minor only adds names.
inline constexpr std::array<int, 2> campaign_file_version{1, 4};
inline constexpr const char* campaign_filetype = "floes campaign";

/// Gives the load history of a record whose own was left in the journal.
using HistoryOf = std::function<PackedHistory(const MemberRecord&)>;

inline PackedHistory own_history(const MemberRecord& record) {
    return record.history;
}

/// Writes the file aside, brings it to the disk, and renames it into place: at every moment `path` is the old file or
/// the new one, whole. Members without a record stand as missing. Outside /provenance the values depend on the campaign
/// and the results alone, not on the order or origin of `records`. `sessions`: the last one is the publishing one.
/// `calibrations`: those that gave cases of the campaign their Σ stand in /calibration. `history_of` is asked for one
/// done member after another. Throws RunError naming the call that failed.
void publish(const std::filesystem::path& path, const Campaign& campaign, std::span<const MemberRecord> records,
             std::span<const Session> sessions, std::span<const CalibrationRecord> calibrations = {},
             const HistoryOf& history_of = own_history);

enum class RowStatus : std::int8_t { missing = -1, done = 0, failed = 1 };

/// A case as the file has it.
struct CaseRow {
    std::string name;
    double cfm = 0;              ///< Σ
    double elastic_modulus = 0;  ///< Pa
    FarEnd far_end = FarEnd::ice_sheet;
    double contact_erp = 0;  ///< Γ of contacts
    Shape shape;             ///< of the structure
    Analysis analysis;       ///< when the load was measured; its levels are those of CampaignTable
    double time_step = 0;    ///< Δt, s

    double window_steps() const { return analysis.window / time_step; }
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
};

/// Puts `counts`, which belong to the levels `own`, to their places among `all` levels, which have them all.
void set_levels(MemberRow& row, std::span<const double> all, std::span<const double> own,
                std::span<const LevelCount> counts);

/// What summaries need of a campaign file.
struct CampaignTable {
    std::string title;
    std::vector<CaseRow> cases;
    std::vector<MemberRow> members;            ///< in member order
    std::vector<double> levels;                ///< N, rising: every level that some case counts steps above
    std::vector<double> averaging_times = {};  ///< s, rising: every time that some case averages the load over

    /// The list of quantities, with those of the averaged load.
    std::vector<Quantity> quantities() const { return quantities_with(averaging_times); }
};

/// Throws InputError when there is no such file, it is no campaign file, or its major version is not this program's.
CampaignTable read_campaign_file(const std::filesystem::path& path);

/// The table that read_campaign_file() gives after publish() of the same members.
CampaignTable campaign_table(const Campaign& campaign, std::span<const MemberRecord> records);

}  // namespace floes
