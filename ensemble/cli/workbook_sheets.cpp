#include "cli/workbook_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "findings/catalogue.hpp"
#include "records/build_info.hpp"

namespace floes {
namespace {

/// What a sheet is called: the points of a design are its sheet "design", and design loads say that they are loads.
std::string sheet_name(std::string_view part) {
    if (part == "points") return "design";
    return part == "design" ? "design loads" : std::string(part);
}

/// Parts in the order of their sheets, and what a sheet holds.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kinds{{
    {"cases",
     "a line for each case: means over arrangements with their 95 % intervals: _low and _high by "
     "Student's t, _bca_ by bootstrap, _prediction_ of one further run"},
    {"members", "a line for each simulation"},
    {"pairs", "differences of two cases within the same arrangements, with their 95 % intervals and tests"},
    {"points", "the points of the design with their results"},
    {"long", "a line for each value of each simulation"},
    {"design", "the largest load in an exposure"},
    {"sensitivity", "which keys decide the load"},
    {"extremes", "fits of the maxima, and return levels"},
    {"exceedance", "how often maxima exceed a load"},
    {"fatigue", "rainflow cycles, equivalent ranges, and time above levels"},
    {"moored", "a hull on moorings: offset, mooring force and amplification, and these over its natural period"},
    {"steady", "when the load became steady"},
    {"energy", "where the work of the tow goes, over the distance towed"},
    {"parts", "loads on the parts of the hull"},
    {"moments", "moments on the hull about its axis at the waterline"},
}};

auto kind_of(std::string_view part) {
    return std::ranges::find(kinds, part, [](const auto& one) { return one.first; });
}

std::string_view about(std::string_view part) {
    const auto* found = kind_of(part);
    return found == kinds.end() ? "" : found->second;
}

bool is_wanted(const Finding& finding, const std::vector<std::string>& parts, const Campaign& campaign) {
    if (!parts.empty()) return std::ranges::find(parts, finding.name) != parts.end();
    if (finding.name == "pairs") return campaign.cases.size() > 1 && finding.unasked(campaign);
    return finding.name == "cases" || finding.name == "members" ||
           (finding.name == "points" && campaign.design.active());
}

bool has_columns(const DataRows& records) {
    return std::ranges::any_of(records.names, [](const Names& one) { return !one.csv.empty(); });
}

}  // namespace

std::vector<Sheet> workbook_sheets(Evidence& evidence, const std::vector<std::string>& parts) {
    using Line = std::pair<std::string, std::string>;
    std::vector<Line> contents{{"campaign", evidence.table.title}, {"made by", "floes " + floes_version()}};
    std::vector<Sheet> sheets;
    std::vector<Finding> wanted;
    for (const Finding& finding : findings())
        if (!finding.name.empty() && is_wanted(finding, parts, evidence.campaign)) wanted.push_back(finding);
    std::ranges::stable_sort(wanted, {}, [](const Finding& one) { return kind_of(one.name); });
    for (const Finding& finding : wanted) {
        std::size_t of_this = 0;
        for (Section& section : finding.sections(evidence))
            for (DataRows& records : section.records) {
                if (!has_columns(records)) continue;
                const std::string name = sheet_name(finding.name);
                sheets.push_back({++of_this == 1 ? name : fmt::format("{} {}", name, of_this), std::move(records)});
                contents.emplace_back(sheets.back().name, of_this == 1 ? about(finding.name) : "");
            }
    }
    contents.emplace_back("units", "stand at the end of a column's name; 1 is a share, not percent");
    sheets.insert(sheets.begin(),
                  {"contents", make_rows<Line>("", contents,
                                               {{"sheet", [](const Line& one) { return one.first; }},
                                                {"holds", [](const Line& one) { return one.second; }}})});
    return sheets;
}

}  // namespace floes
