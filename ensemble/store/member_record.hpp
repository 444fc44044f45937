#pragma once
// A finished member as stored: its identity, its provenance, and the result to the last bit.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/bytes.hpp"
#include "member/result.hpp"
#include "simulation/plate_tests.hpp"
#include "store/packed_arrays.hpp"
#include "store/session.hpp"

namespace floes {

/// Identity is (case_key, arrangement), not the member number, so that a record stays valid when its campaign grows.
/// Everything except identity and result is provenance.
struct MemberRecord {
    std::string case_key;  ///< case_fingerprint() of the member's case
    int arrangement = 0;   ///< arrangement number, from 0
    int attempt = 1;       ///< from 1
    int rank = 0;          ///< of the computing process
    std::string host;
    std::uint64_t peak_memory = 0;  ///< largest resident set of the computing process so far, bytes
    MemberResult result;            ///< of a record that was stored, without its arrays: these are in
    PackedArrays arrays;            ///< or still in the result, unpacked

    /// The array of that number in array_outputs, wherever it is.
    PackedArray array(std::size_t number) const;
    /// The result with its arrays: all, or those that are read with the quantities.
    enum class Arrays { all, in_table };
    MemberResult whole(Arrays which = Arrays::all) const;
};

MemberIdentity identity(const MemberRecord& record);

/// The bytes of a record, the same on every machine.
Bytes encode(const MemberRecord& record);

/// Restores the record bit for bit, its arrays packed. Throws RunError if the bytes are not exactly one record.
MemberRecord decode_member_record(std::span<const std::byte> bytes);

// The stored calibration of a case's Σ: the ice it applies to, the Σ found, and the curve measured for it.

struct CalibrationRecord {
    std::string key;  ///< calibration_key() of the ice
    Calibration found;
};

/// 32 hex digits, equal exactly if ice and requested elastic modulus of two scenarios are the same, so that they can
/// share a calibration. Σ is not part of it.
std::string calibration_key(const Scenario& scenario);

/// The record of that key; nullptr if there is none.
const CalibrationRecord* find_calibration(std::span<const CalibrationRecord> records, const std::string& key);

/// For each case of the campaign the calibration of its Σ; nullptr if Σ was not calibrated.
std::vector<const Calibration*> match_calibrations(const Campaign& campaign,
                                                   std::span<const CalibrationRecord> records);

/// The bytes of a record, the same on every machine.
Bytes encode(const CalibrationRecord& record);

/// Restores the record bit for bit. Throws RunError if the bytes are not exactly one record.
CalibrationRecord decode_calibration_record(std::span<const std::byte> bytes);

}  // namespace floes
