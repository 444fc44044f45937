#pragma once
// What gave a case its Σ, as it is kept: the ice it holds for, the Σ found, and the curve measured on the way.

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

/// 32 hex digits: equal exactly when two scenarios' ice and wanted elastic modulus are the same, so that one
/// calibration does for both. Their Σ does not matter.
std::string calibration_key(const Scenario& scenario);

/// The record of that key; nullptr where there is none.
const CalibrationRecord* find_calibration(std::span<const CalibrationRecord> records, const std::string& key);

/// For each case of the campaign the calibration that gave it its Σ; nullptr where it was stated otherwise.
std::vector<const Calibration*> match_calibrations(const Campaign& campaign,
                                                   std::span<const CalibrationRecord> records);

/// The bytes of a record, the same on every machine.
Bytes encode(const CalibrationRecord& record);

/// The record that encode() was given, bit for bit. Throws RunError when the bytes are not exactly one record.
CalibrationRecord decode_calibration_record(std::span<const std::byte> bytes);

}  // namespace floes
