#pragma once
// From a campaign to the text of its configuration.

#include <string>

#include "campaign/campaign.hpp"

namespace floes {

/// The complete resolved configuration as TOML: reading it gives an equal campaign (file poses inline). Keys in which
/// the cases differ stand in each case, all others in the tables; the points of a design are written out; a case to be
/// calibrated has no joint.cfm anywhere.
/// Throws InputError, beginning with `where`, for a text that read_campaign() would refuse as too long.
std::string write_campaign(const Campaign& campaign, const std::string& where = "the resolved configuration");

}  // namespace floes
