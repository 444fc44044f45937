#include "campaign/write.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "campaign/campaign_keys.hpp"
#include "campaign/read_design.hpp"
#include "keys/literal.hpp"
#include "keys/read.hpp"
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

/// The axes as [[design.axis]] blocks.
std::string axes_text(const Design& design, Scenario scratch) {
    std::string text;
    const Keys keys = describe(scratch);
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

std::string write_campaign(const Campaign& campaign) {
    CampaignHead head{campaign.name, campaign.seed, campaign.arrangements, campaign.common_arrangements};
    std::vector<Case> cases = campaign.cases;
    const std::set<std::string> varying = varying_paths(cases);
    StopRule stop = campaign.stop;
    RunRules rules = campaign.run;
    Design design = campaign.design;
    Keys tables = describe(head);
    if (design.active()) {
        for (Key& key : describe(design)) tables.push_back(std::move(key));
    }
    for (Key& key : describe(stop)) tables.push_back(std::move(key));
    for (Key& key : describe(rules)) tables.push_back(std::move(key));
    for (Key& key : describe(cases.front().scenario)) {
        if (!varying.contains(key.path)) tables.push_back(std::move(key));
    }
    std::string text = write_tables(tables, titles(), Comments::none);
    text += axes_text(design, cases.front().scenario);
    for (Case& one : cases) {
        text += fmt::format("\n[[case]]\nname = {}\n", text_literal(one.name));
        if (design.active())
            text += fmt::format("design.base = {}\ndesign.point = {}\n", text_literal(one.base), one.point);
        for (const Key& key : describe(one.scenario)) {
            if (one.calibrate && key.path == cfm_path) {
                text += "# joint.cfm: calibrated to show the elastic modulus when the campaign runs\n";
            } else if (varying.contains(key.path) && !key.part) {
                text += fmt::format("{} = {}\n", key.path, literal(key));
            }
        }
    }
    return text;
}

}  // namespace floes
