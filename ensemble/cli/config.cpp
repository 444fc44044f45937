// floes config: print the defaults or the reference, check a configuration, print it resolved.

#include "cli/config.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <tbb/info.h>

#include "campaign/advice.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/case_words.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "run/calibrate.hpp"
#include "tables/section.hpp"

namespace floes {

std::string read_bytes(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError(fmt::format("{}: this is a folder; name a file in it", path));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(fmt::format("{}: this file cannot be read ({})", path, std::strerror(errno)));
    std::string text;
    for (std::vector<char> some(1 << 16); file; text.append(some.data(), static_cast<std::size_t>(file.gcount()))) {
        if (text.size() > longest_configuration)
            throw InputError(fmt::format("{}: this file is longer than {} bytes, the most that are read", path,
                                         longest_configuration));
        file.read(some.data(), std::ssize(some));
    }
    return text;
}

std::string read_text(const std::string& path) {
    if (const GivenFile kind = given_file(path); kind == GivenFile::hdf5 || kind == GivenFile::journal)
        throw InputError(fmt::format("{}: this is {}, not a configuration; give the CONFIG.toml", path,
                                     kind == GivenFile::hdf5 ? "an HDF5 file" : "the journal of a campaign"));
    return read_bytes(path);
}

std::string find_config(const std::string& name) {
    const bool word = !name.empty() && name.find_first_of("/.") == std::string::npos;
    if (!word || std::filesystem::exists(name)) return name;
    std::error_code unknown;
    std::vector<std::filesystem::path> folders;
    if (const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown); !unknown)
        folders.push_back((program.parent_path() / FLOES_SHARE_FROM_PROGRAM).lexically_normal());
    if (const char* launcher = std::getenv("FLOES_LAUNCHER"))  // of a clone
        folders.push_back(std::filesystem::path(launcher).parent_path());
    for (const std::filesystem::path& folder : folders)
        if (const auto known = folder / "configs" / (name + ".toml"); std::filesystem::exists(known, unknown))
            return known.string();
    return name;
}

namespace {

/// Whether a configuration has nothing but blanks and comments.
bool states_nothing(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::size_t first = text.find_first_not_of(" \t\r");
        if (first < end && text[first] != '#') return false;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return true;
}

}  // namespace

Campaign load_campaign(const std::string& name, const std::vector<std::string>& overrides) {
    const std::string path = find_config(name);
    const std::string text = read_text(path);
    Campaign campaign = read_campaign({text, path, overrides, true}, read_text);
    if (states_nothing(text))
        std::fprintf(stderr,
                     "floes: %s states no key, so everything %shas its default; floes config --defaults prints them\n",
                     path.c_str(), overrides.empty() ? "" : "but --set ");
    return campaign;
}

const Case& chosen_case(const Campaign& campaign, const std::string& name) {
    if (campaign.cases.size() == 1 && name.empty()) return campaign.cases.front();
    const auto found = std::ranges::find(campaign.cases, name, &Case::name);
    if (found != campaign.cases.end()) return *found;
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    throw InputError(
        name.empty()
            ? fmt::format("one case is taken, and this campaign has several; name it with --case: {}", name_list(names))
            : fmt::format("there is no case {}; the cases are {}", name, name_list(names)));
}

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
    const Results keys = list("keys", "key default allowed meaning source", reference(),
                              [](const KeyDescription& one) -> std::vector<Datum> {
                                  return {one.key, one.default_value, one.allowed, one.meaning, one.source};
                              });
    return json(std::vector{Section{.results = {keys}}});
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
    for (const std::string& sentence : case_words(campaign)) text += sentence + "\n";
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
