#pragma once
// What holds for each campaign that was read: its resolved text gives the same campaign, and the same text, again.

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "fuzz/fuzz.hpp"

namespace floes::fuzz {

inline void require_round_trip(const Campaign& campaign) {
    const std::string text = write_campaign(campaign);
    const std::optional<Campaign> again = taken([&] { return read_campaign({text, "stored.toml", {}}, nullptr); });
    require(again.has_value(), "the resolved text is refused");
    require(fingerprint(*again) == fingerprint(campaign), "the resolved text gives another campaign");
    require(again->stop == campaign.stop, "the resolved text gives another stop rule");
    require(write_campaign(*again) == text, "the resolved text is written in another way");
}

/// Whether a text could be merely long, seen without parsing it: one with a design or many tables.
inline bool may_be_long(std::string_view text) {
    constexpr int many = 64;
    const auto opened = std::ranges::count(text, '[') + std::ranges::count(text, '{');
    return opened > many || text.find("design") != std::string_view::npos || text.find('\\') != std::string_view::npos;
}

/// True for a text that is allowed and merely long to read: designs of hundreds of cases would take the fuzzer's time.
/// Numbers beyond what is allowed are not left out.
inline bool merely_long(const Document& document) {
    constexpr std::int64_t few = 64;
    std::int64_t points = 1;
    std::int64_t cases = 0;
    for (const Entry& entry : document.entries) {
        const auto* number = std::get_if<std::int64_t>(&entry.value.data);
        if (entry.path == "design.points" && number != nullptr) points = std::max(points, *number);
    }
    for (const Block& block : document.blocks) {
        if (block.path == "case") ++cases;
        for (const Entry& entry : block.entries) {
            const auto* values = std::get_if<std::vector<Value>>(&entry.value.data);
            if (entry.path == "values" && values != nullptr && points <= most_cases)
                points *= std::max<std::int64_t>(1, std::ssize(*values));
        }
    }
    const std::int64_t all = std::min(points, most_cases + 1) * std::max<std::int64_t>(1, cases);
    return all > few && all <= most_cases;
}

}  // namespace floes::fuzz
