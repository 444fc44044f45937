#pragma once
// Which attempts began but never ended: the trace of a member that crashes its process. It is kept in the journal,
// which survives the process.

#include <map>
#include <string>
#include <utility>

namespace floes {

/// Identity of a member in the journal: the fingerprint of its case, and its arrangement number.
using MemberIdentity = std::pair<std::string, int>;

class AttemptBook {
  public:
    void started(const MemberIdentity& member) { entries_[member].open = true; }
    /// The member has a result; its count starts again from zero.
    void finished(const MemberIdentity& member) { entries_.erase(member); }
    /// The session ended properly: running attempts do not count against their members.
    void session_ended();
    /// A new session begins, or the caller knows that none is active: attempts still running were lost.
    void close_session();

    /// Number of sessions lost while the member was running, since its last result if it has one.
    int lost(const MemberIdentity& member) const;

  private:
    struct Entry {
        bool open = false;
        int lost = 0;
    };
    std::map<MemberIdentity, Entry> entries_;
};

}  // namespace floes
