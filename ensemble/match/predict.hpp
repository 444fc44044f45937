#pragma once
// What a quantity is over the inputs that are left: the design load with the uncertainty of its inputs.

#include <string>
#include <vector>

#include "match/matching.hpp"
#include "tables/section.hpp"

namespace floes {

/// A distribution by its mean and the bounds of 95 %, in the quantity's stored unit.
struct PredictedRange {
    double mean = 0;
    double low = 0;
    double high = 0;
};

/// Of one quantity of one case, over the points that are not ruled out.
struct Predicted {
    Quantity quantity;
    std::string case_name;
    PredictedRange mean;      ///< over arrangements, every point that is left weighing the same
    PredictedRange weighted;  ///< the same, points weighed by the likelihood of the targets
    PredictedRange run;       ///< of a single run, weighed
    double effective = 0;     ///< points that the weights amount to, (Σw)² / Σw²
};

/// The weights are normal densities of the used targets' differences, taken for independent: w ~ Π exp(-I²/2) / D with
/// the implausibility I and the expected difference D of each. Emulator uncertainty and, of a single run, scatter are
/// added at each point. Throws InputError where nothing is left, or when the quantity's emulator fails its check.
Predicted predict(const Matching& found, const std::vector<EmulatedTarget>& targets, const EmulatedTarget& quantity);

/// A target without a measured value, so that match_data() gathers the quantity.
Target to_predict(const std::string& quantity, const std::string& case_name);

Section predicted_section(const std::vector<Predicted>& predicted);

}  // namespace floes
