#pragma once
// The runs of a design as if each had been made at one point: their loads divided by the emulated mean maximum at
// theirs (the index method, predict_design_load.hpp).

#include <span>
#include <vector>

#include "findings/design_load.hpp"
#include "match/matching.hpp"

namespace floes {

/// A run whose load is divided by the emulated mean maximum at its point.
struct DividedRun {
    double mean_maximum;  ///< N
    bool left;            ///< whether its point is not ruled out
    double mean;          ///< load
    PeakRow row;
};

/// The rows, and the mean of their loads.
struct DividedRows {
    std::vector<PeakRow> rows;
    double mean = 0;
};

DividedRows rows_of(std::span<const DividedRun> runs);

/// How the rows of a case were measured, and its runs.
struct CaseRuns {
    Measured measured;
    std::vector<DividedRun> runs;
};

/// Those of the case of `mean_maximum`, which is emulated. `left`: for each point, whether it is not ruled out. Throws
/// InputError as averaging_time() does.
CaseRuns runs_of(std::span<const MatchWave> waves, const MatchData& data, const std::vector<bool>& left,
                 const EmulatedTarget& mean_maximum, const DesignLoadRequest& request);

}  // namespace floes
