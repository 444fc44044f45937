#include "findings/conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace floes {

namespace {

// Appends "NAME: words." or, where the cases differ, "NAME: words (case, case)." for each wording in order of
// appearance.
void add_condition(const Summary& summary, std::string_view name,
                   const std::function<std::string(const CaseRow&)>& words, std::vector<std::string>& lines) {
    std::vector<std::pair<std::string, std::vector<std::string>>> wordings;
    for (const CaseSummary& row : summary.cases) {
        const std::string wording = words(row.about);
        auto found = std::ranges::find(wordings, wording, &decltype(wordings)::value_type::first);
        if (found == wordings.end()) found = wordings.insert(found, {wording, {}});
        found->second.push_back(row.about.name);
    }
    for (const auto& [wording, cases] : wordings) {
        lines.push_back(wordings.size() == 1 ? fmt::format("{}: {}.", name, wording)
                                             : fmt::format("{}: {} ({}).", name, wording, fmt::join(cases, ", ")));
    }
}

}  // namespace

std::string far_end_words(FarEnd far_end) {
    return far_end == FarEnd::ice_sheet ? "an ice sheet" : "open";
}

std::string window_words(const Analysis& analysis) {
    return fmt::format("{} to {} s after the tow began, in {} segments", analysis.steady_start,
                       analysis.steady_start + analysis.window, analysis.segments);
}

std::string far_end_key(FarEnd far_end) {
    return far_end == FarEnd::ice_sheet ? "ice_sheet" : "open";
}

std::vector<std::string> condition_lines(const Summary& summary) {
    std::vector<std::string> lines;
    add_condition(
        summary, "Structure wall", [](const CaseRow& row) { return row.shape.words(); }, lines);
    add_condition(
        summary, "Far end", [](const CaseRow& row) { return far_end_words(row.far_end); }, lines);
    add_condition(
        summary, "Contact Γ", [](const CaseRow& row) { return fmt::format("{}", row.contact_erp); }, lines);
    add_condition(
        summary, "Load measured", [](const CaseRow& row) { return window_words(row.analysis); }, lines);
    return lines;
}

}  // namespace floes
