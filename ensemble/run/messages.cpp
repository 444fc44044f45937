#include "run/messages.hpp"

namespace floes {

void put_value(ByteWriter& out, MemberStatus status) {
    put(out, status == MemberStatus::done);
}

void take_value(ByteReader& in, MemberStatus& status) {
    bool done = true;
    take(in, done);
    status = done ? MemberStatus::done : MemberStatus::failed;
}

void put_value(ByteWriter& out, const MemberRecord& record) {
    out.blob(encode(record));
}

void take_value(ByteReader& in, MemberRecord& record) {
    record = decode_member_record(in.blob());
}

void put_value(ByteWriter& out, const std::optional<MemberRecord>& record) {
    out.blob(record ? encode(*record) : Bytes{});
}

void take_value(ByteReader& in, std::optional<MemberRecord>& record) {
    if (const Bytes bytes = in.blob(); !bytes.empty()) record = decode_member_record(bytes);
}

}  // namespace floes
