#include "campaign/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <span>
#include <string_view>

#include "campaign/campaign_keys.hpp"
#include "campaign/design.hpp"
#include "keys/document.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

constexpr std::string_view cfm_path = "joint.cfm";
constexpr std::string_view modulus_path = "ice.elastic_modulus_MPa";

/// Why the text of a case leaves out a key that is still to be found; empty for others.
std::string_view to_be_found(const Case& one, const Key& key) {
    if (one.pairing == Pairing::find_cfm && key.path == cfm_path)
        return "calibrated to show the elastic modulus when the campaign runs";
    if (one.pairing == Pairing::find_modulus && key.path == modulus_path)
        return "measured by a plate test when the campaign runs";
    return {};
}

/// Paths of the keys that differ between cases, or that some cases do not have. `keys` are bound to `scenario`, which
/// takes the scenario of each case in turn.
std::set<std::string_view> varying_paths(const std::vector<Case>& cases, const Keys& keys, Scenario& scenario) {
    std::set<std::string_view> paths;
    for (const Case& one : cases)
        for (const Key& key : keys)
            if (!to_be_found(one, key).empty()) paths.insert(key.path);
    if (cases.size() == 1) return paths;
    scenario = cases.front().scenario;
    std::vector<std::string> first;
    for (const Key& key : keys) first.push_back(exact_text(key));
    for (const Case& one : std::span(cases).subspan(1)) {
        scenario = one.scenario;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (!paths.contains(keys[i].path) && exact_text(keys[i]) != first[i]) paths.insert(keys[i].path);
        }
    }
    return paths;
}

/// The axes as [[design.axis]] blocks. Uses the fields that `keys` are bound to.
std::string axes_text(const Design& design, const Keys& keys) {
    std::string text;
    for (const DesignAxis& axis : design.axes) {
        const Key& key = *find_key(keys, axis.key);
        const auto written = [&](const Value& value) {
            assign(key, {axis.key, value, "design"});
            return literal(key);
        };
        const auto end = [&](double value) {
            return axis.whole ? fmt::format("{}", static_cast<std::int64_t>(value)) : number_literal(value);
        };
        text += fmt::format("\n[[{}]]\nkey = {}\n", axis_block, text_literal(axis.key));
        if (axis.numeric) text += axis.scale == AxisScale::log ? "scale = \"log\"\n" : "scale = \"linear\"\n";
        if (design.has_ranges()) {
            text += fmt::format("from = {}\nto = {}\n", end(axis.from), end(axis.to));
        } else {
            std::vector<std::string> values;
            for (const Value& value : axis.values) values.push_back(written(value));
            text += fmt::format("values = [{}]\n", fmt::join(values, ", "));
        }
    }
    return text;
}

}  // namespace

std::string write_campaign(const Campaign& campaign, const std::string& where) {
    CampaignHead head{campaign.name, campaign.seed, campaign.arrangements, campaign.common_arrangements};
    const std::vector<Case>& cases = campaign.cases;
    Scenario scenario = cases.front().scenario;
    const Keys keys = describe(scenario);  // only once, because it takes longer than the rest of a case
    const std::set<std::string_view> varying = varying_paths(cases, keys, scenario);
    StopRule stop = campaign.stop;
    RunRules rules = campaign.run;
    Design design = campaign.design;
    Keys tables = describe(head);
    if (design.active()) {
        for (Key& key : describe(design)) tables.push_back(std::move(key));
    }
    for (Key& key : describe(stop)) tables.push_back(std::move(key));
    for (Key& key : describe(rules)) tables.push_back(std::move(key));
    scenario = cases.front().scenario;
    for (const Key& key : keys) {
        if (!varying.contains(key.path) && !is_superfluous(key)) tables.push_back(key);
    }
    std::string text = write_tables(tables, titles(), Comments::none);
    text += axes_text(design, keys);
    for (const Case& one : cases) {
        if (text.size() > longest_text) break;  // lists repeated in each case can make it very long
        scenario = one.scenario;
        text += fmt::format("\n[[case]]\nname = {}\n", text_literal(one.name));
        if (design.active())
            text += fmt::format("design.base = {}\ndesign.point = {}\n", text_literal(one.base), one.point);
        for (const Key& key : keys) {
            if (const std::string_view why = to_be_found(one, key); !why.empty()) {
                text += fmt::format("# {}: {}\n", key.path, why);
            } else if (varying.contains(key.path) && !key.part && !is_superfluous(key)) {
                text += fmt::format("{} = {}\n", key.path, literal(key));
            }
        }
    }
    refuse_what_cannot_be_held(text, where);
    return text;
}

}  // namespace floes
