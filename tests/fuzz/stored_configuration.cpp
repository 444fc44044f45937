// The resolved text of a campaign, as journals, campaign files and messages have it.

#include "fuzz/campaign_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const floes::CampaignSource source{std::string(floes::fuzz::as_text(data, size)), "a.journal", {}};
    if (floes::fuzz::may_be_long(source.text)) {
        const auto document = floes::fuzz::taken([&] { return floes::parse_document(source.text, source.file); });
        if (!document || floes::fuzz::merely_long(*document)) return 0;
    }
    const auto campaign = floes::fuzz::taken([&] { return floes::read_campaign(source, nullptr); });
    if (campaign) floes::fuzz::require_round_trip(*campaign);
    return 0;
}
