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
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "findings/design_load.hpp"
#include "inference/emulator.hpp"
#include "match/waves.hpp"
#include "tables/figure.hpp"
#include "tables/section.hpp"

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
    /// Whether there is any data of it; only then may the next six be asked.
    bool emulated() const { return mean_ != nullptr; }
    /// For the mean over arrangements.
    const Emulator& mean() const { return *mean_; }
    /// Variance of a single run there.
    double scatter(const Eigen::VectorXd& x) const { return scatter_at(x).variance; }
    /// Variance of the error that all points have in common.
    double common_variance(const Eigen::VectorXd& x) const { return common_part_ * scatter(x); }
    Comparison compared(const Eigen::VectorXd& x) const;
    double implausibility(const Eigen::VectorXd& x) const { return compared(x).implausibility(); }
    /// Whether it is used and rules the point out.
    bool rules_out(const Eigen::VectorXd& x) const { return unused_.empty() && implausibility(x) > ruled_out_above; }
    /// What its emulators leave out, a sentence each: that the mean's is simpler than a Gaussian process, or that the
    /// scatter is taken as the same everywhere.
    std::vector<std::string> simplifications() const;
    /// Why it is not used: its emulator fails its check, or it is held out; empty when it is used.
    const std::string& unused() const { return unused_; }

  private:
    struct ScatterAt {
        double variance = 0;
        double freedom = 0;  ///< of an estimate from so many differences between runs
    };
    ScatterAt scatter_at(const Eigen::VectorXd& x) const;

    Target target_;
    std::shared_ptr<const Emulator> mean_;
    std::string no_scatter_;                       ///< why log_scatter_ is none
    std::shared_ptr<const Emulator> log_scatter_;  ///< none where it cannot be emulated
    ScatterAt pooled_scatter_;
    double common_part_ = 0;  ///< c / n
    std::string unused_;
};

/// What is known of one target over the whole space.
struct TargetVerdict {
    double least = 0;      ///< implausibility anywhere
    double bound = 0;      ///< of the ratio, where the implausibility is least
    double rules_out = 0;  ///< share of the space
    double alone = 0;      ///< share that no other target rules out
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
// theirs (the index method, below).

/// A run whose load is divided by the emulated mean maximum at its point.
struct DividedRun {
    std::size_t member;   ///< of its wave's table
    double mean_maximum;  ///< N
    bool left;            ///< whether its point is not ruled out
    double mean;          ///< load
    PeakRow row;
};

/// Rows, and how they were measured, with the mean of their loads.
struct DividedRows {
    std::vector<PeakRow> rows;
    Measured measured;
};

DividedRows rows_of(std::span<const DividedRun> runs, Measured measured);

/// How the rows of a case were measured, without their mean, and its runs.
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
Campaign next_wave(const MatchWave& wave, const std::vector<RangedAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed);

// What a matching found, as tables for people and records for programs, and as figures.

/// The largest implausibility over the only input.
Figure along_figure(const MatchData& data, const Matching& found);

/// The verdict in sentences, the targets, the inputs before and after, and of several inputs the correlations in
/// what is left.
std::vector<Section> match_sections(const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                    const Matching& found);

/// The left-out points of each emulator, and why one is not used; in figures, for a page.
Section check_section(const std::vector<EmulatedTarget>& targets);

/// What the emulators predict at one point, and whether a target rules it out.
Section point_section(const MatchData& data, const std::vector<EmulatedTarget>& targets, const Eigen::VectorXd& at);

// Distributions over all inputs that are left, each as an Estimate: its mean and the bounds of 95 %.

/// Normal at each point that is left: one element a point, in the order of Matching::points_left. With another variance
/// above the median than below it, of two halves.
struct AtPoints {
    std::vector<double> mean;
    std::vector<double> variance;
    std::vector<double> variance_above = {};  ///< empty: the same
};

/// The points that are left, with weights: the likelihood of the used targets, normal and independent,
/// w ~ Π exp(-I²/2) / D with the implausibility I and the expected difference D of each target.
class OverLeft {
  public:
    /// Throws InputError where nothing is left.
    OverLeft(const Matching& found, const std::vector<EmulatedTarget>& targets);

    /// The emulated mean over arrangements, with the emulator's uncertainty and the error that all points share. Only
    /// where unpredictable() gives nothing.
    AtPoints emulated(const EmulatedTarget& quantity) const;
    const Eigen::MatrixXd& points() const { return points_; }

    /// With equal weights; the bounds stay within least and most.
    Estimate even(const AtPoints& at, double least = lowest, double most = highest) const;
    /// With the weights.
    Estimate weighed(const AtPoints& at, double least = lowest, double most = highest) const;
    /// The effective number of points, (Σw)² / Σw².
    double effective() const;

  private:
    static constexpr double lowest = -std::numeric_limits<double>::infinity();
    static constexpr double highest = std::numeric_limits<double>::infinity();

    Eigen::MatrixXd points_;
    std::vector<double> weights_;  ///< sum 1
};

// A quantity over the inputs that are left.

/// Why the quantity cannot be predicted, a sentence: its emulator fails its check; empty where it can. Throws
/// InputError where no wave has it.
std::string unpredictable(const EmulatedTarget& quantity);

/// For one quantity of one case, over the points that are not ruled out, in the quantity's stored unit.
struct Predicted {
    Quantity quantity;
    std::string case_name;
    Estimate mean;                   ///< over arrangements, with equal weights
    Estimate weighted;               ///< the same, points weighed by the likelihood of the targets
    Estimate run;                    ///< of a single run, weighed
    double effective = 0;            ///< OverLeft::effective()
    std::string unknown;             ///< why it is not known, a sentence; then there are no ranges
    std::vector<std::string> notes;  ///< EmulatedTarget::simplifications()
};

/// Emulator uncertainty and, of a single run, scatter are added at each point. Throws as unpredictable() does.
Predicted predict(const OverLeft& left, const EmulatedTarget& quantity);

/// A target without a measured value, so that match_data() gathers the quantity.
Target to_predict(const std::string& quantity, const std::string& case_name);

Section predicted_section(const std::vector<Predicted>& predicted);

// The design load with the uncertainty of its inputs: the largest averaged load in an exposure, over the inputs that
// are left.
//
// A point of a design has a few runs, too few for a tail of its own. So, as in regional frequency analysis (the index
// method; J. R. M. Hosking and J. R. Wallis, Regional Frequency Analysis, Cambridge 1997), the load of every run is
// divided by the emulated mean maximum at its point, and one tail is fitted to all of them. It gives the growth from
// the mean maximum to the largest load in the exposure; the emulated mean maximum times the growth is the design load
// at any inputs. This assumes the same growth at all inputs; to check it, the growth is also computed for the lower and
// the upper half of the mean maxima.

/// For one case. Loads are in N, at the scale that was asked for.
struct PredictedDesignLoad {
    std::string case_name;
    std::size_t runs = 0;          ///< behind the growth
    bool only_left = true;         ///< whether they are those at points that are left; else all
    LoadFigure growth_expected;    ///< expected largest load over the mean maximum
    LoadFigure growth_quantile;    ///< the quantile over it; both of both tails
    double growth_lower_half = 0;  ///< of the quantile, from the runs with the smaller mean maxima; NaN: too few
    double growth_upper_half = 0;  ///< from the others
    Estimate expected;             ///< with equal weights
    Estimate expected_weighed;     ///< with the likelihood of the targets as weights
    Estimate quantile;             ///< that the largest load stays below with the probability asked for
    Estimate quantile_weighed;
    std::string unknown;             ///< why it is not known, a sentence; then there are no figures
    std::vector<std::string> notes;  ///< EmulatedTarget::simplifications() of the mean maximum

    bool known() const { return unknown.empty(); }
};

/// Fewest runs at points that are left from which the growth is taken; with fewer, from all points.
inline constexpr std::size_t fewest_growth_runs = 20;

/// One for each case with runs, of the first quantile asked for; not known where a case has too few peaks to fit or its
/// mean maximum is unpredictable(). Throws InputError as averaging_time() does.
std::vector<PredictedDesignLoad> predict_design_load(std::span<const MatchWave> waves, const MatchData& data,
                                                     const std::vector<EmulatedTarget>& targets, const OverLeft& left,
                                                     const DesignLoadRequest& request);

Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request);

}  // namespace floes
