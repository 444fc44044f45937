#pragma once
// Which attempts were begun and never came to an end: the trace of a member that takes its process down. A journal
// keeps the book, since nobody else is there afterwards.

#include <map>
#include <string>
#include <utility>

namespace floes {

/// A member as the journal knows it: the fingerprint of its case, and its arrangement number.
using MemberIdentity = std::pair<std::string, int>;

class AttemptBook {
  public:
    void started(const MemberIdentity& member) { entries_[member].open = true; }
    /// A result is there; the account of the member begins anew.
    void finished(const MemberIdentity& member) { entries_.erase(member); }
    /// The session ended by itself: no member is to blame for what was under way.
    void session_ended();
    /// A session begins, or somebody asks who knows that none is at work: what is still under way was lost.
    void close_session();

    /// Sessions that were lost while the member was under way, since its last result if it has one.
    int lost(const MemberIdentity& member) const;

  private:
    struct Entry {
        bool open = false;
        int lost = 0;
    };
    std::map<MemberIdentity, Entry> entries_;
};

}  // namespace floes
