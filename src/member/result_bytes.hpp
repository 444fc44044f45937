#pragma once
// A member's result as bytes, exact and the same on every machine: for journals, and for messages between ranks and
// from isolated processes.

#include "core/bytes.hpp"
#include "member/result.hpp"

namespace floes {

/// All but the averaged load.
void write(ByteWriter& out, const MemberResult& result);

/// Restores what write() wrote, bit for bit. Throws RunError if the bytes are not a result.
MemberResult read_member_result(ByteReader& in);

/// The averaged load, which stands at the very end of a record, its peaks last: older ones end before it or before
/// them.
void write_averaged(ByteWriter& out, const MemberResult& result);

/// What write_averaged() wrote; nothing where the bytes end. Throws RunError when they are no such thing.
void read_averaged(ByteReader& in, MemberResult& result);

/// The load map, which a result from a process of its own has behind the averaged load; journals have it packed.
void write_load_map(ByteWriter& out, const MemberResult& result);

/// What write_load_map() wrote. Throws RunError when it is no such thing.
void read_load_map(ByteReader& in, MemberResult& result);

/// The same for results without keys of quantities (journals of schema 1 and 2). Even older versions are read if the
/// result is the last thing in the bytes.
MemberResult read_older_member_result(ByteReader& in);

}  // namespace floes
