#pragma once
// A member's result as bytes, to the last bit and the same on every machine: what journals keep, and what goes between
// ranks and between a member's own process and the one that waits for it.

#include "core/bytes.hpp"
#include "member/result.hpp"

namespace floes {

/// All but the averaged load.
void write(ByteWriter& out, const MemberResult& result);

/// What write() wrote, bit for bit. Throws RunError when the bytes are no result.
MemberResult read_member_result(ByteReader& in);

/// The averaged load, which stands at the very end of a record: older ones end before it.
void write_averaged(ByteWriter& out, const MemberResult& result);

/// What write_averaged() wrote; nothing where the bytes end. Throws RunError when they are no such thing.
void read_averaged(ByteReader& in, MemberResult& result);

/// What versions wrote before quantities had their keys beside them (journals of schema 1 and 2). Where the result is
/// the last thing in the bytes, those of still older versions are read as well.
MemberResult read_older_member_result(ByteReader& in);

}  // namespace floes
