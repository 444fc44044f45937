#include "findings/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "campaign/name_list.hpp"
#include "core/units.hpp"
#include "core/wording.hpp"
#include "scenario/contact_preset.hpp"

namespace floes {

namespace {

// Appends "NAME: words." or, where the cases differ, "NAME: words (case, case)." for each wording in order of
// appearance.
void add_condition(const Summary& summary, std::string_view name,
                   const std::function<std::string(const CaseRow&)>& words, std::vector<std::string>& lines) {
    std::vector<std::pair<std::string, std::vector<std::string>>> wordings;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const std::string wording = words(summary.cases[k].about);
        auto found = std::ranges::find(wordings, wording, &decltype(wordings)::value_type::first);
        if (found == wordings.end()) found = wordings.insert(found, {wording, {}});
        found->second.push_back(summary.label_of(k));
    }
    constexpr std::size_t most_wordings = 4;
    if (wordings.size() > most_wordings) {
        lines.push_back(fmt::format("{}: {} different ones, as {} ({}).", name, wordings.size(), wordings.front().first,
                                    name_list(wordings.front().second)));
        return;
    }
    for (const auto& [wording, cases] : wordings) {
        lines.push_back(wordings.size() == 1 ? fmt::format("{}: {}.", name, wording)
                                             : fmt::format("{}: {} ({}).", name, wording, name_list(cases)));
    }
}

/// The word of an enumerator.
template <class Enum, std::size_t count>
std::string_view word(const std::array<std::string_view, count>& words, Enum value) {
    return words.at(static_cast<std::size_t>(value));
}

/// "2.5 m wide (2.0 times the hull), field 4.61 m long, between ice sheets that press with 20 N/m".
std::string channel_words(const CaseRow& row) {
    const double width = 2 * row.field.half_width;
    std::string words = fmt::format("{:.4g} m wide ({:.1f} times the hull at the waterline), field {:.3g} m long, {}",
                                    width, 0.5 * width / row.shape.waterline_radius(), row.field_length,
                                    row.field.sides == FieldSides::open ? "open at its sides" : "between ice sheets");
    if (row.field.confining > 0) words += fmt::format("; its sheets press with {:.4g} N/m", row.field.confining);
    return words;
}

std::string direction_words(double speed, double direction) {
    return fmt::format("{:.3g} m/s towards {:.0f}°", speed, direction / unit::degree);
}

/// "current 0.1 m/s towards 90°, wind 5 m/s towards 0°"; directions from the tow's, towards +z.
std::string drift_words(const CaseRow& row) {
    std::string words;
    if (const double current = row.current.norm(); current > 0)
        words = "current " + direction_words(current, std::atan2(row.current.y(), row.current.x()));
    if (row.wind.speed > 0)
        words += (words.empty() ? "wind " : ", wind ") + direction_words(row.wind.speed, row.wind.direction);
    return words.empty() ? "none" : words;
}

bool has_beam_joints(const CaseRow& row) {
    return std::isnan(row.cfm);
}

std::string joint_words(const CaseRow& row) {
    if (!has_beam_joints(row)) return "they follow Σ";
    return fmt::format("elastic beams, solved exactly; they fail by {}",
                       row.joint.fails_by_stress() ? "the stress in the ice" : "moment");
}

}  // namespace

std::string far_end_words(FarEnd far_end) {
    if (far_end == FarEnd::never) return "none: ice comes from ahead as long as the run lasts";
    return far_end == FarEnd::ice_sheet ? "an ice sheet" : "open";
}

std::string contact_words(const ContactLaw& law) {
    std::string words;
    const ContactPreset preset = preset_of(law);
    if (preset != ContactPreset::own) words = fmt::format("preset {}, ", word(preset_words, preset));
    words += law.friction == Friction::cone ? "friction in the contact plane, " : "friction in one direction, ";
    words += law.normal == NormalLaw::rigid
                 ? fmt::format("rigid with Γ {}", law.erp)
                 : fmt::format("crushing at {:.4g} kPa", law.crushing_pressure / unit::kilopascal);
    if (preset == ContactPreset::own) words += law.internal_edges ? ", internal edges act" : ", no internal edges";
    return words;
}

bool has_rigid_contacts(const Summary& summary) {
    return std::ranges::any_of(summary.cases,
                               [](const CaseSummary& row) { return row.about.contact.normal == NormalLaw::rigid; });
}

std::string window_words(const Analysis& analysis) {
    return fmt::format("{} to {} s after the tow began, in {}", analysis.steady_start,
                       analysis.steady_start + analysis.window, counted(analysis.segments, "segment"));
}

std::string far_end_key(FarEnd far_end) {
    if (far_end == FarEnd::never) return "never";
    return far_end == FarEnd::ice_sheet ? "ice_sheet" : "open";
}

std::vector<std::string> condition_lines(const Summary& summary) {
    std::vector<std::string> lines;
    add_condition(
        summary, "Structure wall", [](const CaseRow& row) { return row.shape.words(); }, lines);
    if (std::ranges::all_of(summary.cases, [](const CaseSummary& row) { return row.about.field_length > 0; }))
        add_condition(summary, "Channel", channel_words, lines);
    add_condition(
        summary, "Far end", [](const CaseRow& row) { return far_end_words(row.far_end); }, lines);
    if (std::ranges::any_of(summary.cases, [](const CaseSummary& row) { return drift_words(row.about) != "none"; }))
        add_condition(summary, "Drift", drift_words, lines);
    if (std::ranges::any_of(summary.cases, [](const CaseSummary& row) { return has_beam_joints(row.about); })) {
        add_condition(summary, "Joints", joint_words, lines);
    }
    add_condition(
        summary, "Contacts", [](const CaseRow& row) { return contact_words(row.contact); }, lines);
    add_condition(
        summary, "Load measured", [](const CaseRow& row) { return window_words(row.analysis); }, lines);
    return lines;
}

std::vector<ConditionColumn> condition_columns(const Summary& summary) {
    std::size_t rows = 0;  // largest number in any case
    for (const CaseSummary& row : summary.cases) rows = std::max(rows, row.about.shape.profile().size());
    std::vector<ConditionColumn> columns;
    for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t place = 0; place < Shape::columns.size(); ++place)
            columns.push_back({Names{"", fmt::format("conditions/structure_profile_m/{}/{}", k, place)},
                               [k, place](const CaseRow& about) {
                                   const auto shape = about.shape.profile();
                                   return k < shape.size() ? Datum(shape[k].at(place)) : Datum(Absent{});
                               }});
    }
    const auto add = [&](const std::string& name, auto value) {
        columns.push_back(
            {Names{name, "conditions/" + name}, [value](const CaseRow& about) { return Datum(value(about)); }});
    };
    columns.push_back({Names{"structure_wall", ""}, [](const CaseRow& about) { return about.shape.words(); }});
    add("far_end", [](const CaseRow& about) { return far_end_key(about.far_end); });
    add("contact_erp", [](const CaseRow& about) { return about.contact.erp; });
    add("friction", [](const CaseRow& about) { return word(friction_words, about.contact.friction); });
    add("contact_law", [](const CaseRow& about) { return word(normal_law_words, about.contact.normal); });
    add("internal_edges", [](const CaseRow& about) { return about.contact.internal_edges; });
    add("crushing_pressure_kPa", [](const CaseRow& about) {
        return about.contact.normal == NormalLaw::crushing ? Datum(about.contact.crushing_pressure / unit::kilopascal)
                                                           : Datum(Absent{});
    });
    add("steady_start_s", [](const CaseRow& about) { return about.analysis.steady_start; });
    add("window_s", [](const CaseRow& about) { return about.analysis.window; });
    add("segments", [](const CaseRow& about) { return about.analysis.segments; });
    return columns;
}

}  // namespace floes
