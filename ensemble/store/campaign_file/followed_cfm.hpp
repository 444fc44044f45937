#pragma once
// Σ as a figure of a case.

#include <limits>

#include "campaign/campaign.hpp"

namespace floes {

/// Σ of joints that follow it; NaN for beams, which have none.
inline double followed_cfm(const Joint& joint) {
    return joint.model == JointModel::cfm ? joint.cfm : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace floes
