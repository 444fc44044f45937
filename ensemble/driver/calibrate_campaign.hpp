#pragma once
// Finds the Σ of cases that give an elastic modulus in its place, before the first member is handed out.

#include <span>
#include <vector>

#include "campaign/campaign.hpp"
#include "driver/progress.hpp"
#include "driver/recorder.hpp"
#include "records/calibration_record.hpp"

namespace floes {

/// What the journal that a run goes on with has of calibrations; empty when it begins anew.
std::vector<CalibrationRecord> kept_calibrations(const Recorder::Places& places);

/// Gives every case to be calibrated the Σ that shows its modulus, on the largest sheet up to 5.4 m that its elements
/// divide: from `kept` where that has it, else by plate tests, each distinct ice once and `threads` of them at a time.
/// Returns what the cases use. Deterministic. Throws InputError naming the case when its modulus cannot be had.
std::vector<CalibrationRecord> calibrate_campaign(Campaign& campaign, std::span<const CalibrationRecord> kept,
                                                  int threads, Progress& progress);

}  // namespace floes
