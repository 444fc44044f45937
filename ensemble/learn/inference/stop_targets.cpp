// Which means, or differences of means, the stop rule is about.

#include <fmt/format.h>

#include <algorithm>

#include "campaign/name_list.hpp"
#include "core/error.hpp"
#include "inference/precision_stop.hpp"

namespace floes {
namespace {

int index_of(const std::string& name, const std::vector<std::string>& cases, const char* key) {
    const auto found = std::ranges::find(cases, name);
    if (found == cases.end()) {
        throw InputError(
            fmt::format("stop.{} names the case '{}', but the cases are {}.", key, name, name_list(cases)));
    }
    return static_cast<int>(found - cases.begin());
}

}  // namespace

std::vector<PrecisionStop::Target> PrecisionStop::targets_of(const StopRule& rule,
                                                             const std::vector<std::string>& cases,
                                                             const std::vector<int>& groups) {
    std::vector<Target> targets;
    const int count = static_cast<int>(cases.size());
    const auto share = [&](int one, int other) {
        return groups.empty() || groups.at(static_cast<std::size_t>(one)) == groups.at(static_cast<std::size_t>(other));
    };
    const auto no_pair = [&](const std::string& which) {
        return InputError(
            fmt::format("stop.contrast = \"{}\" asks for a paired difference, but {} do not share their arrangements: "
                        "cases can be paired if their fields have the same geometry and "
                        "campaign.common_arrangements is true.",
                        rule.contrast, which));
    };
    if (rule.case_name == "all") {
        for (int one = 0; one < count; ++one) targets.push_back({.case_index = one, .minus = {}});
    } else if (rule.case_name != "none") {
        targets.push_back({.case_index = index_of(rule.case_name, cases, "case"), .minus = {}});
    }
    if (rule.contrast == "all") {
        for (int one = 0; one < count; ++one) {
            for (int other = one + 1; other < count; ++other) {
                if (share(one, other)) targets.push_back({.case_index = other, .minus = one});
            }
        }
        const bool any = std::ranges::any_of(targets, [](const Target& target) { return target.minus.has_value(); });
        if (count > 1 && !any) throw no_pair("all cases");
    } else if (rule.contrast != "none") {
        const std::size_t minus = rule.contrast.find(" - ");
        if (minus == std::string::npos) {
            throw InputError(fmt::format(
                "stop.contrast = \"{}\" is not a contrast; write \"none\", \"all\", or two cases as in \"{} - {}\".",
                rule.contrast, cases.back(), cases.front()));
        }
        const int second = index_of(rule.contrast.substr(0, minus), cases, "contrast");
        const int first = index_of(rule.contrast.substr(minus + 3), cases, "contrast");
        if (!share(first, second)) throw no_pair("these two");
        targets.push_back({.case_index = second, .minus = first});
    }
    if (targets.empty()) {
        throw InputError(
            "stop.half_width_percent is given without stop.case or stop.contrast, which say what it applies to; write "
            "stop.case = \"all\".");
    }
    return targets;
}

}  // namespace floes
