#pragma once
// When to sync the journal, write the heartbeat and publish the campaign file: a state machine that is given the time
// and reads no clock.

#include <chrono>

namespace floes {

class UpkeepTimer {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `publish_every`: minimum time between two publications.
    UpkeepTimer(Time begin, std::chrono::seconds publish_every);

    /// Notes that the journal has a new result, not yet on the disk or in the campaign file.
    void kept();

    /// True every 0.9 s: "within a second", with a margin for the disk.
    bool sync_is_due(Time now) const;
    /// The journal has something that is not on the disk yet.
    bool is_unsynced() const { return unsynced_; }
    void synced(Time now);

    /// True at the beginning, then every 5 s.
    bool heartbeat_is_due(Time now) const { return now >= next_heartbeat_; }
    void heartbeat_written(Time now);

    /// True if the campaign file lacks a result and publishing is due.
    bool publishing_is_due(Time now) const { return unpublished_ && now >= next_publishing_; }
    /// Publishing took from `begin` to `end`. The next one, also after a failure, is delayed so that publishing takes
    /// at most a twentieth of the time.
    void published(Time begin, Time end, bool success);

  private:
    std::chrono::seconds publish_every_;
    Time last_sync_;
    Time next_heartbeat_;
    Time next_publishing_;
    bool unsynced_ = false;
    bool unpublished_ = false;
};

}  // namespace floes
