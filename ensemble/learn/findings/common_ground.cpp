#include "findings/common_ground.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "campaign/name_list.hpp"
#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/key_words.hpp"
#include "findings/points.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

const char* placing_words(ArrangementMethod method) {
    switch (method) {
        case ArrangementMethod::monte_carlo:
            return "in equilibrium";
        case ArrangementMethod::lattice:
            return "on a jittered lattice";
        case ArrangementMethod::file:
            return "as given in a file";
        case ArrangementMethod::traced:
            return "as traced";
        case ArrangementMethod::scattered:
            break;
    }
    return "scattered at random";
}

template <class Of>
std::string range_over(const Campaign& campaign, const Of& of) {
    std::vector<double> values;
    for (const Case& one : campaign.cases) values.push_back(of(one.scenario));
    return range_text(values);
}

std::string placing_over(const Campaign& campaign) {
    std::vector<std::string> words;
    for (const Case& one : campaign.cases) {
        const std::string own = placing_words(one.scenario.arrangement.method);
        if (std::ranges::find(words, own) == words.end()) words.push_back(own);
    }
    return fmt::format("{}", fmt::join(words, " or "));
}

/// Values of a key, each with the names of its cases, in order of appearance.
using Values = std::vector<std::pair<std::string, std::vector<std::string>>>;

std::string value_of(const Key& key) {
    const std::string text = literal(key);
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

/// Of the keys in which cases differ. Lists and profiles are left to the conditions, which draw or name them.
std::vector<std::pair<std::string, Values>> varied(const Campaign& campaign, const Summary& summary) {
    std::vector<std::pair<std::string, Values>> all;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        Scenario scenario = campaign.cases[k].scenario;
        std::size_t place = 0;
        for (const Key& key : describe(scenario)) {
            if (key.derived() || key.replaced || std::holds_alternative<RowsField>(key.field)) continue;
            if (k == 0) all.emplace_back(std::string(key.path), Values{});
            Values& values = all.at(place++).second;
            const std::string value = value_of(key);
            auto found = std::ranges::find(values, value, &Values::value_type::first);
            if (found == values.end()) found = values.insert(found, {value, {}});
            found->second.push_back(summary.label_of(k));
        }
    }
    std::erase_if(all, [](const auto& one) { return one.second.size() < 2; });
    return all;
}

std::string variation_line(const std::string& path, const Values& values) {
    constexpr std::size_t most = 6;
    const KeyWords words = key_words(path);
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < std::min(values.size(), most); ++k)
        parts.push_back(fmt::format("{}{} ({})", values[k].first, words.unit.empty() ? "" : " " + words.unit,
                                    name_list(values[k].second)));
    if (values.size() > most) parts.push_back(fmt::format("and {} other values", values.size() - most));
    return fmt::format("Varies: {} {}.", words.name, fmt::join(parts, ", "));
}

std::string design_line(const Campaign& campaign) {
    const DesignPoints points = find_points(campaign);
    const std::vector<KeyWords> words = axis_words(points);
    std::vector<std::string> parts;
    for (std::size_t axis = 0; axis < words.size(); ++axis) {
        std::vector<double> numbers;
        std::vector<std::string> texts;
        for (const PointRow& row : points.rows) {
            if (const auto* value = std::get_if<double>(&row.values[axis])) numbers.push_back(*value);
            const std::string text = value_text(row.values[axis]);
            if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
        }
        parts.push_back(
            words[axis].with(numbers.empty() ? fmt::format("{}", fmt::join(texts, " or ")) : range_text(numbers)));
    }
    return fmt::format("Varies over the {} of the design: {}.", counted(std::ssize(points.rows), "point"),
                       fmt::join(parts, ", "));
}

}  // namespace

std::string range_text(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return least == most ? fmt::format("{:.4g}", least) : fmt::format("{:.4g} to {:.4g}", least, most);
}

std::string field_words(const Campaign& campaign) {
    using S = const Scenario&;
    const std::string floes = range_over(campaign, [](S s) { return static_cast<double>(s.field.floes); });
    return fmt::format("{} {} of {} m x {} m x {} m at {} %, {}; structure towed at {} m/s.", floes,
                       floes == "1" ? "floe" : "floes", range_over(campaign, [](S s) { return s.floe.length; }),
                       range_over(campaign, [](S s) { return s.floe.breadth; }),
                       range_over(campaign, [](S s) { return s.floe.thickness; }),
                       range_over(campaign, [](S s) { return s.field.concentration / unit::percent; }),
                       placing_over(campaign), range_over(campaign, [](S s) { return s.structure.speed; }));
}

std::vector<std::string> variation_lines(const Campaign& campaign, const Summary& summary) {
    constexpr std::size_t most = 8;
    if (campaign.cases.size() < 2) return {};
    if (campaign.design.active()) return {design_line(campaign)};
    std::vector<std::string> lines;
    const auto all = varied(campaign, summary);
    for (std::size_t k = 0; k < std::min(all.size(), most); ++k)
        lines.push_back(variation_line(all[k].first, all[k].second));
    if (all.size() > most) lines.push_back(fmt::format("And {} further keys vary.", all.size() - most));
    return lines;
}

}  // namespace floes
