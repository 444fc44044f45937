#pragma once
// What the parts of a campaign file are made of, and the functions that write them. For this room only.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "campaign_file/arrangement_rows.hpp"
#include "campaign_file/campaign_table.hpp"
#include "hdf5/write.hpp"
#include "records/calibration_record.hpp"
#include "records/session.hpp"

namespace floes {

struct CampaignContent {
    CampaignContent(const Campaign& of, std::span<const MemberRecord> all_records);

    const Campaign& campaign;
    std::vector<const MemberRecord*> records;  ///< by member; nullptr where there is none
    std::vector<int> attempts;                 ///< by member
    CampaignTable table;
    ArrangementRows arrangement_rows;

    /// The result of a done member, else nullptr: of a failed one nothing stands in the file but that it failed.
    const MemberResult* done(std::size_t member) const;
    std::size_t break_count() const;
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

void write_members(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case counts steps above a load level.
void write_levels(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case averages the load.
void write_averaged(hid_t file, const CampaignContent& content, const CampaignScales& scales);
void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales);
void write_arrangements(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// With /load_map, which a record has beside its history.
void write_history(hid_t file, const CampaignContent& content, const CampaignScales& scales,
                   const HistoryOf& history_of);
void write_breaks(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case was calibrated.
void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations);
void write_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions);

}  // namespace floes
