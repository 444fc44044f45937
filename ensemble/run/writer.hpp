#pragma once
// Who keeps records, and how: a journal that reaches the disk within a second, and which ranks have one.

#include <chrono>
#include <filesystem>
#include <vector>

#include "run/link.hpp"
#include "run/messages.hpp"
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

// Which ranks keep records. In a large run one rank cannot move the bytes of all: groups of neighbouring ranks have a
// writer each, which appends the members of its group to a piece of the journal, syncs it, since from another node
// nobody can, and tells the master of them; at the end it publishes a piece of the campaign file. The master is the
// writer of its own group.

class Groups {
  public:
    /// `writers`: at most so many; 0: one up to 15 ranks, then one for every four, at most 256: so the campaign file
    /// takes seconds.
    explicit Groups(int ranks, int writers = 0);

    int writer_of(int rank) const { return rank - rank % ranks_of_each_; }
    /// The number of the journal's piece that a writer appends to; 0: the journal itself.
    int piece_of(int writer) const { return writer / ranks_of_each_; }
    /// All but the master.
    std::vector<int> writers() const;
    /// The ranks whose records the rank keeps; none if it is no writer.
    std::vector<int> group_of(int writer) const;

  private:
    int ranks_;
    int ranks_of_each_;
};

/// What a writer other than the master does with the members of its group.
class Writer {
  public:
    /// Opens the piece of the journal. Throws as open_journal() does. `campaign` and `link` must outlive the writer.
    Writer(Link& link, const Campaign& campaign, const std::filesystem::path& piece,
           const System& system = this_system());

    /// Keeps a member that was computed by that rank.
    void keep(int worker, Answer answer);
    /// Notes the farewell of a rank.
    void farewell(int worker) { farewells_.push_back(worker); }
    /// To be called often: brings what is new to the disk, and then tells the master.
    void tend();
    /// Brings everything to the disk.
    void sync() { keeper_.sync(); }

  private:
    Link& link_;
    bool has_stop_rule_;
    Keeper keeper_;
    std::vector<Kept> kept_;      // the master has not been told yet
    std::vector<int> farewells_;  // after these
};

}  // namespace floes
