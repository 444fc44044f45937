#include "records/member_record.hpp"

#include "core/error.hpp"
#include "member/result_bytes.hpp"
#include "records/record_head.hpp"

namespace floes {
namespace {

void write(ByteWriter& out, const PackedArray& array) {
    out.u8(static_cast<std::uint8_t>(array.sizes.size()));
    for (const std::size_t size : array.sizes) out.u64(size);
    out.u64(array.numbers.count);
    out.blob(array.numbers.chunk);
}

PackedArray read_array(ByteReader& in) {
    PackedArray array;
    array.sizes.resize(in.u8());
    for (std::size_t& size : array.sizes) size = in.u64();
    array.numbers.count = in.u64();
    array.numbers.chunk = in.blob();
    return array;
}

}  // namespace

PackedArray MemberRecord::array(std::size_t number) const {
    return arrays[number].empty() ? pack(array_outputs[number].access.get(result)) : arrays[number];
}

MemberResult MemberRecord::whole(Arrays which) const {
    MemberResult all = result;
    for (std::size_t k = 0; k < array_outputs.size(); ++k) {
        const ArrayOutput& one = array_outputs[k];
        if (arrays[k].empty() || (which == Arrays::in_table && one.in_file() && !one.in_table)) continue;
        one.access.set(all, unpack(arrays[k]));
    }
    return all;
}

MemberIdentity identity(const MemberRecord& record) {
    return {record.case_key, record.arrangement};
}

Bytes encode(const MemberRecord& record) {
    ByteWriter out;
    write_head(out, record);
    write(out, record.result);
    ByteWriter arrays;
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < array_outputs.size(); ++k) {
        const PackedArray array = record.array(k);
        if (array.empty()) continue;
        arrays.text(array_outputs[k].path);
        write(arrays, array);
        ++count;
    }
    out.u32(count);
    Bytes bytes = out.take();
    bytes.insert(bytes.end(), arrays.bytes().begin(), arrays.bytes().end());
    return bytes;
}

MemberRecord decode_member_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    MemberRecord record = read_head(in);
    record.result = read_member_result(in);
    for (std::uint32_t left = in.u32(); left > 0; --left) {
        const std::size_t number = array_number(in.text());
        PackedArray array = read_array(in);
        if (number == array_outputs.size()) continue;  // of a newer version
        check_sizes(array_outputs[number], array.sizes, array.numbers.count);
        record.arrays[number] = std::move(array);
    }
    if (in.left() != 0) throw RunError("a stored member is longer than expected; it was written by another version");
    return record;
}

}  // namespace floes
