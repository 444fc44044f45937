// A configuration as a user writes it. Comments "#set KEY=VALUE" at its beginning are given as --set.

#include <algorithm>

#include "fuzz/campaign_text.hpp"

namespace {

constexpr std::string_view set_mark = "#set ";

std::string two_poses(const std::string& path) {
    if (path.size() > 40) throw floes::InputError("there is no such file");
    return "x_m,z_m,yaw_deg\n6.5,0,0\n8,1,45\n";
}

std::vector<std::string> overrides_of(std::string_view text) {
    std::vector<std::string> overrides;
    while (text.starts_with(set_mark)) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        overrides.emplace_back(text.substr(set_mark.size(), end - set_mark.size()));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return overrides;
}

bool merely_long(const floes::CampaignSource& source) {
    if (!floes::fuzz::may_be_long(source.text)) return false;
    const auto document = floes::fuzz::taken([&] { return floes::parse_document(source.text, source.file); });
    if (!document) return false;
    floes::Document whole = *document;
    for (const std::string& text : source.overrides) {
        const auto entry = floes::fuzz::taken([&] { return floes::parse_override(text, "--set"); });
        if (entry) whole.entries.push_back(*entry);
    }
    return floes::fuzz::merely_long(whole);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = floes::fuzz::as_text(data, size);
    const floes::CampaignSource source{std::string(text), "configs/a.toml", overrides_of(text), true};
    if (merely_long(source)) return 0;
    const auto campaign = floes::fuzz::taken([&] { return floes::read_campaign(source, two_poses); });
    if (campaign) floes::fuzz::require_round_trip(*campaign);
    return 0;
}
