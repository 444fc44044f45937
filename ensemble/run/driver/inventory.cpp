#include "driver/inventory.hpp"

#include <algorithm>

#include "campaign/identity.hpp"
#include "driver/precision.hpp"

namespace floes {

std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignPart& part) {
    if (part.of > 1) return {};
    return stop_rule_of(campaign);
}

Inventory take_inventory(const Campaign& campaign, const StoredMembers& members, const AttemptBook& attempts,
                         const CampaignPart& part, bool retry_failed) {
    Inventory found;
    found.precision = stop_rule_of(campaign, part);
    const std::vector<std::optional<std::size_t>> kept = match_records(campaign, members.notes());
    const auto tell_rule = [&](const MemberKey& key, std::size_t record) {
        if (found.precision) tell(found.precision, key, members.read(record));
    };
    const std::vector<std::string> case_keys = case_fingerprints(campaign);
    for (int number = 0; number < member_count(campaign); ++number) {
        const std::optional<std::size_t> record = kept[static_cast<std::size_t>(number)];
        const MemberNote* note = record ? &members.notes()[*record] : nullptr;
        const MemberKey key = member_key(campaign, number);
        const double cost = expected_cost(campaign, number);
        if (note != nullptr && note->done()) {
            ++found.total;
            ++found.done;
            tell_rule(key, *record);
            found.pace = std::max(found.pace, note->wall_time / cost);
            continue;
        }
        if (!part.has(key.arrangement)) continue;
        ++found.total;
        const int lost = attempts.lost({case_keys[static_cast<std::size_t>(key.case_index)], key.arrangement});
        const int failures = note == nullptr || retry_failed ? 0 : note->attempt;
        if (failures >= campaign.run.attempts) {
            found.set_aside.push_back(key.arrangement);
            tell_rule(key, *record);
            continue;
        }
        found.tasks.push_back({.number = number,
                               .cost = cost,
                               .batch = found.precision ? key.arrangement / campaign.stop.batch : 0,
                               .attempts_made = failures + lost,
                               .failures = failures,
                               .suspect = lost > 0});
        found.tasks_cost += cost;
        if (note != nullptr || lost > 0) ++found.retried;
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

void tell(std::optional<PrecisionStop>& rule, const MemberKey& member, const MemberRecord& record) {
    if (!rule) return;
    if (record.result.status != MemberStatus::done) {
        rule->put_member(member.arrangement, member.case_index, nullptr);
        return;
    }
    const MemberResult whole = record.whole(MemberRecord::Arrays::in_table);
    rule->put_member(member.arrangement, member.case_index, &whole);
}

}  // namespace floes
