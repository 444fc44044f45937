#pragma once
// Whether loads rise or fall through the measured window: the test of inference/joint_trend.hpp on a campaign's
// members.

#include <vector>

#include "findings/summary.hpp"
#include "inference/joint_trend.hpp"

namespace floes {

/// Of each case, in their order.
std::vector<JointTrend> joint_trends(const CampaignTable& table);

}  // namespace floes
