// floes config: print the defaults or the reference, check a configuration, print it resolved.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/advice.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "core/wording.hpp"

namespace floes {
namespace {

struct ConfigOptions {
    bool defaults = false;
    bool reference = false;
    std::string check;
    std::string resolved;
    std::string format = "text";
    std::vector<std::string> overrides;
};

std::string reference_json() {
    nlohmann::ordered_json keys = nlohmann::ordered_json::array();
    for (const KeyDescription& key : reference()) {
        keys.push_back({{"key", key.key},
                        {"default", key.default_value},
                        {"allowed", key.allowed},
                        {"meaning", key.meaning},
                        {"source", key.source}});
    }
    return nlohmann::ordered_json{{"keys", keys}}.dump(2) + "\n";
}

std::string check_line(const Campaign& campaign) {
    std::string calibrated;
    for (const Case& one : campaign.cases) {
        if (one.calibrate) calibrated += (calibrated.empty() ? "; to be calibrated: " : ", ") + one.name;
    }
    std::string text = fmt::format("ok: {} x {} = {}{}\n", counted(std::ssize(campaign.cases), "case"),
                                   counted(campaign.arrangements, "arrangement"),
                                   counted(member_count(campaign), "member"), calibrated);
    for (const std::string& sentence : advice(campaign)) text += "but " + sentence + "\n";
    return text;
}

std::string answer(const ConfigOptions& options) {
    if (options.defaults) return default_configuration();
    if (options.reference) return options.format == "json" ? reference_json() : reference_markdown();
    if (!options.check.empty()) return check_line(load_campaign(options.check, options.overrides));
    return write_campaign(load_campaign(options.resolved, options.overrides));
}

}  // namespace

void add_config(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<ConfigOptions>();
    CLI::App* verb = program.add_subcommand(
        "config", "Print the default configuration or the list of keys, or check a configuration");
    CLI::Option_group* action = verb->add_option_group("action", "Action; exactly one of");
    action->add_flag("--defaults", options->defaults, "Print a complete commented configuration that runs");
    CLI::Option* reference_flag =
        action->add_flag("--reference", options->reference, "Print every key: default, range, meaning, source");
    CLI::Option* check = action->add_option("--check", options->check, "Check this configuration without running it");
    CLI::Option* resolved =
        action->add_option("--resolved", options->resolved, "Print the complete configuration as it would run");
    action->require_option(1);
    check->type_name("CONFIG.toml");
    resolved->type_name("CONFIG.toml");
    verb->add_option("--format", options->format, "Format of the reference: text (Markdown) or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->needs(reference_flag);
    verb->add_option("--set", options->overrides, "key=value: override a key of the file; may be repeated")
        ->excludes(reference_flag);
    verb->callback([options, &exit_status] {
        std::fputs(answer(*options).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
