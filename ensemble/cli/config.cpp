// floes config: print the defaults or the reference, check a configuration, print it resolved.

#include <fmt/format.h>

#include <tbb/info.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "campaign/advice.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/floe_words.hpp"
#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/terminal.hpp"
#include "core/wording.hpp"
#include "driver/plate_moduli.hpp"
#include "tables/data_rows.hpp"

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
    const std::vector<KeyDescription> keys = reference();
    const DataRows records[]{
        make_rows<KeyDescription>("keys", keys,
                                  {{"key", [](const KeyDescription& one) { return Datum(one.key); }},
                                   {"default", [](const KeyDescription& one) { return Datum(one.default_value); }},
                                   {"allowed", [](const KeyDescription& one) { return Datum(one.allowed); }},
                                   {"meaning", [](const KeyDescription& one) { return Datum(one.meaning); }},
                                   {"source", [](const KeyDescription& one) { return Datum(one.source); }}})};
    return json(records);
}

std::string check_line(const Campaign& campaign) {
    std::string calibrated;
    for (const Case& one : campaign.cases) {
        if (one.pairing == Pairing::find_cfm)
            calibrated += (calibrated.empty() ? "; to be calibrated: " : ", ") + one.name;
    }
    std::string text = fmt::format("ok: {} x {} = {}{}\n", counted(std::ssize(campaign.cases), "case"),
                                   counted(campaign.arrangements, "arrangement"),
                                   counted(member_count(campaign), "member"), calibrated);
    for (const std::string& sentence : floe_words(campaign)) text += sentence + "\n";
    for (const std::string& sentence : advice(campaign)) text += "but " + sentence + "\n";
    return text;
}

std::string check(Campaign campaign) {
    Progress progress(std::cerr, style_of_standard_error());
    settle_moduli(campaign, tbb::info::default_concurrency(), progress);
    return check_line(campaign);
}

std::string answer(const ConfigOptions& options) {
    if (options.defaults) return default_configuration();
    if (options.reference) return options.format == "json" ? reference_json() : reference_markdown();
    if (!options.check.empty()) return check(load_campaign(options.check, options.overrides));
    return write_campaign(load_campaign(options.resolved, options.overrides));
}

}  // namespace

void add_config(CommandLine& line) {
    auto options = std::make_shared<ConfigOptions>();
    Verb verb = line.verb("config", "Print the default configuration or the list of keys, or check a configuration");
    OptionList action = verb.exactly_one_of("action", "Action; exactly one of");
    action.flag("--defaults", options->defaults, "Print a complete commented configuration that runs");
    Option reference_flag =
        action.flag("--reference", options->reference, "Print every key: default, range, meaning, source");
    Option check = action.option("--check", options->check, "Check this configuration without running it");
    Option resolved =
        action.option("--resolved", options->resolved, "Print the complete configuration as it would run");
    check.value_name("CONFIG.toml");
    resolved.value_name("CONFIG.toml");
    verb.option("--format", options->format, "Format of the reference: text (Markdown) or json")
        .one_of({"text", "json"})
        .needs(reference_flag);
    verb.option("--set", options->overrides, "key=value: override a key of the file; may be repeated")
        .excludes(reference_flag);
    verb.runs([options] {
        std::fputs(answer(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
