#pragma once
// A finished member as stored: its identity, its provenance, and the result to the last bit; and all that are stored.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/bytes.hpp"
#include "member/result.hpp"
#include "simulation/laboratory.hpp"
#include "store/packed_arrays.hpp"
#include "store/session.hpp"

namespace floes {

/// Identity is (case_key, arrangement), not the member number, so that a record stays valid when its campaign grows.
/// Everything except identity and result is provenance.
struct MemberRecord {
    std::string case_key;  ///< case_fingerprint() of the member's case
    int arrangement = 0;   ///< arrangement number, from 0
    int attempt = 1;       ///< from 1
    int rank = 0;          ///< of the computing process
    std::string host;
    std::uint64_t peak_memory = 0;  ///< largest resident set of the computing process so far, bytes
    MemberResult result;            ///< of a record that was stored, without its arrays: these are in
    PackedArrays arrays;            ///< or still in the result, unpacked

    /// The array of that number in array_outputs, wherever it is.
    PackedArray array(std::size_t number) const;
    /// The result with its arrays: all, or those that are read with the quantities.
    enum class Arrays { all, in_table };
    MemberResult whole(Arrays which = Arrays::all) const;
};

MemberIdentity identity(const MemberRecord& record);

/// The bytes of a record, the same on every machine.
Bytes encode(const MemberRecord& record);

/// Restores the record bit for bit, its arrays packed. Throws RunError if the bytes are not exactly one record.
MemberRecord decode_member_record(std::span<const std::byte> bytes);

// The stored calibration of a case's Σ: the ice it applies to, the Σ found, and the curve measured for it.

struct CalibrationRecord {
    std::string key;  ///< calibration_key() of the ice
    Calibration found;
};

/// 32 hex digits, equal exactly if ice and requested elastic modulus of two scenarios are the same, so that they can
/// share a calibration. Σ is not part of it.
std::string calibration_key(const Scenario& scenario);

/// The record of that key; nullptr if there is none.
const CalibrationRecord* find_calibration(std::span<const CalibrationRecord> records, const std::string& key);

/// For each case of the campaign the calibration of its Σ; nullptr if Σ was not calibrated.
std::vector<const Calibration*> match_calibrations(const Campaign& campaign,
                                                   std::span<const CalibrationRecord> records);

/// The bytes of a record, the same on every machine.
Bytes encode(const CalibrationRecord& record);

/// Restores the record bit for bit. Throws RunError if the bytes are not exactly one record.
CalibrationRecord decode_calibration_record(std::span<const std::byte> bytes);

// Members whose records are stored, in a journal or at hand. A note of each is in memory, some tens of bytes; the
// record is read when somebody asks for it.

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
    /// `note` whatever its number of the key.
    void add(const std::string& key, MemberNote note);
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
