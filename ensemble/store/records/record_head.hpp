#pragma once
// How every record of a member begins, whatever its version. For this room only.

#include "records/member_record.hpp"

namespace floes {

void write_head(ByteWriter& out, const MemberRecord& record);
MemberRecord read_head(ByteReader& in);

}  // namespace floes
