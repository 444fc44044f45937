#pragma once
// Keeps E and Σ of joints that follow Σ together: measures the E of a stated Σ, and whether a stated pair agrees.

#include <span>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/progress.hpp"
#include "run/recorder.hpp"
#include "simulation/laboratory.hpp"
#include "store/member_record.hpp"

namespace floes {

/// Gives cases of Pairing::find_modulus the E that a plate test shows, to three figures, and compares it with the E of
/// cases of Pairing::check; both are settled then. One test, of a second or so, for each distinct ice, `threads` at a
/// time. Deterministic. Throws InputError naming the case if E and Σ differ by more than 5 %, or if the E of a stated Σ
/// cannot be measured.
void settle_moduli(Campaign& campaign, int threads, Progress& progress);

// Plate tests side by side on the cores of this machine.

/// The point of each plan, in their order. Throws as measure_curve_point() does.
std::vector<CurvePoint> measure_curve(const std::vector<PointPlan>& plans);

// Finds the Σ of cases that state an elastic modulus instead, before the first member is handed out.

/// The calibrations in the journal that a run resumes; empty for a new campaign.
std::vector<CalibrationRecord> kept_calibrations(const Recorder::Places& places);

/// Gives every case to be calibrated the Σ that yields its modulus, on the largest sheet that its elements divide up
/// to that of plate_test_for(), 5.4 m for the paper's ice: from `kept` if that has it, otherwise by plate tests, one
/// for each distinct ice and `threads` at a time. Returns the calibrations in use. Deterministic. Throws InputError
/// naming the case if its modulus cannot be reached.
std::vector<CalibrationRecord> calibrate_campaign(Campaign& campaign, std::span<const CalibrationRecord> kept,
                                                  int threads, Progress& progress);

}  // namespace floes
