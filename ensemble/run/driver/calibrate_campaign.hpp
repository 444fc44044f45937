#pragma once
// Finds the Σ of cases that state an elastic modulus instead, before the first member is handed out.

#include <span>
#include <vector>

#include "campaign/campaign.hpp"
#include "driver/progress.hpp"
#include "driver/recorder.hpp"
#include "records/calibration_record.hpp"

namespace floes {

/// The calibrations in the journal that a run resumes; empty for a new campaign.
std::vector<CalibrationRecord> kept_calibrations(const Recorder::Places& places);

/// Gives every case to be calibrated the Σ that yields its modulus, on the largest sheet that its elements divide up
/// to that of plate_test_for(), 5.4 m for the paper's ice: from `kept` if that has it, otherwise by plate tests, one
/// for each distinct ice and `threads` at a time. Returns the calibrations in use. Deterministic. Throws InputError
/// naming the case if its modulus cannot be reached.
std::vector<CalibrationRecord> calibrate_campaign(Campaign& campaign, std::span<const CalibrationRecord> kept,
                                                  int threads, Progress& progress);

}  // namespace floes
