#include "cli/until.hpp"

#include <ranges>
#include <regex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "core/error.hpp"
#include "member/design_of.hpp"
#include "member/quantity.hpp"

namespace floes {

std::vector<std::string> until_settings(const std::string& text) {
    static const std::regex form(
        R"(\s*([a-z_0-9.]+)(?:\s+(?:in\s+)?([0-9.]+)\s*h)?\s*(?:\+-|\+/-|±|\bwithin\b)\s*([0-9.]+)\s*%?\s*)");
    std::smatch found;
    if (!std::regex_match(text, found, form))
        throw InputError(
            fmt::format("--until \"{}\" is not understood; write what, in how many hours, and how precisely, as "
                        "\"mooring_force 3 h +- 15 %\" for a design value, or \"mean_load +- 5 %\" for a mean.",
                        text));
    const DesignOf* design = find_design_of(found[1].str());
    const std::optional<Quantity> quantity = any_quantity(found[1].str());
    if (design == nullptr && !(quantity && quantity->stops))
        throw InputError(
            fmt::format("--until \"{}\": {} is not known; take one of {} for its design value, or mean_load or another "
                        "word of stop.of for its mean.",
                        text, found[1].str(), fmt::join(design_ofs | std::views::transform(&DesignOf::word), ", ")));
    if (design == nullptr && found[2].matched)
        throw InputError(fmt::format("--until \"{}\": the mean of {} has no exposure; leave \"{} h\" out.", text,
                                     found[1].str(), found[2].str()));
    std::vector<std::string> settings{
        fmt::format("stop.of=\"{}{}\"", design == nullptr ? "" : design_prefix, found[1].str()),
        "stop.half_width_percent=" + found[3].str()};
    if (found[2].matched) settings.push_back("stop.exposure_h=" + found[2].str());
    settings.push_back(fmt::format("campaign.arrangements={}", most_until));
    return settings;
}

}  // namespace floes
