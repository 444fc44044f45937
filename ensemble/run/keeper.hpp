#pragma once
// A journal that reaches the disk within a second: what everybody has who keeps records, the master and other writers.

#include <chrono>

#include "store/journal.hpp"

namespace floes {

/// When to sync: a state machine that is given the time and reads no clock.
class SyncTimer {
  public:
    using Time = std::chrono::steady_clock::time_point;

    explicit SyncTimer(Time begin) : last_sync_(begin) {}

    /// Notes that the journal has a new result, not yet on the disk.
    void kept() { unsynced_ = true; }
    /// True every 0.9 s: "within a second", with a margin for the disk.
    bool is_due(Time now) const;
    /// The journal has something that is not on the disk yet.
    bool is_unsynced() const { return unsynced_; }
    void synced(Time now);

  private:
    Time last_sync_;
    bool unsynced_ = false;
};

class Keeper {
  public:
    explicit Keeper(Journal journal);

    /// Keeps a result. It survives the end of this process after the next tend() or hand_over(), and reaches the disk
    /// within a second if tend() is called often.
    void keep(const MemberRecord& record);
    void hand_over() { journal_.hand_over(); }
    void tend(SyncTimer::Time now);
    /// Syncs now what is not on the disk.
    void sync();

    Journal& journal() { return journal_; }
    const Journal& journal() const { return journal_; }

  private:
    Journal journal_;
    SyncTimer timer_;
};

}  // namespace floes
