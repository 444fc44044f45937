#pragma once
// Rows of members, made of their records one by one; member_rows.cpp has campaign_table() too. For this room only.

#include <cstddef>

#include "campaign_file/arrangement_rows.hpp"
#include "campaign_file/campaign_table.hpp"

namespace floes {

class MemberRows {
  public:
    /// `campaign` must outlive the rows.
    explicit MemberRows(const Campaign& campaign);

    /// The campaign's table, without members.
    const CampaignTable& table() const { return table_; }
    const ArrangementRows& arrangements() const { return arrangements_; }
    /// `record`: nullptr where there is none.
    MemberRow row(std::size_t member, const MemberRecord* record) const;
    MemberRow row(std::size_t member, RowStatus status, const MemberResult& result) const;

  private:
    const Campaign& campaign_;
    CampaignTable table_;
    ArrangementRows arrangements_;
};

}  // namespace floes
