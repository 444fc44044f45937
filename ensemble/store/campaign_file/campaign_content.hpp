#pragma once
// What the parts of a campaign file are made of, and the functions that write them. For this room only.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "campaign_file/array_places.hpp"
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
    ArrayPlaces places;

    const CampaignTable& table() const { return rows.table(); }
    /// Of an axis that members find: how far it goes in the file.
    std::size_t found(const ArrayAxis& axis) const;
    /// Whether the file has the array: none of its axes is without places.
    bool has(const ArrayOutput& array) const;
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
class CampaignScales {
  public:
    CampaignScales(hid_t file, const CampaignContent& content);

    const hdf5::Scale& along(const ArrayAxis& axis) const { return axes_.at(&axis); }

    hdf5::Scale member;
    hdf5::Scale case_;
    hdf5::Scale arrangement;
    hdf5::Scale profile_point;

  private:
    std::map<const ArrayAxis*, hdf5::Scale> axes_;
};

// These make datasets that are filled as `tables` get one member after another.

/// Quantities and states, a row for each member.
void add_members(hid_t group, const CampaignScales& scales, MemberTables& tables);
/// Those arrays of members that lie in the group of that name.
void add_arrays(hid_t group, std::string_view name, const CampaignContent& content, const CampaignScales& scales,
                MemberTables& tables);
/// The number of each arrangement.
void add_arrangement_numbers(hid_t group, const CampaignContent& content, const CampaignScales& scales,
                             MemberTables& tables);
/// /provenance, with all that is not of members.
void add_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions,
                    MemberTables& tables);

// These write what is not of members.

void write_cases(hid_t file, const CampaignContent& content, const CampaignScales& scales);
/// Nothing where no case was calibrated.
void write_calibration(hid_t file, const CampaignContent& content, std::span<const CalibrationRecord> calibrations);

}  // namespace floes
