#pragma once
// The keys of [campaign], [design], [stop], [run] and of a [[case]], and what is printed about keys.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "keys/key.hpp"
#include "keys/write.hpp"

namespace floes {

/// The sentence that says what is wrong with stop.of; none if every case measures that quantity.
std::optional<std::string> stop_quantity_fault(const Campaign& campaign);

/// The fields of [campaign].
struct CampaignHead {
    std::string name;
    std::uint64_t seed = 1;
    int arrangements = 1;
    bool common_arrangements = true;
};

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

/// The keys of a campaign's tables, [campaign] first.
Keys describe_all(CampaignHead& head, Design& design, StopRule& stop, RunRules& rules, Scenario& scenario);

/// The same, bound to the defaults beside them.
struct DefaultKeys {
    CampaignHead head;
    Design design;
    StopRule stop;
    RunRules rules;
    Scenario scenario;
    Keys keys = describe_all(head, design, stop, rules, scenario);
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

/// One line of the reference.
struct KeyDescription {
    std::string key;
    std::string default_value;
    std::string allowed;
    std::string meaning;
    std::string source;
};

std::vector<KeyDescription> reference();

}  // namespace floes
