#include "findings/conditions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <ranges>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/design_points.hpp"
#include "scenario/keys.hpp"
#include "scenario/scenario.hpp"

namespace floes {

namespace {

// Appends "NAME: words." or, where the cases differ, "NAME: words (case, case)." for each wording in order of
// appearance.
void add_condition(const Summary& summary, std::string_view name, const std::function<Words(const CaseRow&)>& words,
                   std::vector<std::string>& lines) {
    constexpr std::size_t most_wordings = 4;
    const auto wordings = grouped(summary.cases.size(), [&](std::size_t k) { return words(summary.cases[k].about); });
    if (wordings.size() > most_wordings) {
        std::vector<Words> all;
        for (const auto& [wording, cases] : wordings) all.push_back(wording);
        if (const std::optional<Words> ranges = Words::with_ranges(all)) {
            lines.push_back(fmt::format("{}: {}, by case.", name, ranges->text()));
            return;
        }
        lines.push_back(fmt::format("{}: {} different ones, as {} ({}).", name, wordings.size(),
                                    wordings.front().first.text(), label_list(summary, wordings.front().second)));
        return;
    }
    for (const auto& [wording, cases] : wordings)
        lines.push_back(wordings.size() == 1
                            ? fmt::format("{}: {}.", name, wording.text())
                            : fmt::format("{}: {} ({}).", name, wording.text(), label_list(summary, cases)));
}

/// The word of an enumerator.
template <class Enum, std::size_t count>
std::string_view word(const std::array<std::string_view, count>& words, Enum value) {
    return words.at(static_cast<std::size_t>(value));
}

/// In the order of FieldSides.
constexpr std::array<std::string_view, 3> side_words{"between ice sheets", "open at its sides", "between smooth walls"};

/// In the order of FarEnd: for people, and as the configuration has them.
constexpr std::array<std::string_view, 3> far_end_words{"an ice sheet", "open",
                                                        "none: ice comes from ahead as long as the run lasts"};
constexpr std::array<std::string_view, 3> far_end_keys{"ice_sheet", "open", "never"};

/// "2.5 m wide (2.0 times the hull), field 4.61 m long, between ice sheets that press with 20 N/m".
Words channel_words(const CaseRow& row) {
    const double width = 2 * row.field.half_width;
    Words words =
        Words::of("{:.4g} m wide ({:.1f} times the hull at the waterline), field {:.3g} m long, {}", width,
                  0.5 * width / row.shape.waterline_radius(), row.field_length, word(side_words, row.field.sides));
    if (row.field.confining > 0) words += Words::of("; its sheets press with {:.4g} N/m", row.field.confining);
    return words;
}

Words gap_words(const CaseRow& row) {
    if (!row.gap) return "none, as the sides are open or the structure goes along a path";
    return Words::of("{:.3g} m between the structure and the bank, {:.3g} sides of a floe", row.gap->breadth,
                     row.gap->floes);
}

Words direction_words(double speed, double direction) {
    return Words::of("{:.3g} m/s towards {:.0f}°", speed, direction / unit::degree);
}

/// "current 0.1 m/s towards 90°, wind 5 m/s towards 0°"; directions from the tow's, towards +z.
Words drift_words(const CaseRow& row) {
    Words words;
    if (const double current = row.current.norm(); current > 0)
        words = Words("current ") + direction_words(current, std::atan2(row.current.y(), row.current.x()));
    if (row.wind.speed > 0)
        words += Words(words.empty() ? "wind " : ", wind ") + direction_words(row.wind.speed, row.wind.direction);
    return words.empty() ? Words("none") : words;
}

bool has_beam_joints(const CaseRow& row) {
    return std::isnan(row.cfm);
}

Words joint_words(const CaseRow& row) {
    if (!has_beam_joints(row)) return "they follow Σ";
    return Words::of("elastic beams, solved exactly; they fail by {}",
                     row.joint.fails_by_stress() ? "the stress in the ice" : "moment");
}

/// "for 150 s, from 80 s after the tow began, in 3 segments": clear, too, where cases differ in both.
Words window_words(const Analysis& analysis) {
    return Words::of("for {} s, from {} s after the tow began, in {}", analysis.window, analysis.steady_start,
                     Words::counted(analysis.segments, "segment"));
}

/// ", friction of floes by a power of the speed", or nothing where friction does not know the speed.
std::string slip_words(const char* surfaces, SlipEffect effect) {
    switch (effect) {
        case SlipEffect::constant:
            return {};
        case SlipEffect::power:
            return fmt::format(", friction {} by a power of the speed", surfaces);
        case SlipEffect::rate_and_state:
            return fmt::format(", friction {} by rate and state", surfaces);
    }
    return {};
}

}  // namespace

Words contact_words(const ContactLaw& law) {
    Words words;
    const ContactPreset preset = preset_of(law);
    if (preset != ContactPreset::own) words = Words::of("preset {}, ", word(preset_words, preset));
    words += law.friction == Friction::cone ? "friction in the contact plane, " : "friction in one direction, ";
    words += law.normal == NormalLaw::rigid
                 ? Words::of("rigid with Γ {}", law.erp)
                 : Words::of("crushing at {:.4g} kPa", law.crushing_pressure / unit::kilopascal);
    if (preset == ContactPreset::own) words += law.internal_edges ? ", internal edges act" : ", no internal edges";
    words += slip_words("of floes", law.slip.ice_ice);
    words += slip_words("on the structure", law.slip.ice_structure);
    return words;
}

namespace {

/// Says of the default hull that it is one, which a campaign file does not tell; not of comparisons with the paper.
Words hull_words(const CaseRow& row) {
    static const Shape usual;
    const bool of_paper = preset_of(row.contact) == ContactPreset::paper;
    return row.shape.words() +
           (row.shape == usual && !of_paper ? "; the paper's cone, which is towed where no hull is stated" : "");
}

}  // namespace

std::vector<std::string> condition_lines(const Summary& summary) {
    using Row = const CaseRow&;
    std::vector<std::string> lines;
    const auto add = [&](std::string_view name, const auto& words) { add_condition(summary, name, words, lines); };
    const auto any = [&](const auto& has) {
        return std::ranges::any_of(summary.cases, [&](const CaseSummary& row) { return has(row.about); });
    };
    if (!any([](Row row) { return row.floes.empty(); })) {
        add("Ice", [](Row row) { return row.floes; });
        add("Structure", [](Row row) { return row.motion; });
    }
    add("Structure wall", hull_words);
    if (!any([](Row row) { return !(row.field_length > 0); })) add("Channel", channel_words);
    if (any([](Row row) { return row.gap.has_value(); })) add("Gap", gap_words);
    add("Far end", [](Row row) { return std::string(word(far_end_words, row.far_end)); });
    if (any([](Row row) { return !(drift_words(row) == "none"); })) add("Drift", drift_words);
    if (any(has_beam_joints)) add("Joints", joint_words);
    add("Contacts", [](Row row) { return contact_words(row.contact); });
    add("Load measured", [](Row row) { return window_words(row.analysis); });
    return lines;
}

std::vector<Condition> conditions() {
    using Row = const CaseRow&;
    return {{"structure_wall", [](Row row) { return Datum(row.shape.words().text()); }},
            {"gap", [](Row row) { return row.gap ? Datum(row.gap->breadth) : Datum(Absent{}); }},
            {"gap_floes", [](Row row) { return row.gap ? Datum(row.gap->floes) : Datum(Absent{}); }},
            {"far_end", [](Row row) { return Datum(word(far_end_keys, row.far_end)); }},
            {"contact_erp", [](Row row) { return Datum(row.contact.erp); }},
            {"friction", [](Row row) { return Datum(word(friction_words, row.contact.friction)); }},
            {"contact_law", [](Row row) { return Datum(word(normal_law_words, row.contact.normal)); }},
            {"internal_edges", [](Row row) { return Datum(row.contact.internal_edges); }},
            {"crushing_pressure_kPa",
             [](Row row) {
                 return row.contact.normal == NormalLaw::crushing
                            ? Datum(row.contact.crushing_pressure / unit::kilopascal)
                            : Datum(Absent{});
             }},
            {"steady_start", [](Row row) { return Datum(row.analysis.steady_start); }},
            {"window", [](Row row) { return Datum(row.analysis.window); }},
            {"segments", [](Row row) { return Datum(row.analysis.segments); }}};
}

namespace {

std::string value_of(const Key& key) {
    const std::string text = literal(key);
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

/// A key in which cases differ.
struct VariedKey {
    std::string path;
    std::vector<std::string> values;                                       ///< in each case; empty without an effect
    std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;  ///< each value once, with its cases
};

/// Lists and profiles are left to the conditions, which draw or name them.
std::vector<VariedKey> varied_keys(const Campaign& campaign) {
    std::vector<VariedKey> all;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        Scenario scenario = campaign.cases[k].scenario;
        std::size_t place = 0;
        for (const Key& key : describe(scenario)) {
            if (key.derived() || key.replaced || std::holds_alternative<RowsField>(key.field)) continue;
            if (k == 0) all.push_back({std::string(key.path), {}, {}});
            all.at(place++).values.push_back(key.idle() ? std::string{} : value_of(key));
        }
    }
    for (VariedKey& one : all) {
        one.groups = grouped(one.values.size(), [&](std::size_t k) { return one.values[k]; });
        std::erase_if(one.groups, [](const auto& group) { return group.first.empty(); });
    }
    std::erase_if(all, [](const VariedKey& one) { return one.groups.size() < 2; });
    return all;
}

/// The name of a key with its table before it where the name alone does not say of what: "sizes law", "wind speed".
std::string full_name(std::string_view path) {
    constexpr std::array<std::string_view, 6> understood{"ice", "floe", "structure", "field", "general", "analysis"};
    const std::string_view table = path.substr(0, path.find('.'));
    const std::string name = key_words(path).name;
    const bool of_contact = table == "contact" && name.starts_with("ice-");
    if (of_contact || path == "joint.cfm" || std::ranges::find(understood, table) != understood.end()) return name;
    return fmt::format("{} {}", table, name);
}

std::string variation_line(const VariedKey& key, const Summary& summary) {
    constexpr std::size_t most = 6;
    const std::string unit = key_words(key.path).unit;
    std::vector<std::string> parts;
    for (const auto& [value, cases] : key.groups | std::views::take(most))
        parts.push_back(fmt::format("{}{} ({})", value, unit.empty() ? "" : " " + unit, label_list(summary, cases)));
    if (key.groups.size() > most) parts.push_back(fmt::format("and {} other values", key.groups.size() - most));
    return fmt::format("Varies: {} {}.", full_name(key.path), fmt::join(parts, ", "));
}

std::string design_line(const Campaign& campaign) {
    const DesignPoints points = find_points(campaign);
    const std::vector<KeyWords> words = axis_words(points);
    std::vector<std::string> parts;
    for (std::size_t axis = 0; axis < words.size(); ++axis) {
        std::vector<double> numbers;
        for (const PointRow& row : points.rows)
            if (const auto* value = std::get_if<double>(&row.values[axis])) numbers.push_back(*value);
        const auto texts =
            grouped(points.rows.size(), [&](std::size_t k) { return value_text(points.rows[k].values[axis]); });
        parts.push_back(words[axis].with(numbers.empty() ? fmt::format("{}", fmt::join(std::views::keys(texts), " or "))
                                                         : range_text(numbers)));
    }
    return fmt::format("Varies over the {} of the design: {}.", counted(std::ssize(points.rows), "point"),
                       fmt::join(parts, ", "));
}

}  // namespace

bool VariedInput::numeric() const {
    return std::ranges::all_of(values, [](const auto& value) {
        const auto* words = std::get_if<std::string>(&value);
        return words == nullptr || words->empty();
    });
}

std::vector<VariedInput> varied_inputs(const Campaign& campaign) {
    std::vector<VariedInput> inputs;
    if (campaign.design.active()) {
        const DesignPoints points = find_points(campaign);
        const std::vector<KeyWords> words = axis_words(points);
        for (std::size_t axis = 0; axis < points.keys.size(); ++axis) {
            VariedInput& input = inputs.emplace_back(VariedInput{points.keys[axis], words[axis]});
            input.logarithmic = points.scales[axis] == AxisScale::log;
            for (const PointRow& row : points.rows) input.values.push_back(row.values[axis]);
        }
        return inputs;
    }
    for (const VariedKey& key : varied_keys(campaign)) {
        VariedInput& input =
            inputs.emplace_back(VariedInput{key.path, {full_name(key.path), key_words(key.path).unit}});
        for (const std::string& text : key.values) {
            double number = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            if (error == std::errc{} && end == text.data() + text.size())
                input.values.emplace_back(number);
            else
                input.values.emplace_back(text);
        }
    }
    return inputs;
}

std::string range_text(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return least == most ? fmt::format("{:.4g}", least) : fmt::format("{:.4g} to {:.4g}", least, most);
}

std::vector<std::string> variation_lines(const Campaign& campaign, const Summary& summary) {
    constexpr std::size_t most = 8;
    if (campaign.cases.size() < 2) return {};
    if (campaign.design.active()) return {design_line(campaign)};
    std::vector<std::string> lines;
    const std::vector<VariedKey> all = varied_keys(campaign);
    for (const VariedKey& key : all | std::views::take(most)) lines.push_back(variation_line(key, summary));
    if (all.size() > most) lines.push_back(fmt::format("And {} further keys vary.", all.size() - most));
    return lines;
}

}  // namespace floes
