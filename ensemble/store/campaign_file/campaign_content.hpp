#pragma once
// What the parts of a campaign file are made of, and the functions that write them. For this room only.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "campaign_file/member_rows.hpp"
#include "campaign_file/member_tables.hpp"
#include "hdf5/write.hpp"
#include "records/calibration_record.hpp"
#include "records/session.hpp"

namespace floes {

struct CampaignContent {
    CampaignContent(const Campaign& of, const StoredMembers& all_members);

    const Campaign& campaign;
    const StoredMembers& members;
    std::vector<std::optional<std::size_t>> records;  ///< by member: number of its record; none where there is none
    std::vector<int> attempts;                        ///< by member
    MemberRows rows;

    const CampaignTable& table() const { return rows.table(); }
    /// Of done members.
    std::size_t break_count() const;
    /// The most of an averaged load of a done member.
    std::size_t most_peaks() const;
    /// The largest of a count over the cases' scenarios.
    template <class Function>
    std::size_t largest(Function function) const {
        std::size_t value = 0;
        for (const Case& one : campaign.cases)
            value = std::max(value, static_cast<std::size_t>(function(one.scenario)));
        return value;
    }
};

/// The dimensions at the root: only there do netCDF readers find them from every group.
struct CampaignScales {
    CampaignScales(hid_t file, const CampaignContent& content);

    hdf5::Scale member;
    hdf5::Scale case_;
    hdf5::Scale arrangement;
    hdf5::Scale segment;
    hdf5::Scale floe;
    hdf5::Scale time;
    hdf5::Scale coordinate;
    hdf5::Scale profile_point;
    hdf5::Scale break_;
};

// These make datasets that are filled as `tables` get one member after another.

void add_members(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables);
/// Nothing where no case counts steps above a load level.
void add_levels(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables);
/// Nothing where no case averages the load.
void add_averaged(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables);
void add_arrangements(hid_t file, const CampaignContent& content, const CampaignScales& scales, MemberTables& tables);
/// With /load_map, which a record has beside its history.
void add_history(hid_t file, const CampaignScales& scales, MemberTables& tables);
void add_breaks(hid_t file, const CampaignScales& scales, MemberTables& tables);
/// /provenance, with all that is not of members.
void add_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions,
                    MemberTables& tables);

// These write what is not of members.

void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case was calibrated.
void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations);

}  // namespace floes
