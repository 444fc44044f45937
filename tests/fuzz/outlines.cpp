// A file of traced floes, and the campaign whose floes have its outlines: the first byte says whether it is CSV ('c')
// or GeoJSON.

#include <cmath>

#include "campaign/outline_file.hpp"
#include "fuzz/campaign_text.hpp"

namespace {

// A short tow in a wide field, so that few outlines are refused for their sizes.
constexpr const char* configuration =
    "joint = {failure = \"moment\"}\n"
    "field = {floes = 40, concentration_percent = 1, half_width_m = 10}\n"
    "analysis = {steady_start_s = 60, window_s = 3}\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0 || size > 4000) return 0;  // more corners take longer and tell no more
    static std::string text;                 // a LoadFile has no state of its own
    text = floes::fuzz::as_text(data + 1, size - 1);
    const std::string name = data[0] == 'c' ? "a.csv" : "a.json";
    floes::TracedOutlines traced;
    const auto taken = floes::fuzz::taken([&] {
        floes::take_outlines(traced, text, name);
        return true;
    });
    if (!taken) return 0;
    floes::fuzz::require(traced.outlines.size() == traced.areas.size(), "an outline has no area");
    for (const floes::Outline& one : traced.outlines) {
        floes::fuzz::require(std::isfinite(floes::area_of(one)) && floes::area_of(one) > 0, "an outline has no area");
        floes::fuzz::require(one.size() <= 16, "an outline has too many corners");
    }
    const floes::CampaignSource source{
        configuration, "a.toml", {"shapes.kind=file", "shapes.file=" + name, "shapes.most_added_percent=1000"}, true};
    const auto campaign = floes::fuzz::taken(
        [&] { return floes::read_campaign(source, [](const std::string&) { return std::string(text); }); });
    if (campaign) floes::fuzz::require_round_trip(*campaign);
    return 0;
}
