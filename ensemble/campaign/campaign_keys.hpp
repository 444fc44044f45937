#pragma once
// The keys of [campaign], [design], [stop], [run] and of a [[case]], and what is printed about keys.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "keys/key.hpp"
#include "keys/write.hpp"
#include "scenario/keys.hpp"

namespace floes {

/// The sentence that says what is wrong with stop.of; none if every case measures that quantity.
std::optional<std::string> stop_quantity_fault(const Campaign& campaign);

inline constexpr const char* common_path = "campaign.common_arrangements";

/// The keys of [campaign], bound to `head`.
Keys describe(CampaignHead& head);

/// The keys of [stop].
Keys describe(StopRule& stop);

/// The keys of [design].
Keys describe(Design& design);

/// design.method, the first of them.
Key method_key(Design& design);

/// The keys of [run], bound to `rules`.
Keys describe(RunRules& rules);

/// The tables of a campaign, by default, and the keys that are bound to them, [campaign] first.
struct CampaignTables {
    CampaignHead head;
    Design design;
    StopRule stop;
    RunRules run;
    Scenario scenario;
    Keys keys = joined_keys(describe(head), describe(design), describe(stop), describe(run), describe(scenario));

    CampaignTables() = default;
    CampaignTables(const CampaignTables&) = delete;
    CampaignTables& operator=(const CampaignTables&) = delete;
};

/// The keys that a [[case]] takes: name, design.base and design.point of a design written out, the shorthands cfm
/// and elastic_modulus_MPa, and every key of a scenario.
Keys describe(Case& one);

/// The full path of a shorthand of a [[case]]; other paths are returned as they are.
std::string full_path(const std::string& path);

/// A sentence about each table of a configuration.
TableTitles titles();

/// A complete commented configuration that runs: the defaults.
std::string default_configuration();

/// All keys as Markdown, a table for each table of the configuration. docs/configuration.md contains it.
std::string reference_markdown();

}  // namespace floes
