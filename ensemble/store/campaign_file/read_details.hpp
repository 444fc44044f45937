#pragma once
// What a report wants of a campaign file beside its table: the configuration, who made it, one arrangement, the breaks.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/campaign_file.hpp"
#include "core/vector.hpp"

namespace floes {

/// How the file came about, as /provenance has it.
struct CampaignOrigin {
    std::string configuration;                               ///< resolved TOML: running it gives the same members
    std::vector<std::pair<std::string, std::string>> facts;  ///< attribute and value: date, revision, libraries, …
};

/// Throws as read_campaign_file() does; so do the others.
CampaignOrigin read_origin(const CampaignFile& file);

/// Where the floes of a member lay at the start; none where that is not known.
std::vector<PlanarPose> read_poses(const CampaignFile& file, int member);

/// Wall time of each member, s, in member order.
std::vector<double> read_wall_times(const CampaignFile& file);

struct BreakRow {
    int member = 0;
    double time = 0;  ///< s
    int floe = 0;
    int joint = 0;  ///< within the floe, in joint_order()
    int mode = 0;   ///< as /breaks/mode: 0 bending, 1 shear, 2 compression, …
};

/// All breaks of done members in order of member and time; empty where the file keeps none.
std::vector<BreakRow> read_breaks(const CampaignFile& file);

struct PieceRow {
    int member = 0;
    int floe = 0;
    double area = 0;  ///< m²
};

/// The pieces of all floes that cracked through, in order of member and floe; empty where the file keeps none.
std::vector<PieceRow> read_pieces(const CampaignFile& file);

}  // namespace floes
