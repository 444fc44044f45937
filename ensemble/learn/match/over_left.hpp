#pragma once
// Distributions over all inputs that are left. For this room only.

#include <limits>
#include <vector>

#include "match/matching.hpp"

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

    /// The emulated mean over arrangements, with the emulator's uncertainty and the error that all points share. Throws
    /// InputError where no wave has the quantity, or its emulator fails its check.
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

}  // namespace floes
