#pragma once
// Members whose records are stored, in a journal or at hand. A note of each is in memory, some tens of bytes; the
// record is read when somebody asks for it.

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "store/member_record.hpp"

namespace floes {

/// What a run and the sizes of a campaign file need to know of a record.
struct MemberNote {
    double wall_time = 0;  ///< s
    int key = 0;           ///< number of the case's key, see MemberNotes::keys()
    int arrangement = 0;
    int attempt = 1;
    std::array<int, found_axes.size()> found{};  ///< places along each of these axes
    MemberStatus status = MemberStatus::done;

    bool done() const { return status == MemberStatus::done; }
};

/// How far the member's arrays go along an axis of found_axes.
int found_along(const MemberNote& note, const ArrayAxis& axis);

/// The notes of records, in order of arrival.
class MemberNotes {
  public:
    void add(const MemberRecord& record);
    void add(const MemberNotes& others);

    std::size_t size() const { return notes_.size(); }
    const MemberNote& operator[](std::size_t k) const { return notes_[k]; }
    /// Every case's key that occurs, and its number.
    const std::map<std::string, int>& keys() const { return keys_; }

  private:
    std::deque<MemberNote> notes_;  ///< never moved while it grows
    std::map<std::string, int> keys_;
};

class StoredMembers {
  public:
    /// Gives record k. Throws RunError if it cannot be read as it was written.
    using Read = std::function<MemberRecord(std::size_t k)>;

    /// `notes` must outlive these.
    StoredMembers(const MemberNotes& notes, Read read);
    /// For records at hand, which must outlive these.
    StoredMembers(std::span<const MemberRecord> records = {});
    StoredMembers(const std::vector<MemberRecord>& records) : StoredMembers(std::span(records)) {}
    StoredMembers(const StoredMembers&) = delete;
    StoredMembers& operator=(const StoredMembers&) = delete;

    const MemberNotes& notes() const { return notes_; }
    MemberRecord read(std::size_t k) const { return read_(k); }

  private:
    MemberNotes own_;  ///< of records at hand
    const MemberNotes& notes_;
    Read read_;
};

/// For each member of the campaign, in member order, the number of the record that counts; none if there is none. Of
/// several records of one member the first done one counts; if none is done, the last failure.
std::vector<std::optional<std::size_t>> match_records(const Campaign& campaign, const MemberNotes& notes);

/// The largest attempt number recorded for each member, in member order; 0 if there is none.
std::vector<int> last_attempts(const Campaign& campaign, const MemberNotes& notes);

}  // namespace floes
