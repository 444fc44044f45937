// Configurations: floes new, vary and config.

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include <tbb/info.h>

#include "campaign/campaign_keys.hpp"
#include "campaign/case_words.hpp"
#include "campaign/schema.hpp"
#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "run/calibrate.hpp"
#include "run/plan.hpp"
#include "tables/section.hpp"

namespace floes {

// floes new: the configuration that a first campaign begins with.

namespace {

/// A configuration to begin with, other than the first one.
struct Kind {
    const char* flag;
    const char* file;
    const char* words;
};

constexpr std::array<Kind, 6> kinds{{
    {"--full-scale", "full_scale.toml", "A floater of 70 m in floes of 20 m, instead of model ice"},
    {"--moored", "moored.toml", "A moored hull that floats among floes of mixed shapes, at full scale"},
    {"--turret", "turret.toml", "A turret ship that swings with the drift, in floes of two sizes, at full scale"},
    {"--level", "level.toml", "A cone in level ice: one sheet that breaks, instead of floes"},
    {"--design", "design.toml", "A design over two keys: how the load depends on them"},
    {"--paper", "paper.toml", "The paper's Table 3, with few arrangements"},
}};

/// Of the schema that configurations of a folder share.
constexpr const char* schema_file = "floes.schema.json";

struct NewOptions {
    std::string file;
    bool schema = false;
    std::array<bool, kinds.size()> wanted{};
};

/// The text of the configuration `name`, which floes config --check accepts.
std::string text_of(const NewOptions& options, const std::string& name) {
    const auto chosen = std::ranges::find(options.wanted, true) - options.wanted.begin();
    const char* file = chosen == std::ssize(kinds) ? "tank.toml" : kinds.at(static_cast<std::size_t>(chosen)).file;
    std::string text{starter(file).value()};
    constexpr std::string_view placeholder = "CONFIG.toml";
    return text.replace(text.find(placeholder), placeholder.size(), name);
}

int make(const NewOptions& options) {
    const std::filesystem::path path = options.file;
    if (path.extension() != ".toml")
        throw InputError(fmt::format("{} is to be a configuration, whose name ends with .toml.", options.file));
    const std::string text = text_of(options, path.filename().string());
    const std::filesystem::path schema = path.parent_path() / schema_file;
    write_new(path, options.schema ? fmt::format("#:schema ./{}\n{}", schema_file, text) : text);
    std::printf("%s\n", options.file.c_str());
    if (options.schema) {
        write_page(schema, configuration_schema());
        std::printf("%s\n", schema.c_str());
    }
    const std::string result = std::filesystem::path(path).replace_extension(".h5").filename().string();
    note("edit it, see it by floes show {0}, then floes run {0}, and floes summarize {1}", shell_word(options.file),
         shell_word(result));
    return 0;
}

}  // namespace

void add_new(CommandLine& line) {
    auto options = std::make_shared<NewOptions>();
    Verb verb = line.verb("new", "Write a configuration to begin with: the keys that everybody sets");
    verb.option("config", options->file, "The configuration to make (CONFIG.toml)").required();
    verb.flag("--schema", options->schema,
              "Write floes.schema.json beside it and name that in its first line, for editors that check TOML by it");
    std::vector<Option> others;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        Option flag = verb.flag(kinds.at(k).flag, options->wanted.at(k), kinds.at(k).words);
        for (Option& other : others) flag.excludes(other);
        others.push_back(flag);
    }
    verb.runs([options] { return make(*options); });
}

// floes vary: the configuration of a study that varies what the model leaves open, one input at a time.

namespace {

struct VaryOptions {
    std::string file;
    std::string case_name;
    std::vector<std::string> overrides;
};

}  // namespace

void add_vary(CommandLine& line) {
    auto options = std::make_shared<VaryOptions>();
    Verb verb = line.verb("vary", "Write a study of what the model leaves open: friction, strength, water, channel");
    verb.option("config", options->file, "The configuration (CONFIG.toml)").required();
    verb.option("--case", options->case_name, "The case to vary, if there are several");
    add_overrides(verb, options->overrides);
    verb.footer(
        "The study goes to standard output. It has the case as it is and some twenty others, each with one input\n"
        "changed as far as it is usually unknown; edit it as you know better. Eight arrangements and more say "
        "something.\n\n"
        "  floes vary my.toml --set campaign.arrangements=12 > varied.toml\n"
        "  floes run varied.toml\n"
        "  floes summarize varied.h5 --parts model");
    verb.prints([options] {
        const Campaign campaign = load_campaign(options->file, options->overrides);
        return variations_text(campaign, chosen_case(campaign, options->case_name));
    });
}

// floes config: print the defaults or the reference, check a configuration, print it resolved.

namespace {

struct ConfigOptions {
    bool defaults = false;
    bool reference = false;
    bool schema = false;
    std::string table;
    std::string check;
    std::string resolved;
    std::string format = "text";
    std::vector<std::string> overrides;
};

/// Throws InputError for a table that no key is in; "": all of them.
void expect_table(const std::string& table) {
    const CampaignTables all;
    std::vector<std::string_view> tables;
    for (const Key& key : all.keys)
        if (tables.empty() || tables.back() != key.table()) tables.push_back(key.table());
    if (!table.empty() && std::ranges::find(tables, table) == tables.end())
        throw InputError(fmt::format("there is no table {}; the tables are {}.", table, fmt::join(tables, ", ")));
}

std::string reference_json(const std::string& table) {
    CampaignTables all;
    std::erase_if(all.keys, [&](const Key& key) { return !table.empty() && key.table() != table; });
    const Results keys =
        list("keys", "key default allowed meaning source", all.keys, [](const Key& key) -> std::vector<Datum> {
            return {std::string(key.path), literal(key), allowed(key), std::string(key.doc), std::string(key.source)};
        });
    return json(std::vector{Section{.results = {keys}}});
}

std::string reference_text(const std::string& table) {
    const std::string all = reference_markdown();
    if (table.empty()) return all;
    const std::size_t begin = all.find(fmt::format("## [{}]", table));
    return all.substr(begin, all.find("\n## [", begin) - begin) + "\n";
}

std::string check(Campaign campaign) {
    Progress progress(std::cerr, style_of_standard_error());
    settle_moduli(campaign, tbb::info::default_concurrency(), progress);
    std::string calibrated;
    for (const Case& one : campaign.cases) {
        if (one.pairing == Pairing::find_cfm)
            calibrated += (calibrated.empty() ? "; to be calibrated: " : ", ") + one.name;
    }
    std::string text = fmt::format("ok: {} x {} = {}{}\n", counted(std::ssize(campaign.cases), "case"),
                                   counted(campaign.arrangements, "arrangement"),
                                   counted(member_count(campaign), "member"), calibrated);
    for (const std::string& sentence : case_words(campaign)) text += sentence + "\n";
    for (const std::string& sentence : cost_words(campaign)) text += sentence + "\n";
    if (const std::string remark = hull_remark(campaign); !remark.empty()) text += remark + "\n";
    for (const std::string& sentence : advice(campaign)) text += "but " + sentence + "\n";
    return text;
}

std::string answer(const ConfigOptions& options) {
    if (options.defaults) return default_configuration();
    if (options.schema) return configuration_schema();
    expect_table(options.table);
    if (options.reference)
        return options.format == "json" ? reference_json(options.table) : reference_text(options.table);
    if (!options.check.empty()) return check(load_campaign(options.check, options.overrides));
    return resolved_text(load_campaign(options.resolved, options.overrides));
}

}  // namespace

void add_config(CommandLine& line) {
    auto options = std::make_shared<ConfigOptions>();
    Verb verb = line.verb("config", "Print the default configuration or the list of keys, or check a configuration");
    OptionList action = verb.exactly_one_of("action", "Action; exactly one of");
    Option defaults_flag =
        action.flag("--defaults", options->defaults, "Print a complete commented configuration that runs");
    Option reference_flag =
        action.flag("--reference", options->reference, "Print every key: default, range, meaning, source");
    verb.option("table", options->table, "With --reference: only the keys of this table, as moorings")
        .needs(reference_flag);
    Option schema_flag = action.flag(
        "--schema", options->schema,
        "Print the JSON Schema, by which editors complete and check keys; floes new --schema writes it beside");
    Option check = action.option("--check", options->check, "Check this configuration without running it");
    Option resolved =
        action.option("--resolved", options->resolved, "Print the complete configuration as it would run");
    check.value_name("CONFIG.toml");
    resolved.value_name("CONFIG.toml");
    verb.option("--format", options->format, "Format of the reference: text (Markdown) or json")
        .one_of({"text", "json"})
        .needs(reference_flag);
    add_overrides(verb, options->overrides).excludes(reference_flag).excludes(defaults_flag).excludes(schema_flag);
    verb.runs([options] {
        std::fputs(answer(*options).c_str(), stdout);
        if (!options->check.empty()) note("to see it: floes show {}", shell_word(options->check));
        return 0;
    });
}

}  // namespace floes
