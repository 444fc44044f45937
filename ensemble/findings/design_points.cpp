#include "findings/design_points.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "keys/key.hpp"
#include "scenario/keys.hpp"

namespace floes {

/// Ends of names and what they mean, longer ones before those that end like them.
constexpr auto units = std::to_array<std::pair<std::string_view, std::string_view>>({{"_kN_m_rad", "kN m/rad"},
                                                                                     {"_kN_s2_m2", "kN s²/m²"},
                                                                                     {"_kN_m_s2", "kN m s²"},
                                                                                     {"_kN_m", "kN/m"},
                                                                                     {"_N_m", "N/m"},
                                                                                     {"_kN", "kN"},
                                                                                     {"_N", "N"},
                                                                                     {"_t_m2", "t m²"},
                                                                                     {"_t", "t"},
                                                                                     {"_kg_m3", "kg/m³"},
                                                                                     {"_J_m2", "J/m²"},
                                                                                     {"_mm_s", "mm/s"},
                                                                                     {"_m_s2", "m/s²"},
                                                                                     {"_m_s", "m/s"},
                                                                                     {"_percent", "%"},
                                                                                     {"_kPa", "kPa"},
                                                                                     {"_MPa", "MPa"},
                                                                                     {"_MiB", "MiB"},
                                                                                     {"_deg", "°"},
                                                                                     {"_s", "s"},
                                                                                     {"_m", "m"}});

std::string capital(std::string sentence) {
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    return sentence;
}

KeyWords key_words(std::string_view key) {
    const std::size_t dot = key.find('.');
    std::string_view name = dot == std::string_view::npos ? key : key.substr(dot + 1);
    KeyWords words;
    for (const auto& [end, unit] : units) {
        if (!name.ends_with(end)) continue;
        name.remove_suffix(end.size());
        const bool moment = unit == "kN/m" && (name.ends_with("friction") || name.ends_with("limit"));
        words.unit = moment ? "kN m" : unit;
        break;
    }
    words.name = name == "cfm" ? "Σ" : std::string(name);
    std::ranges::replace(words.name, '_', ' ');
    if (words.name.starts_with("ice ")) words.name[3] = '-';  // between two bodies
    return words;
}

namespace {

std::variant<double, std::string> value_of(const Case& of_case, const DesignAxis& axis) {
    if (axis.numeric) return numeric_value(of_case, axis.key);
    Scenario scenario = of_case.scenario;
    const Keys keys = describe(scenario);
    const std::string text = literal(*find_key(keys, axis.key));
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

double on_scale(double value, AxisScale scale) {
    return scale == AxisScale::log ? std::log(value) : value;
}

}  // namespace

double RangedAxis::coordinate(double value) const {
    const double low = on_scale(from, scale);
    const double high = on_scale(to, scale);
    return high > low ? 2 * (on_scale(value, scale) - low) / (high - low) - 1 : 0;
}

double RangedAxis::value(double coordinate) const {
    const double low = on_scale(from, scale);
    const double on = low + (coordinate + 1) / 2 * (on_scale(to, scale) - low);
    return scale == AxisScale::log ? std::exp(on) : on;
}

RangedAxis ranged_axis(const Campaign& campaign, const DesignAxis& axis) {
    RangedAxis made{axis.key, axis.from, axis.to, axis.scale, axis.whole};
    if (campaign.design.has_ranges()) return made;
    std::vector<double> values;
    for (const Case& one : campaign.cases) values.push_back(numeric_value(one, axis.key));
    const auto [least, most] = std::ranges::minmax(values);
    made.from = least;
    made.to = most;
    return made;
}

std::string value_text(const std::variant<double, std::string>& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? fmt::format("{:.4g}", *number) : std::get<std::string>(value);
}

DesignPoints find_points(const Campaign& campaign) {
    DesignPoints points;
    if (!campaign.design.active()) return points;
    for (const DesignAxis& axis : campaign.design.axes) {
        points.keys.push_back(axis.key);
        points.scales.push_back(axis.scale);
    }
    for (const Case& of_case : campaign.cases) {
        PointRow& row = points.rows.emplace_back(PointRow{of_case.name, of_case.base, of_case.point, {}});
        for (const DesignAxis& axis : campaign.design.axes) row.values.push_back(value_of(of_case, axis));
    }
    return points;
}

std::vector<KeyWords> axis_words(const DesignPoints& points) {
    std::vector<KeyWords> words;
    for (const std::string& key : points.keys) words.push_back(key_words(key));
    std::vector<KeyWords> told = words;
    for (std::size_t k = 0; k < words.size(); ++k)
        if (std::ranges::count(words, words[k].name, &KeyWords::name) > 1)
            told[k].name = points.keys[k].substr(0, points.keys[k].find('.')) + " " + words[k].name;
    return told;
}

std::vector<std::string> point_labels(const DesignPoints& points) {
    const std::vector<KeyWords> words = axis_words(points);
    std::vector<std::string> labels;
    for (const PointRow& row : points.rows) {
        std::string& label = labels.emplace_back(row.base.empty() ? "" : row.base + ": ");
        for (std::size_t k = 0; k < words.size(); ++k)
            label += (k == 0 ? "" : ", ") + words[k].with(value_text(row.values[k]));
    }
    return labels;
}

bool in_detail(const Campaign& campaign) {
    constexpr std::size_t few = 12;
    return !campaign.design.active() || campaign.cases.size() <= few;
}

}  // namespace floes
