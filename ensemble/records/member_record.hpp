#pragma once
// A finished member as stored: its identity, its provenance, and the result to the last bit.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/bytes.hpp"
#include "member/result.hpp"
#include "records/attempt_book.hpp"
#include "records/packed_history.hpp"

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
    MemberResult result;            ///< with an empty history and load map; the packed ones are in
    PackedHistory history;          ///< of the load
};

/// Gives the load history (and map) of a record whose own was left in the journal.
using HistoryOf = std::function<PackedHistory(const MemberRecord&)>;

inline PackedHistory own_history(const MemberRecord& record) {
    return record.history;
}

MemberIdentity identity(const MemberRecord& record);

/// The bytes of a record, the same on every machine.
Bytes encode(const MemberRecord& record);

/// Restores the record bit for bit. Throws RunError if the bytes are not exactly one record.
MemberRecord decode_member_record(std::span<const std::byte> bytes);

/// The same for records of journals of schema 1 and 2; an unpacked history is packed.
MemberRecord decode_older_member_record(std::span<const std::byte> bytes);

/// For each member of the campaign, in member order, the record that counts; nullptr if there is none. Of several
/// records of one member the first done one counts; if none is done, the last failure.
std::vector<const MemberRecord*> match_records(const Campaign& campaign, std::span<const MemberRecord> records);

/// The largest attempt number recorded for each member, in member order; 0 if there is none.
std::vector<int> last_attempts(const Campaign& campaign, std::span<const MemberRecord> records);

}  // namespace floes
