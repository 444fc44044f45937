#pragma once
// Distributions over all inputs that are left. For this module only.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "match/matching.hpp"
#include "tables/section.hpp"

namespace floes {

/// A distribution by its mean and the bounds of 95 %.
struct PredictedRange {
    double mean = 0;
    double low = 0;
    double high = 0;
};

/// Normal at each point that is left: one element a point, in the order of Matching::points_left.
struct AtPoints {
    std::vector<double> mean;
    std::vector<double> variance;
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
    PredictedRange even(const AtPoints& at, double least = lowest, double most = highest) const;
    /// With the weights.
    PredictedRange weighed(const AtPoints& at, double least = lowest, double most = highest) const;
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
    PredictedRange mean;      ///< over arrangements, with equal weights
    PredictedRange weighted;  ///< the same, points weighed by the likelihood of the targets
    PredictedRange run;       ///< of a single run, weighed
    double effective = 0;     ///< OverLeft::effective()
    std::string unknown;      ///< why it is not known, a sentence; then there are no ranges
};

/// Emulator uncertainty and, of a single run, scatter are added at each point. Throws as unpredictable() does.
Predicted predict(const OverLeft& left, const EmulatedTarget& quantity);

/// A target without a measured value, so that match_data() gathers the quantity.
Target to_predict(const std::string& quantity, const std::string& case_name);

/// As one cell of a table.
Estimate estimate(const PredictedRange& range);

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
    std::size_t runs = 0;              ///< behind the growth
    bool only_left = true;             ///< whether they are those at points that are left; else all
    DesignLoadFigure growth_expected;  ///< expected largest load over the mean maximum
    DesignLoadFigure growth_quantile;  ///< the quantile over it; both of both tails
    double growth_lower_half = 0;      ///< of the quantile, from the runs with the smaller mean maxima; NaN: too few
    double growth_upper_half = 0;      ///< from the others
    PredictedRange expected;           ///< with equal weights
    PredictedRange expected_weighed;   ///< with the likelihood of the targets as weights
    PredictedRange quantile;           ///< that the largest load stays below with the probability asked for
    PredictedRange quantile_weighed;
    std::string unknown;  ///< why it is not known, a sentence; then there are no figures

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
