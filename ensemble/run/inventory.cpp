#include "run/inventory.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace floes {

constexpr std::size_t most_running = 20;  // running members

Tally::Tally(const Campaign& campaign, Inventory found, Time begin)
    : campaign_(campaign),
      case_keys_(case_fingerprints(campaign)),
      found_(std::move(found)),
      precision_(found_.precision),
      begin_(begin) {}

void Tally::kept(const MemberRecord& record) {
    kept(identity(record), record.result.status, &record);
}

void Tally::kept(const MemberIdentity& member, MemberStatus status, const MemberRecord* record) {
    const auto& [case_key, arrangement] = member;
    under_way_.erase(member);
    if (status == MemberStatus::done) {
        ++computed_;
    } else {
        set_aside_.push_back(arrangement);
    }
    const auto known = std::ranges::find(case_keys_, case_key);
    finished_cost_ += expected_cost(campaign_, static_cast<int>(known - case_keys_.begin()));
    if (record == nullptr) return;
    for (std::size_t k = 0; k < case_keys_.size(); ++k)
        if (case_keys_[k] == case_key) tell(precision_, {static_cast<int>(k), arrangement}, *record);
}

int Tally::failed() const {
    const int last = precise() ? precision_->arrangements() : campaign_.arrangements;
    const auto counts = [last](int arrangement) { return arrangement < last; };
    return static_cast<int>(std::ranges::count_if(found_.set_aside, counts) +
                            std::ranges::count_if(set_aside_, counts));
}

Campaign Tally::published() const {
    Campaign campaign = campaign_;
    if (precise()) campaign.arrangements = precision_->arrangements();
    return campaign;
}

MemberIdentity Tally::identity_of(int number) const {
    const MemberKey key = member_key(campaign_, number);
    return {case_keys_[static_cast<std::size_t>(key.case_index)], key.arrangement};
}

Heartbeat Tally::heartbeat(Time now) const {
    const auto seconds = [now](Time since) { return std::chrono::duration<double>(now - since).count(); };
    Heartbeat heartbeat;
    heartbeat.elapsed = seconds(begin_);
    heartbeat.finished = computed() + set_aside();
    heartbeat.finished_cost = finished_cost_;
    heartbeat.remaining_cost = std::max(0.0, found_.tasks_cost - finished_cost_);
    for (const auto& [member, one] : under_way_)
        heartbeat.under_way.push_back({one.number, one.attempt, seconds(one.since), one.time, one.end});
    std::ranges::sort(heartbeat.under_way, std::greater(), &Heartbeat::UnderWay::seconds);
    if (heartbeat.under_way.size() > most_running) heartbeat.under_way.resize(most_running);
    return heartbeat;
}

void Tally::note(const std::vector<MemberProgress>& progress) {
    for (const MemberProgress& one : progress) {
        const auto known = under_way_.find(identity_of(one.number));
        if (known == under_way_.end()) continue;
        known->second.time = one.time;
        known->second.end = one.end;
    }
}

std::vector<Heartbeat::UnderWay> Tally::longest(Time now) const {
    constexpr std::size_t most = 3;
    constexpr double long_run = 120;  // s
    std::vector<Heartbeat::UnderWay> all = heartbeat(now).under_way;
    std::erase_if(all, [](const Heartbeat::UnderWay& one) { return !(one.end > 0) || one.seconds < long_run; });
    if (all.size() > most) all.resize(most);
    return all;
}

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
                               .batch = campaign.stop.active() ? key.arrangement / campaign.stop.batch : 0,
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

void tell(std::optional<PrecisionStop>& rule, const MemberKey& member, const MemberRecord& record) {
    if (!rule) return;
    if (record.result.status != MemberStatus::done) {
        rule->put_member(member.arrangement, member.case_index, nullptr);
        return;
    }
    const MemberResult whole = record.whole(MemberRecord::Arrays::in_table);
    rule->put_member(member.arrangement, member.case_index, &whole);
}

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
