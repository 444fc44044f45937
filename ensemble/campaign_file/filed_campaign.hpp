#pragma once
// A campaign file in place of its journal, which goes when the file has all: the records that it was published from.

#include <filesystem>
#include <functional>
#include <vector>

#include "campaign/campaign.hpp"
#include "store/journal.hpp"
#include "store/member_record.hpp"
#include "store/session.hpp"

namespace floes {

struct FiledCampaign {
    Campaign campaign;
    MemberNotes notes;                              ///< of done members, in member order; what they found is left out
    std::function<MemberRecord(std::size_t)> read;  ///< the record of note k, to the last bit
    std::vector<Session> sessions;                  ///< without part and clock
    std::vector<CalibrationRecord> calibrations;

    bool is_whole() const { return static_cast<int>(notes.size()) == member_count(campaign); }
};

/// Throws as read_campaign_file() does, and so does `read` of what it gives.
FiledCampaign read_filed(const std::filesystem::path& path);

/// Appends to the journal what of the campaign it does not have, and syncs it: all, where the file is whole and the
/// journal went; some, where the power was cut meanwhile, or the journal is damaged.
void take_in(const FiledCampaign& filed, const Campaign& campaign, Journal& journal);

/// What reads a campaign file so.
using ContentReader = std::function<FiledCampaign(const std::filesystem::path& path)>;

}  // namespace floes
