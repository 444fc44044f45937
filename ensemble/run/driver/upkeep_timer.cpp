#include "driver/upkeep_timer.hpp"

#include <algorithm>

namespace floes {

namespace {

constexpr std::chrono::milliseconds sync_interval{900};
constexpr std::chrono::seconds heartbeat_interval{5};
constexpr int least_work_per_publishing = 20;

}  // namespace

UpkeepTimer::UpkeepTimer(Time begin, std::chrono::seconds publish_every)
    : publish_every_(publish_every),
      last_sync_(begin),
      next_heartbeat_(begin),
      next_publishing_(begin + publish_every) {}

void UpkeepTimer::kept() {
    unsynced_ = true;
    unpublished_ = true;
}

bool UpkeepTimer::sync_is_due(Time now) const {
    return now - last_sync_ >= sync_interval;
}

void UpkeepTimer::synced(Time now) {
    unsynced_ = false;
    last_sync_ = now;
}

void UpkeepTimer::heartbeat_written(Time now) {
    next_heartbeat_ = now + heartbeat_interval;
}

void UpkeepTimer::published(Time begin, Time end, bool success) {
    if (success) unpublished_ = false;
    next_publishing_ = end + std::max<Time::duration>(publish_every_, least_work_per_publishing * (end - begin));
}

}  // namespace floes
