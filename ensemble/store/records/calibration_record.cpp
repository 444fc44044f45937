#include "records/calibration_record.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "scenario/keys.hpp"

namespace floes {

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
