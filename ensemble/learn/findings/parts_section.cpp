#include "findings/parts_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "findings/pressure_area.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

using OfPart = std::function<double(const PartLoad&)>;

std::vector<std::pair<std::string, OfPart>> statistics_of(const Scenario& scenario) {
    std::vector<std::pair<std::string, OfPart>> all{{"mean_N", [](const PartLoad& part) { return part.mean; }},
                                                    {"sd_N", [](const PartLoad& part) { return part.sd; }},
                                                    {"maximum_N", [](const PartLoad& part) { return part.maximum; }}};
    const std::vector<double> times = scenario.averaging_times();
    for (std::size_t k = 0; k < times.size(); ++k)
        all.emplace_back(fmt::format("mean_maximum_{}s_N", times[k]), [k](const PartLoad& part) {
            return k < part.mean_maximum.size() ? part.mean_maximum[k] : std::nan("");
        });
    all.emplace_back("mean_sway_N", [](const PartLoad& part) { return part.mean_sway; });
    all.emplace_back("mean_heave_N", [](const PartLoad& part) { return part.mean_heave; });
    return all;
}

/// In which numbers are shown: a unit, and decimals for the largest of them.
struct Shown {
    LoadUnit unit;
    int decimals;

    explicit Shown(double largest) : unit(load_unit(largest)), decimals(decimals_for(unit.factor * largest)) {}

    std::string with_interval(const Interval& value) const {
        std::string text = fixed(unit.factor * value.estimate, decimals);
        if (std::isfinite(value.high)) text += " ± " + fixed(unit.factor * (value.high - value.estimate), decimals);
        return text;
    }
};

Section section_of_parts(const Evidence& evidence, const std::vector<PartRow>& rows) {
    double largest = 0;
    for (const PartRow& row : rows) largest = std::max(largest, std::abs(row.load.estimate));
    const Shown shown(largest);
    Table table{{fmt::format("load on a part against the tow, {}", shown.unit.name), "mean", "SD", "largest of a step",
                 "largest averaged"}};
    for (const PartRow& row : rows) {
        if (row.statistic == "mean_N") {
            const bool several = evidence.campaign.cases.size() > 1;
            table.push_back(
                {several ? evidence.summary.label_of(row.case_index) + ", " + row.part : row.part, "", "", "", ""});
            table.back()[1] = shown.with_interval(row.load);
        } else if (row.statistic == "sd_N") {
            table.back()[2] = shown.with_interval(row.load);
        } else if (row.statistic == "maximum_N") {
            table.back()[3] = shown.with_interval(row.load);
        } else if (row.statistic.starts_with("mean_maximum")) {
            table.back()[4] = fmt::format("{} over {}", shown.with_interval(row.load),
                                          row.statistic.substr(13, row.statistic.size() - 15));
        }
    }
    return {.table = std::move(table),
            .after =
                "\n±: 95 % interval over arrangements. Largest averaged: mean over segments and arrangements of "
                "the largest load on the part averaged over the longest of analysis.averaging_s; for all times "
                "take --format csv. Parts are loaded at different times, so their largest loads do not add up.\n",
            .records = {make_rows<PartRow>(
                "parts", rows,
                {{"case", [&](const PartRow& row) { return Datum(evidence.summary.name_of(row.case_index)); }},
                 {"part", [](const PartRow& row) { return Datum(row.part); }},
                 {"statistic", [](const PartRow& row) { return Datum(row.statistic); }},
                 {"estimate", [](const PartRow& row) { return Datum(row.load.estimate); }},
                 {"low", [](const PartRow& row) { return Datum(row.load.low); }},
                 {"high", [](const PartRow& row) { return Datum(row.load.high); }},
                 {"members", [](const PartRow& row) { return Datum(row.members); }}})}};
}

struct MomentRow {
    std::size_t case_index = 0;
    std::string_view moment;
    std::array<Interval, 3> values{};  ///< mean, SD, largest, N m
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> moments{
    {{"yaw", "yaw, + bow to port"},
     {"roll", "overturning about the tow, + heels to starboard"},
     {"pitch", "overturning across the tow, + lifts the bow"}}};

std::vector<MomentRow> find_moments(const CampaignTable& table) {
    std::vector<MomentRow> rows;
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        for (const auto& [name, words] : moments) {
            MomentRow row{k, words};
            bool measured = true;
            for (std::size_t s = 0; s < 3; ++s) {
                constexpr std::array statistics{"mean", "sd", "largest"};
                const Quantity& quantity = *find_quantity(fmt::format("{}_{}_moment", statistics[s], name));
                std::vector<double> values;
                for (const MemberRow* member : done_members(table, k))
                    if (const double value = member->value(quantity); std::isfinite(value)) values.push_back(value);
                measured = measured && !values.empty();
                if (measured) row.values[s] = mean_interval(values);
            }
            if (measured) rows.push_back(row);
        }
    }
    return rows;
}

Section section_of_moments(const Evidence& evidence) {
    const std::vector<MomentRow> rows = find_moments(evidence.table);
    if (rows.empty()) return {.missing = "Moments: unknown, because the members were computed without them.\n"};
    double largest = 0;
    for (const MomentRow& row : rows) largest = std::max(largest, row.values[2].estimate);
    const Shown shown(largest);
    Table table{
        {fmt::format("moment about the axis at the waterline, {} m", shown.unit.name), "mean", "SD", "largest"}};
    for (const MomentRow& row : rows) {
        const std::string words(row.moment);
        table.push_back(
            {evidence.campaign.cases.size() > 1 ? evidence.summary.label_of(row.case_index) + ", " + words : words,
             shown.with_interval(row.values[0]), shown.with_interval(row.values[1]),
             shown.with_interval(row.values[2])});
    }
    return {.table = std::move(table),
            .after = "\nLargest: of the magnitude, of a step.\n",
            .records = {make_rows<MomentRow>(
                "moments", rows,
                {{"case", [&](const MomentRow& row) { return Datum(evidence.summary.name_of(row.case_index)); }},
                 {"moment", [](const MomentRow& row) { return Datum(std::string{row.moment}); }},
                 {"mean_N_m", [](const MomentRow& row) { return Datum(row.values[0].estimate); }},
                 {"sd_N_m", [](const MomentRow& row) { return Datum(row.values[1].estimate); }},
                 {"largest_N_m", [](const MomentRow& row) { return Datum(row.values[2].estimate); }}})}};
}

}  // namespace

std::vector<PartRow> find_parts(const Campaign& campaign, const CampaignTable& table) {
    std::vector<PartRow> rows;
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases[k].scenario;
        const std::vector<std::string> names = scenario.structure.shape.parts();
        for (std::size_t p = 0; p < names.size(); ++p) {
            for (const auto& [statistic, of] : statistics_of(scenario)) {
                std::vector<double> values;
                for (const MemberRow* member : done_members(table, k))
                    if (p < member->parts.size() && std::isfinite(of(member->parts[p])))
                        values.push_back(of(member->parts[p]));
                if (values.empty()) continue;
                rows.push_back({k, names[p], statistic, mean_interval(values), static_cast<double>(values.size())});
            }
        }
    }
    return rows;
}

std::vector<Section> parts_sections(Evidence& evidence) {
    std::vector<Section> sections;
    if (const std::vector<PartRow> rows = find_parts(evidence.campaign, evidence.table); !rows.empty())
        sections.push_back(section_of_parts(evidence, rows));
    sections.push_back(pressure_section(evidence));
    sections.push_back(section_of_moments(evidence));
    return sections;
}

}  // namespace floes
