#include "records/member_record.hpp"

#include <array>
#include <utility>

#include "core/error.hpp"
#include "member/result_bytes.hpp"

namespace floes {
namespace {

void write(ByteWriter& out, const PackedNumbers& numbers) {
    out.u64(numbers.count);
    out.blob(numbers.chunk);
}

PackedNumbers read_numbers(ByteReader& in) {
    const std::uint64_t count = in.u64();
    return {count, in.blob()};
}

/// In the order in which they stand at the end of a record; older ones end before them.
auto parts_of(auto& map) {
    return std::array{&map.surge, &map.normal, &map.along_tow};
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

void read_history(ByteReader& in, MemberRecord& record) {
    record.history.surge = read_numbers(in);
    record.history.sway = read_numbers(in);
    record.history.heave = read_numbers(in);
    read_averaged(in, record.result);
    if (in.left() > 0) {
        for (PackedNumbers* part : parts_of(record.history.map)) *part = read_numbers(in);
    }
    if (in.left() != 0) throw RunError("a stored member is longer than expected; it was written by another version");
}

}  // namespace

MemberIdentity identity(const MemberRecord& record) {
    return {record.case_key, record.arrangement};
}

Bytes encode(const MemberRecord& record) {
    ByteWriter out;
    out.text(record.case_key);
    out.i32(record.arrangement);
    out.i32(record.attempt);
    out.i32(record.rank);
    out.text(record.host);
    out.u64(record.peak_memory);
    write(out, record.result);
    write(out, record.history.surge);
    write(out, record.history.sway);
    write(out, record.history.heave);
    write_averaged(out, record.result);
    if (!record.history.map.empty()) {
        for (const PackedNumbers* part : parts_of(record.history.map)) write(out, *part);
    }
    return out.take();
}

MemberRecord decode_member_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    MemberRecord record = read_head(in);
    record.result = read_member_result(in);
    read_history(in, record);
    return record;
}

MemberRecord decode_older_member_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    MemberRecord record = read_head(in);
    record.result = read_older_member_result(in);
    if (in.left() == 0) {
        record.history = pack(std::exchange(record.result.history, {}));
    } else {
        read_history(in, record);
    }
    return record;
}

}  // namespace floes
