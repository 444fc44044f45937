#pragma once
// A member's result as bytes, exact and the same on every machine: for journals, and for messages between ranks and
// from isolated processes. Quantities and arrays go by their lists, each with its key, so that a reader of another
// version knows what it has.

#include "core/bytes.hpp"
#include "member/array_output.hpp"
#include "member/result.hpp"

namespace floes {

/// All but the arrays.
void write(ByteWriter& out, const MemberResult& result);

/// Restores what write() wrote, bit for bit. Quantities that are not in the bytes are NaN. Throws RunError if the bytes
/// are not a result.
MemberResult read_member_result(ByteReader& in);

/// How a result begins in every version: status, reason, quantities, and whether the load was steady.
MemberResult read_outcome(ByteReader& in);

/// The arrays that the member has, as they are.
void write_arrays(ByteWriter& out, const MemberResult& result);

/// What write_arrays() wrote. Throws RunError if the bytes are no arrays.
void read_arrays(ByteReader& in, MemberResult& result);

/// Whether the array may have these sizes: one for each axis, those of fixed axes as they are, and as many values as
/// they multiply to. Throws RunError otherwise.
void check_sizes(const ArrayOutput& array, std::span<const std::size_t> sizes, std::uint64_t values);

}  // namespace floes
