#include "driver/tally.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace floes {

namespace {

constexpr std::size_t most_told = 20;  // running members

}  // namespace

Tally::Tally(const Campaign& campaign, Inventory found, Time begin)
    : campaign_(campaign),
      case_keys_(case_fingerprints(campaign)),
      found_(std::move(found)),
      precision_(found_.precision),
      begin_(begin) {}

void Tally::started(int number, int attempt, Time now) {
    under_way_[identity_of(number)] = {number, attempt, now};
}

void Tally::kept(const MemberRecord& record) {
    under_way_.erase(identity(record));
    if (record.result.status == MemberStatus::done) {
        ++computed_;
    } else {
        set_aside_.push_back(record.arrangement);
    }
    const auto known = std::ranges::find(case_keys_, record.case_key);
    finished_cost_ += expected_cost(campaign_, static_cast<int>(known - case_keys_.begin()));
    for (std::size_t k = 0; k < case_keys_.size(); ++k) {
        if (case_keys_[k] != record.case_key) continue;
        tell(precision_, {static_cast<int>(k), record.arrangement}, record);
    }
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
        heartbeat.under_way.push_back({one.number, one.attempt, seconds(one.since)});
    std::ranges::sort(heartbeat.under_way, std::greater(), &Heartbeat::UnderWay::seconds);
    if (heartbeat.under_way.size() > most_told) heartbeat.under_way.resize(most_told);
    return heartbeat;
}

}  // namespace floes
