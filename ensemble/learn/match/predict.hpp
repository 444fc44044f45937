#pragma once
// A quantity over the inputs that are left.

#include <string>
#include <vector>

#include "match/over_left.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of one quantity of one case, over the points that are not ruled out, in the quantity's stored unit.
struct Predicted {
    Quantity quantity;
    std::string case_name;
    PredictedRange mean;      ///< over arrangements, with equal weights
    PredictedRange weighted;  ///< the same, points weighed by the likelihood of the targets
    PredictedRange run;       ///< of a single run, weighed
    double effective = 0;     ///< OverLeft::effective()
};

/// Emulator uncertainty and, of a single run, scatter are added at each point. Throws as OverLeft::emulated() does.
Predicted predict(const OverLeft& left, const EmulatedTarget& quantity);

/// A target without a measured value, so that match_data() gathers the quantity.
Target to_predict(const std::string& quantity, const std::string& case_name);

/// The mean with the bounds of 95 % in brackets, times the factor.
Cell range_cell(const PredictedRange& range, double factor);

Section predicted_section(const std::vector<Predicted>& predicted);

}  // namespace floes
