#pragma once
// A member's result as bytes, to the last bit and the same on every machine: what journals keep, and what goes between
// ranks and between a member's own process and the one that waits for it.

#include "core/bytes.hpp"
#include "member/result.hpp"

namespace floes {

void write(ByteWriter& out, const MemberResult& result);

/// What write() wrote, bit for bit; the result is the last thing in the bytes. Throws RunError when they are no result.
MemberResult read_member_result(ByteReader& in);

}  // namespace floes
