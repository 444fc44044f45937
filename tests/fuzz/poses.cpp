// A file of poses, and the campaign that begins with them.

#include "campaign/read.hpp"
#include "fuzz/campaign_text.hpp"

namespace {

// A short tow in a wide field, so that few poses lie outside.
constexpr const char* configuration =
    "field = {concentration_percent = 1, half_width_m = 10}\n"
    "analysis = {steady_start_s = 60, window_s = 3}\n"
    "arrangement = {method = \"file\", file = \"poses.csv\"}\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static std::string text;  // a LoadFile has no state of its own
    text = floes::fuzz::as_text(data, size);
    const auto poses = floes::fuzz::taken([&] { return floes::read_poses(text, "poses.csv"); });
    if (!poses) return 0;
    const std::string count = std::to_string(std::get<std::vector<floes::Value>>(poses->poses.data).size());
    const floes::CampaignSource source{configuration, "a.toml", {"field.floes=" + count}, true};
    const auto campaign = floes::fuzz::taken(
        [&] { return floes::read_campaign(source, [](const std::string&) { return std::string(text); }); });
    if (campaign) floes::fuzz::require_round_trip(*campaign);
    return 0;
}
