#include "campaign/stop_rule.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

int index_of(const std::string& name, const std::vector<std::string>& cases, const char* key) {
    const auto found = std::ranges::find(cases, name);
    if (found == cases.end())
        throw InputError("stop.{} names the case '{}', but the cases are {}", key, name, name_list(cases));
    return static_cast<int>(found - cases.begin());
}

}  // namespace

std::optional<int> stop_case(const StopRule& rule, const std::vector<std::string>& cases) {
    if (rule.case_name == "all" || rule.case_name == "none") return {};
    return index_of(rule.case_name, cases, "case");
}

std::optional<StopPair> stop_pair(const StopRule& rule, const std::vector<std::string>& cases,
                                  const std::vector<int>& groups) {
    const bool none = rule.contrast == "none" || (rule.contrast == "all" && cases.size() < 2);
    if (none && rule.case_name == "none" && rule.active())
        throw InputError(
            "stop.half_width_percent is given without stop.case or stop.contrast, which say what it applies to; write "
            "stop.case = \"all\"");
    if (rule.contrast == "all" || rule.contrast == "none") return {};
    const std::size_t minus = rule.contrast.find(" - ");
    if (minus == std::string::npos)
        throw InputError(
            "stop.contrast = \"{}\" is not a contrast; write \"none\", \"all\", or two cases as in \"{} - {}\"",
            rule.contrast, cases.back(), cases.front());
    const StopPair pair{index_of(rule.contrast.substr(0, minus), cases, "contrast"),
                        index_of(rule.contrast.substr(minus + 3), cases, "contrast")};
    const auto group = [&](int one) { return groups.empty() ? 0 : groups.at(static_cast<std::size_t>(one)); };
    if (group(pair.of) != group(pair.minus)) throw no_stop_pair(rule, "these two");
    return pair;
}

InputError no_stop_pair(const StopRule& rule, const std::string& which) {
    return InputError(
        "stop.contrast = \"{}\" asks for a paired difference, but {} do not share their arrangements: cases can be "
        "paired if their fields have the same geometry and campaign.common_arrangements is true",
        rule.contrast, which);
}

std::optional<StopFault> stop_case_fault(const Campaign& campaign) {
    const StopRule& rule = campaign.stop;
    const std::vector<std::string> names = case_names(campaign);
    const char* key = "stop.case";
    try {
        stop_case(rule, names);
        key = "stop.contrast";
        const std::optional<StopPair> pair = stop_pair(rule, names, sharing_groups(campaign));
        if (!pair || case_fingerprint(campaign, pair->of) != case_fingerprint(campaign, pair->minus)) return {};
        return StopFault{key,
                         fmt::format("stop.contrast = \"{}\" is 0 in every arrangement, because {}; name two cases "
                                     "that differ",
                                     rule.contrast,
                                     pair->of == pair->minus ? "it is a case less itself"
                                                             : "the two cases differ by their names alone")};
    } catch (const InputError& error) {
        return StopFault{key, error.what()};
    }
}

}  // namespace floes
