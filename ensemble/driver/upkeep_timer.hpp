#pragma once
// When the journal is to be brought to the disk, the heartbeat to be written, and the campaign file to be published: a
// state machine on points in time that it is told; it looks at no clock.

#include <chrono>

namespace floes {

class UpkeepTimer {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// `publish_every`: the shortest time between two publishings.
    UpkeepTimer(Time begin, std::chrono::seconds publish_every);

    /// The journal has a result that neither the disk nor the campaign file has.
    void kept();

    /// True every 0.9 s: "within a second", with room for the disk.
    bool sync_is_due(Time now) const;
    /// The journal has something that the disk does not have.
    bool is_unsynced() const { return unsynced_; }
    void synced(Time now);

    /// True at the beginning, then every 5 s.
    bool heartbeat_is_due(Time now) const { return now >= next_heartbeat_; }
    void heartbeat_written(Time now);

    /// True when the campaign file lacks a result and it is time.
    bool publishing_is_due(Time now) const { return unpublished_ && now >= next_publishing_; }
    /// Publishing took from `begin` to `end`. The next one, also of one that did not succeed, is so far away that
    /// publishing takes at most a twentieth of the time.
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
