#include "driver/precision.hpp"

#include <limits>
#include <stdexcept>

namespace floes {

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign) {
    if (!campaign.stop.active()) return {};
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    return PrecisionStop(campaign.stop, names, sharing_groups(campaign));
}

double stop_value(StopQuantity of, const MemberRow& row) {
    if (row.status != RowStatus::done) return std::numeric_limits<double>::quiet_NaN();
    switch (of) {
        case StopQuantity::mean_load:
            return row.mean_load;
        case StopQuantity::sd_load:
            return row.sd_load;
        case StopQuantity::maximum_load:
            return row.maximum_load;
        case StopQuantity::mean_maximum:
            return row.mean_maximum;
        case StopQuantity::failure_ratio:
            return row.failure_ratio;
    }
    throw std::logic_error("a stop rule of no known quantity");
}

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignTable& table) {
    std::optional<PrecisionStop> rule = stop_rule_of(campaign);
    for (std::size_t k = 0; rule && k < table.members.size(); ++k) {
        const MemberRow& row = table.members[k];
        const MemberKey key = member_key(campaign, static_cast<int>(k));
        if (row.status != RowStatus::missing)
            rule->put(key.arrangement, key.case_index, stop_value(campaign.stop.of, row));
    }
    return rule;
}

}  // namespace floes
