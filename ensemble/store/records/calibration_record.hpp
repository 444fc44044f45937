#pragma once
// The stored calibration of a case's Σ: the ice it applies to, the Σ found, and the curve measured for it.

#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "core/bytes.hpp"
#include "laboratory/calibration.hpp"

namespace floes {

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
