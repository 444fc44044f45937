#include "store/member_record.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "member/array_output.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr auto head = std::tuple(&MemberRecord::case_key, &MemberRecord::arrangement, &MemberRecord::attempt,
                                 &MemberRecord::rank, &MemberRecord::host, &MemberRecord::peak_memory);

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

/// Calls `use` with the number of each record and of each member that it is a record of. Cases of equal physics share
/// their records.
template <class Use>
void for_each_match(const Campaign& campaign, const MemberNotes& notes, const Use& use) {
    std::vector<std::vector<std::size_t>> cases_of_key(notes.keys().size());
    for (std::size_t k = 0; const std::string& fingerprint : case_fingerprints(campaign)) {
        const auto key = notes.keys().find(fingerprint);
        if (key != notes.keys().end()) cases_of_key[static_cast<std::size_t>(key->second)].push_back(k);
        ++k;
    }
    for (std::size_t record = 0; record < notes.size(); ++record) {
        const MemberNote& note = notes[record];
        if (note.arrangement < 0 || note.arrangement >= campaign.arrangements) continue;
        const std::size_t first = static_cast<std::size_t>(note.arrangement) * campaign.cases.size();
        for (const std::size_t of_case : cases_of_key[static_cast<std::size_t>(note.key)]) use(record, first + of_case);
    }
}

/// How far the record's arrays go along the axes of which it alone knows that.
std::array<int, found_axes.size()> found_in(const MemberRecord& record) {
    std::array<int, found_axes.size()> found{};
    for (std::size_t number = 0; number < array_outputs.size(); ++number) {
        const auto& axes = array_outputs[number].axes;
        for (std::size_t k = 0; k < axes.size() && axes[k] != nullptr; ++k) {
            const auto at = std::ranges::find(found_axes, axes[k]);
            if (at == found_axes.end()) continue;
            const PackedArray array = record.array(number);
            if (!array.empty())
                found[static_cast<std::size_t>(at - found_axes.begin())] = static_cast<int>(array.sizes[k]);
        }
    }
    return found;
}

MemberNotes notes_of(std::span<const MemberRecord> records) {
    MemberNotes notes;
    for (const MemberRecord& record : records) notes.add(record);
    return notes;
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
    put(out, record, head);
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
    MemberRecord record;
    take(in, record, head);
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

constexpr auto fields_of(std::type_identity<CurvePoint>) {
    return std::tuple(&CurvePoint::sheet, &CurvePoint::element, &CurvePoint::thickness, &CurvePoint::time_step,
                      &CurvePoint::erp, &CurvePoint::iterations, &CurvePoint::cfm, &CurvePoint::slope,
                      &CurvePoint::elastic_modulus, &CurvePoint::elastic_modulus_point);
}
constexpr auto fields_of(std::type_identity<Calibration>) {
    return std::tuple(&Calibration::cfm, &Calibration::ceiling, &Calibration::curve);
}
constexpr auto fields_of(std::type_identity<CalibrationRecord>) {
    return std::tuple(&CalibrationRecord::key, &CalibrationRecord::found);
}

Bytes encode(const CalibrationRecord& record) {
    ByteWriter out;
    put(out, record);
    return out.take();
}

CalibrationRecord decode_calibration_record(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    CalibrationRecord record;
    take(in, record);
    if (in.left() != 0)
        throw RunError("a stored calibration is longer than expected; it was written by another version");
    return record;
}

int found_along(const MemberNote& note, const ArrayAxis& axis) {
    return note.found.at(static_cast<std::size_t>(std::ranges::find(found_axes, &axis) - found_axes.begin()));
}

void MemberNotes::add(const MemberRecord& record) {
    add(record.case_key, {.wall_time = record.result.wall_time,
                          .arrangement = record.arrangement,
                          .attempt = record.attempt,
                          .found = found_in(record),
                          .status = record.result.status});
}

void MemberNotes::add(const std::string& key, MemberNote note) {
    note.key = keys_.try_emplace(key, static_cast<int>(keys_.size())).first->second;
    notes_.push_back(note);
}

void MemberNotes::add(const MemberNotes& others) {
    std::vector<int> key_here(others.keys().size());
    for (const auto& [key, there] : others.keys())
        key_here[static_cast<std::size_t>(there)] =
            keys_.try_emplace(key, static_cast<int>(keys_.size())).first->second;
    for (MemberNote note : others.notes_) {
        note.key = key_here[static_cast<std::size_t>(note.key)];
        notes_.push_back(note);
    }
}

StoredMembers::StoredMembers(const MemberNotes& notes, Read read) : notes_(notes), read_(std::move(read)) {}

StoredMembers::StoredMembers(std::span<const MemberRecord> records)
    : own_(notes_of(records)), notes_(own_), read_([records](std::size_t k) { return records[k]; }) {}

std::vector<std::optional<std::size_t>> match_records(const Campaign& campaign, const MemberNotes& notes) {
    std::vector<std::optional<std::size_t>> matched(static_cast<std::size_t>(member_count(campaign)));
    for_each_match(campaign, notes, [&](std::size_t record, std::size_t member) {
        std::optional<std::size_t>& known = matched[member];
        if (!known || !notes[*known].done()) known = record;
    });
    return matched;
}

std::vector<int> last_attempts(const Campaign& campaign, const MemberNotes& notes) {
    std::vector<int> attempts(static_cast<std::size_t>(member_count(campaign)), 0);
    for_each_match(campaign, notes, [&](std::size_t record, std::size_t member) {
        attempts[member] = std::max(attempts[member], notes[record].attempt);
    });
    return attempts;
}

}  // namespace floes
