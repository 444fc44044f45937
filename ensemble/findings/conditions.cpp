#include "findings/conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/units.hpp"

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

std::string part_words(const ProfilePoint& lower, const ProfilePoint& upper) {
    const double angle = std::atan2(upper.height - lower.height, std::abs(upper.radius - lower.radius)) / unit::degree;
    return fmt::format("{:.1f}° from the horizontal (radius {:.3f} m at {:+.3f} m to {:.3f} m at {:+.3f} m)", angle,
                       lower.radius, lower.height, upper.radius, upper.height);
}

}  // namespace

std::string wall_words(const std::vector<ProfilePoint>& profile) {
    std::vector<std::string> parts;
    for (std::size_t i = 1; i < profile.size(); ++i) parts.push_back(part_words(profile[i - 1], profile[i]));
    return fmt::format("{}{}", parts.size() == 1 ? "straight, " : "", fmt::join(parts, ", then "));
}

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
        summary, "Structure wall", [](const CaseRow& row) { return wall_words(row.profile); }, lines);
    add_condition(
        summary, "Far end", [](const CaseRow& row) { return far_end_words(row.far_end); }, lines);
    add_condition(
        summary, "Contact Γ", [](const CaseRow& row) { return fmt::format("{}", row.contact_erp); }, lines);
    add_condition(
        summary, "Load measured", [](const CaseRow& row) { return window_words(row.analysis); }, lines);
    return lines;
}

std::vector<ConditionColumn> condition_columns(const Summary& summary) {
    std::size_t points = 0;  // largest number in any case
    for (const CaseSummary& row : summary.cases) points = std::max(points, row.about.profile.size());
    std::vector<ConditionColumn> columns;
    for (std::size_t k = 0; k < points; ++k) {
        for (const auto& [place, field] : {std::pair{0, &ProfilePoint::height}, {1, &ProfilePoint::radius}})
            columns.push_back({Names{"", fmt::format("conditions/structure_profile_m/{}/{}", k, place)},
                               [k, field](const CaseRow& about) {
                                   return k < about.profile.size() ? Datum(about.profile[k].*field) : Datum(Absent{});
                               }});
    }
    const auto add = [&](const std::string& name, auto value) {
        columns.push_back(
            {Names{name, "conditions/" + name}, [value](const CaseRow& about) { return Datum(value(about)); }});
    };
    columns.push_back({Names{"structure_wall", ""}, [](const CaseRow& about) { return wall_words(about.profile); }});
    add("far_end", [](const CaseRow& about) { return far_end_key(about.far_end); });
    add("contact_erp", [](const CaseRow& about) { return about.contact_erp; });
    add("steady_start_s", [](const CaseRow& about) { return about.analysis.steady_start; });
    add("window_s", [](const CaseRow& about) { return about.analysis.window; });
    add("segments", [](const CaseRow& about) { return about.analysis.segments; });
    return columns;
}

}  // namespace floes
