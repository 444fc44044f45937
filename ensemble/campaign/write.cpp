// write_campaign(): the resolved configuration.

#include <fmt/format.h>

#include <set>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "keys/literal.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr const char* cfm_path = "joint.cfm";

/// Paths of the keys in which the cases differ, or that some do not have.
std::set<std::string> varying_paths(std::vector<Case>& cases) {
    std::set<std::string> paths;
    const Keys first = describe(cases.front().scenario);
    for (Case& one : cases) {
        if (one.calibrate) paths.insert(cfm_path);
        const Keys keys = describe(one.scenario);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (exact_text(keys[i]) != exact_text(first[i])) paths.insert(keys[i].path);
        }
    }
    return paths;
}

}  // namespace

std::string write_campaign(const Campaign& campaign) {
    CampaignHead head{campaign.name, campaign.seed, campaign.arrangements};
    std::vector<Case> cases = campaign.cases;
    const std::set<std::string> varying = varying_paths(cases);
    StopRule stop = campaign.stop;
    RunRules rules = campaign.run;
    Keys tables = describe(head);
    for (Key& key : describe(stop)) tables.push_back(std::move(key));
    for (Key& key : describe(rules)) tables.push_back(std::move(key));
    for (Key& key : describe(cases.front().scenario)) {
        if (!varying.contains(key.path)) tables.push_back(std::move(key));
    }
    std::string text = write_tables(tables, titles(), Comments::none);
    for (Case& one : cases) {
        text += fmt::format("\n[[case]]\nname = {}\n", text_literal(one.name));
        for (const Key& key : describe(one.scenario)) {
            if (one.calibrate && key.path == cfm_path) {
                text += "# joint.cfm: calibrated to show the elastic modulus when the campaign runs\n";
            } else if (varying.contains(key.path)) {
                text += fmt::format("{} = {}\n", key.path, literal(key));
            }
        }
    }
    return text;
}

}  // namespace floes
