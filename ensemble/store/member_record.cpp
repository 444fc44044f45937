#include "store/member_record.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "member/array_output.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

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
    FLOES_EXPECTS(number < arrays.size());
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

std::string calibration_key(const Scenario& scenario) {
    return digest_hex(canonical_text(plate_scenario(scenario)));
}

const CalibrationRecord* find_calibration(std::span<const CalibrationRecord> records, const std::string& key) {
    const auto found = std::ranges::find(records, key, &CalibrationRecord::key);
    return found == records.end() ? nullptr : &*found;
}

std::vector<const Calibration*> match_calibrations(const Campaign& campaign,
                                                   std::span<const CalibrationRecord> records) {
    std::vector<const Calibration*> matched;
    for (const Case& one : campaign.cases) {
        const CalibrationRecord* record = find_calibration(records, calibration_key(one.scenario));
        const bool gave_cfm = record != nullptr && record->found.cfm == one.scenario.joint.cfm;
        matched.push_back(gave_cfm ? &record->found : nullptr);
    }
    return matched;
}

Bytes encode(const CalibrationRecord& record) {
    ByteWriter out;
    out.text(record.key);
    out.f64(record.found.cfm);
    out.f64(record.found.ceiling);
    out.u64(record.found.curve.size());
    for (const CurvePoint& point : record.found.curve) {
        for (const double value : {point.sheet, point.element, point.thickness, point.time_step, point.erp})
            out.f64(value);
        out.i32(point.iterations);
        for (const double value : {point.cfm, point.slope, point.elastic_modulus, point.elastic_modulus_point})
            out.f64(value);
    }
    return out.take();
}

CalibrationRecord decode_calibration_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    CalibrationRecord record;
    record.key = in.text();
    record.found.cfm = in.f64();
    record.found.ceiling = in.f64();
    record.found.curve.resize(in.count(9 * 8 + 4));  // nine doubles and a count
    for (CurvePoint& point : record.found.curve) {
        for (double* value : {&point.sheet, &point.element, &point.thickness, &point.time_step, &point.erp})
            *value = in.f64();
        point.iterations = in.i32();
        for (double* value : {&point.cfm, &point.slope, &point.elastic_modulus, &point.elastic_modulus_point})
            *value = in.f64();
    }
    if (in.left() != 0)
        throw RunError("a stored calibration is longer than expected; it was written by another version");
    return record;
}

}  // namespace floes
