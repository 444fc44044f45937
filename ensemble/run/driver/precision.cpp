#include "driver/precision.hpp"

namespace floes {

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign) {
    if (!campaign.stop.active()) return {};
    return PrecisionStop(campaign);
}

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignTable& table) {
    std::optional<PrecisionStop> rule = stop_rule_of(campaign);
    for (std::size_t k = 0; rule && k < table.members.size(); ++k) {
        const MemberRow& row = table.members[k];
        const MemberKey key = member_key(campaign, static_cast<int>(k));
        if (row.status != RowStatus::missing)
            rule->put_member(key.arrangement, key.case_index, row.done() ? &row : nullptr);
    }
    if (rule) rule->look();
    return rule;
}

}  // namespace floes
