#include "records/record_head.hpp"

namespace floes {

void write_head(ByteWriter& out, const MemberRecord& record) {
    out.text(record.case_key);
    out.i32(record.arrangement);
    out.i32(record.attempt);
    out.i32(record.rank);
    out.text(record.host);
    out.u64(record.peak_memory);
}

MemberRecord read_head(ByteReader& in) {
    MemberRecord record;
    record.case_key = in.text();
    record.arrangement = in.i32();
    record.attempt = in.i32();
    record.rank = in.i32();
    record.host = in.text();
    record.peak_memory = in.u64();
    return record;
}

}  // namespace floes
