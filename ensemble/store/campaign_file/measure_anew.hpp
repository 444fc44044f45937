#pragma once
// The loads of a campaign file in other windows than those it was run with.

#include <span>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "campaign_file/read_history.hpp"

namespace floes {

/// The part of a history that lies in the window, which ends the run.
std::span<const double> in_window(const SurgeHistory& history, const Analysis& analysis);

/// The table of the file with every done member's surge load, and the steps that it counted above levels,
/// measured anew in the window of its case: `windows`, one a case, each ending the run. Nothing else changes. Throws
/// InputError for histories that are thinned, since maxima and deviations need every step.
CampaignTable measured_anew(const CampaignFile& file, CampaignTable table, const std::vector<Analysis>& windows);

}  // namespace floes
