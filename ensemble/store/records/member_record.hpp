#pragma once
// A finished member as stored: its identity, its provenance, and the result to the last bit.

#include <cstdint>
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

MemberIdentity identity(const MemberRecord& record);

/// The bytes of a record, the same on every machine.
Bytes encode(const MemberRecord& record);

/// Restores the record bit for bit. Throws RunError if the bytes are not exactly one record.
MemberRecord decode_member_record(std::span<const std::byte> bytes);

/// The same for records of journals of schema 1 and 2; an unpacked history is packed.
MemberRecord decode_older_member_record(std::span<const std::byte> bytes);

}  // namespace floes
