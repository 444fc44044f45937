#pragma once
// Campaigns as the text of their configuration.

#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// The complete resolved configuration as TOML: reading it gives an equal campaign (file poses inline). Keys in which
/// the cases differ stand in each case, all others in the tables; the points of a design are written out; a case to be
/// calibrated has no joint.cfm anywhere.
/// Throws InputError, beginning with `where`, for a text that read_campaign() would refuse as too long.
std::string write_campaign(const Campaign& campaign, const std::string& where = "the resolved configuration");

/// The same for people: values that follow from others say so on their lines, "# derived: the diagonal of the largest
/// floe, 63.6 m". Reading it gives the same campaign, in which they are stated.
std::string resolved_text(const Campaign& campaign);

// What a model leaves open, varied one at a time: a campaign whose cases show how far its loads depend on inputs that
// are rarely measured.

struct Variation {
    std::string name;                                       ///< of its case: "ice_ice_friction_0.15"
    std::string why;                                        ///< how far the input is open, a phrase
    std::vector<std::pair<std::string, std::string>> sets;  ///< keys and their values as text
};

/// What is rarely measured, then what the load depends on strongly: channel, slope of the wall, speed. Inputs that have
/// no effect in the scenario are left out, variations that could not be run, and what the user chose rather than
/// measured: the kind of hull, the floes' sizes, the far end.
std::vector<Variation> variations_of(const Scenario& scenario);

/// The case as a configuration: the keys that differ from their defaults, the case `base`, and a case for each
/// variation.
std::string variations_text(const Campaign& campaign, const Case& of);

/// The case with other values, as a configuration: the keys that differ from their defaults, and `cases`.
std::string study_text(const Campaign& campaign, const Case& of, const std::vector<Variation>& cases);

}  // namespace floes
