#include "completion_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/campaign_keys.hpp"

namespace floes::manual {

std::string quoted(const std::string& text, const std::string& quote) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? quote : std::string(1, c);
    return out + "'";
}

Source source_of(const OptionText& option) {
    const auto is_named = [&](const auto& names) {
        return std::ranges::any_of(
            option.names, [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); });
    };
    if (!option.choices.empty()) return Source::words;
    if (is_named(std::array<std::string_view, 1>{"--set"})) return Source::keys;
    if (is_named(std::array<std::string_view, 2>{"--case", "--reference"})) return Source::cases;
    if (is_named(std::array<std::string_view, 4>{"config", "--check", "--resolved", "--targets"}))
        return Source::configurations;
    if (is_named(std::array<std::string_view, 4>{"campaign", "campaigns", "parts", "file"})) return Source::campaigns;
    return is_named(std::array<std::string_view, 1>{"files"}) ? Source::stored : Source::files;
}

Source positional_source(const VerbText& verb) {
    for (const OptionText& option : verb.options)
        if (option.positional && source_of(option) != Source::files) return source_of(option);
    return Source::files;
}

std::vector<std::string> endings(Source source) {
    if (source == Source::configurations) return {"toml"};
    if (source == Source::campaigns) return {"h5"};
    if (source == Source::stored) return {"h5", "journal"};
    return {};
}

std::string keys_to_set() {
    std::vector<std::string> keys;
    const CampaignTables all;
    for (const Key& key : all.keys) keys.push_back(std::string(key.path) + "=");
    return fmt::format("{}", fmt::join(keys, " "));
}

std::string inner_pattern(const std::vector<VerbText>& verbs) {
    std::vector<std::string> names;
    for (const VerbText& verb : verbs)
        if (verb.is_inner()) names.push_back(fmt::format("'{}'", verb.name));
    return fmt::format("{}", fmt::join(names, " | "));
}

}  // namespace floes::manual
