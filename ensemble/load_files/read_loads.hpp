#pragma once
// The load of a member, from its campaign file.

#include <optional>

#include "campaign_file/campaign_table.hpp"
#include "campaign_file/read.hpp"
#include "load_files/load_file.hpp"

namespace floes {

/// What of the stored load is wanted; times and lengths at the scale of the file that is written.
struct LoadRequest {
    LoadAxes axes = LoadAxes::earth;
    double tow_towards = 0;  ///< degrees from X towards Y
    double scale = 1;
    std::optional<double> from = {};  ///< s; the start
    std::optional<double> to = {};    ///< s; the end
    std::optional<double> step = {};  ///< s; as stored
};

/// Throws InputError for a member that there is not or that is not done, without stored histories, for a step shorter
/// than theirs, and for times outside the run.
LoadToWrite read_load(const CampaignFile& file, const CampaignTable& table, int member, const LoadRequest& request);

}  // namespace floes
