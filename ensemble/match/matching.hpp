#pragma once
// History matching: which inputs do measured values not rule out? (I. Vernon, M. Goldstein and R. G. Bower, Bayesian
// Analysis 5 (2010) 619-670, sections 3 and 4; for a simulator with scatter I. Andrianakis et al., PLoS Computational
// Biology 11 (2015) e1003968.)
//
//   I(x)² = (z - m(x))² / (V(x) + c s(x)² / n + s(x)² / runs + u² + d²)
//
// of a target z with uncertainty u and discrepancy d: m and V are the emulated mean over arrangements and its variance,
// s² the emulated variance of single runs, and c the part of it that the points of a design have in common, since they
// begin from the same n arrangements: the emulator cannot see that all its data err together. A point is ruled out
// where I > 3 for any target: whatever the distribution, if it has one peak, 95 % of it lies within three standard
// deviations (F. Pukelsheim, The American Statistician 48 (1994) 88-91).
//
// s² is itself an estimate, of ln s² with a variance τ². Its expectation is e^(τ²/2) times the emulated one; it has the
// degrees of freedom f of a sample variance whose logarithm has that variance, ψ'(f/2) = τ² (G. K. Smyth, Statistical
// Applications in Genetics and Molecular Biology 3 (2004) 3, section 6.2); and the bound of the root above is not three
// but Student's quantile that 1 % exceed where that is more, with Satterthwaite's degrees of freedom of the whole sum.
// The implausibility is that root over its bound, times three: one number for all points and targets. No s² is taken
// to be below a tenth of that of all points: a few runs that agree by chance do not show that runs agree.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "findings/design_load.hpp"
#include "inference/emulator.hpp"
#include "match/design_data.hpp"
#include "match/waves.hpp"

namespace floes {

inline constexpr double ruled_out_above = 3;

Eigen::VectorXd coordinates_of(const MatchPoint& point);

/// A target beside its prediction at a point. Values are in the quantity's stored unit.
struct Comparison {
    double predicted = 0;  ///< emulated mean
    double expected = 0;   ///< the difference that is expected, as one standard deviation
    double ratio = 0;      ///< the difference over the expected one
    double bound = 0;      ///< of the ratio: 3, or Student's quantile where the scatter is known from few runs

    double implausibility() const { return ratio / bound * ruled_out_above; }
};

/// A target with its emulators.
class EmulatedTarget {
  public:
    explicit EmulatedTarget(const MatchData& data, const TargetData& target);

    const Target& target() const { return target_; }
    /// Whether there is any data of it; only then may the next three be asked.
    bool emulated() const { return mean_ != nullptr; }
    /// For the mean over arrangements.
    const Emulator& mean() const { return *mean_; }
    /// Variance of a single run there.
    double scatter(const Eigen::VectorXd& x) const { return scatter_at(x).variance; }
    /// Variance of the error that all points have in common.
    double common_variance(const Eigen::VectorXd& x) const { return common_part_ * scatter(x); }
    /// The difference from the target that is expected there, as one standard deviation.
    double expected_difference(const Eigen::VectorXd& x) const;
    Comparison compared(const Eigen::VectorXd& x) const;
    double implausibility(const Eigen::VectorXd& x) const { return compared(x).implausibility(); }
    /// Whether it is used and rules the point out.
    bool rules_out(const Eigen::VectorXd& x) const { return unused_.empty() && implausibility(x) > ruled_out_above; }
    /// Why it is not used: its emulator fails its check, or it is held out; empty when it is used.
    const std::string& unused() const { return unused_; }

  private:
    struct ScatterAt {
        double variance = 0;
        double freedom = 0;  ///< of an estimate from so many differences between runs
    };
    ScatterAt scatter_at(const Eigen::VectorXd& x) const;
    double difference_of(double mean_variance, double scatter) const;

    Target target_;
    std::shared_ptr<const Emulator> mean_;
    std::shared_ptr<const Emulator> log_scatter_;  ///< none where no point has two runs
    ScatterAt pooled_scatter_;
    double common_part_ = 0;  ///< c / n
    std::string unused_;
};

/// What is known of one target over the whole space.
struct TargetVerdict {
    double least = 0;          ///< implausibility anywhere
    double bound = 0;          ///< of the ratio, where the implausibility is least
    double rules_out = 0;      ///< share of the space
    double alone = 0;          ///< share that no other target rules out
    double least_of_left = 0;  ///< implausibility in what is left; NaN if nothing is
};

/// What of an axis is left, in the key's unit.
struct AxisLeft {
    double low = 0;
    double high = 0;
    double middle = 0;  ///< median
};

struct Matching {
    int sampled = 0;                      ///< points of the space that were looked at
    int left = 0;                         ///< of them, not ruled out
    std::vector<TargetVerdict> verdicts;  ///< one a target; of unused ones only `least`, `bound`
    std::vector<AxisLeft> axes;           ///< empty if nothing is left
    Eigen::MatrixXd correlations;         ///< of the axes' coordinates in what is left
    Eigen::VectorXd best;                 ///< coordinates with the smallest largest implausibility
    double best_implausibility = 0;
    std::vector<std::pair<int, int>> conflicts;  ///< targets of which no point meets both, where nothing is left
    Eigen::MatrixXd points;                      ///< coordinates of those looked at, a row each
    Eigen::VectorXd implausibility;              ///< the largest of the used targets, of each of them
    Eigen::MatrixXd points_left;                 ///< those not ruled out, a row each

    double share() const { return sampled > 0 ? static_cast<double>(left) / sampled : 0; }
};

std::vector<EmulatedTarget> emulate(const MatchData& data);

/// Looks at `samples` points, a Sobol sequence over the ranges of the first wave, shifted by `seed`.
Matching match(const MatchData& data, const std::vector<EmulatedTarget>& targets, int samples, std::uint64_t seed);

/// `count` points of what is left, spread out: the one nearest to its middle, then always the one farthest from those
/// before (and from the points simulated already). Coordinates, a row each. Fewer where fewer are left.
Eigen::MatrixXd next_points(const Matching& matching, const MatchData& data, int count);

// The runs of a design as if each had been made at one point: their loads divided by the emulated mean maximum at
// theirs (the index method, predict_design_load.hpp).

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

// The next wave: a campaign at points of what is left.

/// The campaign of `wave` at other points: `coordinates` of its axes, a row each. Numbers have six digits, so that they
/// can be read. `seed`: a new one, because on the same floes the errors of waves correlate.
Campaign next_wave(const MatchWave& wave, const std::vector<MatchAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed);

}  // namespace floes
