#include "run/keeper.hpp"

#include <utility>

namespace floes {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds sync_interval{900};

}  // namespace

bool SyncTimer::is_due(Time now) const {
    return now - last_sync_ >= sync_interval;
}

void SyncTimer::synced(Time now) {
    unsynced_ = false;
    last_sync_ = now;
}

Keeper::Keeper(Journal journal) : journal_(std::move(journal)), timer_(Clock::now()) {}

void Keeper::keep(const MemberRecord& record) {
    journal_.append(record);
    timer_.kept();
}

void Keeper::tend(SyncTimer::Time now) {
    journal_.hand_over();
    if (timer_.is_due(now)) sync();
}

void Keeper::sync() {
    if (timer_.is_unsynced()) journal_.sync();
    timer_.synced(Clock::now());
}

}  // namespace floes
