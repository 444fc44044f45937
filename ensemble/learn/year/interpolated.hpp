#pragma once
// A design between its points: the emulated mean maximum at any place, and the runs of all points divided by it
// (match/predict_design_load.hpp). For this room only.

#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "match/divided_runs.hpp"
#include "year/regimes.hpp"

namespace floes {

/// The [[case]] of the design that the regime means; "" where it has none. Throws InputError where the campaign has no
/// design, or several cases of which the regime names none.
std::string design_case(const MatchWave& campaign, const Regime& regime);

class InterpolatedDesign {
  public:
    /// Throws InputError as match_data() and averaging_time() do, and where the emulator fails its check.
    InterpolatedDesign(const MatchWave& campaign, const std::string& base, const DesignLoadRequest& request);

    const std::vector<PeakRow>& rows() const { return rows_; }  ///< divided by the mean maximum at their points
    const Measured& measured() const { return measured_; }
    const std::vector<int>& members() const { return members_; }
    std::size_t fewest_arrangements() const { return fewest_; }  ///< of a point

    /// The mean maximum there, N, with the variance of the emulator and of what all points share. Throws InputError for
    /// an axis without a value, a value of no axis, and one outside of the axis's range.
    Emulated at(const Regime& regime) const;

  private:
    MatchData data_;
    std::vector<EmulatedTarget> index_;  ///< one
    std::vector<PeakRow> rows_;
    Measured measured_;
    std::vector<int> members_;
    std::size_t fewest_ = 0;
};

}  // namespace floes
