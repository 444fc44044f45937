#include "driver/inventory.hpp"

#include <algorithm>
#include <limits>

#include "campaign/identity.hpp"
#include "driver/precision.hpp"
#include "quantities/quantity.hpp"

namespace floes {

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const Part& part) {
    if (part.of > 1) return {};
    return stop_rule_of(campaign);
}

Inventory take_inventory(const Campaign& campaign, std::span<const MemberRecord> records, const AttemptBook& attempts,
                         const Part& part, bool retry_failed) {
    Inventory found;
    found.precision = stop_rule_of(campaign, part);
    const std::vector<const MemberRecord*> kept = match_records(campaign, records);
    const std::vector<std::string> case_keys = case_fingerprints(campaign);
    for (int number = 0; number < member_count(campaign); ++number) {
        const MemberRecord* record = kept[static_cast<std::size_t>(number)];
        const MemberKey key = member_key(campaign, number);
        const double cost = expected_cost(campaign, number);
        if (record != nullptr && record->result.status == MemberStatus::done) {
            ++found.total;
            ++found.done;
            tell(found.precision, campaign, key, record->result);
            found.pace = std::max(found.pace, record->result.wall_time / cost);
            continue;
        }
        if (!part.has(key.arrangement)) continue;
        ++found.total;
        const int lost = attempts.lost({case_keys[static_cast<std::size_t>(key.case_index)], key.arrangement});
        const int failures = record == nullptr || retry_failed ? 0 : record->attempt;
        if (failures >= campaign.run.attempts) {
            found.set_aside.push_back(key.arrangement);
            tell(found.precision, campaign, key, record->result);
            continue;
        }
        found.tasks.push_back({.number = number,
                               .cost = cost,
                               .batch = found.precision ? key.arrangement / campaign.stop.batch : 0,
                               .attempts_made = failures + lost,
                               .failures = failures,
                               .suspect = lost > 0});
        found.tasks_cost += cost;
        if (record != nullptr || lost > 0) ++found.retried;
    }
    if (found.precise()) {
        found.tasks.clear();
        found.tasks_cost = 0;
        found.retried = 0;
    }
    return found;
}

std::vector<std::string> case_fingerprints(const Campaign& campaign) {
    std::vector<std::string> keys;
    for (int k = 0; k < static_cast<int>(campaign.cases.size()); ++k) keys.push_back(case_fingerprint(campaign, k));
    return keys;
}

void tell(std::optional<PrecisionStop>& rule, const Campaign& campaign, const MemberKey& member,
          const MemberResult& result) {
    if (!rule) return;
    const bool done = result.status == MemberStatus::done;
    rule->put(member.arrangement, member.case_index,
              done ? any_quantity(campaign.stop.of)->of(result) : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace floes
