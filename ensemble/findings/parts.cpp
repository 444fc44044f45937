#include "findings/parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "shapes/shape.hpp"
#include "tables/number_text.hpp"
#include "theory/level_ice.hpp"

namespace floes {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of the case's parts in the campaign, m².
struct Areas {
    std::vector<double> surface, reached;

    explicit Areas(const Scenario& scenario)
        : surface(part_areas(scenario.structure.shape, -infinite, infinite)),
          reached(part_areas(scenario.structure.shape, scenario.floe.thickness * (above(scenario) - 1),
                             scenario.floe.thickness * above(scenario))) {}

  private:
    /// Share of floating ice that is above the water.
    static double above(const Scenario& scenario) { return 1 - scenario.ice.density / scenario.water.density; }
};

bool of_a_tank(const Scenario& scenario, double scale) {
    return scale * scenario.floe.thickness < tank_ice;
}

std::string with_interval(const PressureRow& row, double factor, int decimals) {
    if (!row.pressure) return "–";
    std::string text = fixed(factor * row.pressure->estimate, decimals);
    if (std::isfinite(row.pressure->high))
        text += " ± " + fixed(factor * (row.pressure->high - row.pressure->estimate), decimals);
    return text;
}

Table table_of(const Evidence& evidence, const std::vector<PressureRow>& rows) {
    std::set<double> times;
    double largest = 0;
    for (const PressureRow& row : rows) {
        times.insert(row.averaging);
        if (row.pressure) largest = std::max(largest, row.pressure->estimate);
    }
    const bool in_mpa = largest > 1e6;
    const double factor = in_mpa ? 1e-6 : 1e-3;
    const char* unit = in_mpa ? "MPa" : "kPa";
    const int decimals = decimals_for(factor * largest);
    const bool with_line = std::ranges::any_of(rows, [](const PressureRow& row) { return row.line.has_value(); });
    const bool several = evidence.campaign.cases.size() > 1;
    Table table{{"pressure on a part", "surface, m²", "reached by ice, m²"}};
    for (const double time : times)
        table.front().emplace_back(fmt::format("largest averaged over {:.3g} s, {}", time, unit));
    if (with_line) table.front().emplace_back(fmt::format("ISO 19906, {}", unit));
    const PressureRow* before = nullptr;
    for (const PressureRow& row : rows) {
        if (before == nullptr || before->case_index != row.case_index || before->part != row.part) {
            std::vector<Cell>& line = table.emplace_back();
            line.emplace_back(several ? evidence.summary.label_of(row.case_index) + ", " + row.part : row.part);
            line.emplace_back(fmt::format("{:.3g}", row.surface));
            line.emplace_back(row.reached > 0 ? fmt::format("{:.3g}", row.reached) : "–");
            line.resize(table.front().size(), Cell{"–"});
            if (with_line && row.line) line.back() = fixed(factor * *row.line, decimals);
        }
        const auto column = static_cast<std::size_t>(std::distance(times.begin(), times.find(row.averaging)));
        table.back()[3 + column] = with_interval(row, factor, decimals);
        before = &row;
    }
    return table;
}

/// Log-log, a point for each part and averaging time; the names stand at the shortest.
std::vector<Figure> figures_of(const Evidence& evidence, const std::vector<PressureRow>& rows) {
    double smallest = infinite;
    double widest = 0;
    double low = infinite;
    double high = 0;
    for (const PressureRow& row : rows) {
        if (!row.pressure || !(row.pressure->estimate > 0)) continue;
        smallest = std::min(smallest, row.reached);
        widest = std::max(widest, row.reached);
        low = std::min(low, 1e-6 * row.pressure->estimate);
        high = std::max({high, 1e-6 * row.pressure->estimate, 1e-6 * row.line.value_or(0)});
    }
    if (!(widest > 0)) return {};
    constexpr double margin = 2;
    Figure figure{.description = "Largest pressure on each part of the hull over the area that ice reaches",
                  .x = {"area reached by ice, m²", smallest / margin, widest * margin, true},
                  .y = {"largest pressure, MPa", low / margin, high * margin, true},
                  .legend = case_legend(evidence.summary),
                  .caption =
                      "Each part of the hull, averaged over each of analysis.averaging_s, the highest point over "
                      "the shortest."};
    if (std::ranges::any_of(rows, [](const PressureRow& row) { return row.line.has_value(); })) {
        Figure::Points line;
        constexpr int points = 40;
        for (int k = 0; k <= points; ++k) {
            const double area = figure.x.low * std::pow(figure.x.high / figure.x.low, k / double{points});
            line.emplace_back(area, 1e-6 * pressure_of_area(area));
        }
        figure.line(std::move(line), "ink dashed");
        figure.legend.emplace_back("ink dashed", "ISO 19906, thick massive ice");
    }
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    const PressureRow* before = nullptr;
    for (const PressureRow& row : rows) {
        const bool fresh = before == nullptr || before->case_index != row.case_index || before->part != row.part;
        before = &row;
        if (!row.pressure || std::ranges::find(drawn, row.case_index) == drawn.end()) continue;
        const double height = 1e-6 * row.pressure->estimate;
        figure.dot(row.reached, height, colour(row.case_index), 3.5);
        if (!fresh) continue;
        if (row.pressure->low > 0)
            figure.line({{row.reached, 1e-6 * row.pressure->low}, {row.reached, 1e-6 * row.pressure->high}},
                        colour(row.case_index) + " thin");
        if (row.case_index == drawn.front()) figure.text(row.reached * 1.05, height, row.part, "start");
    }
    return {std::move(figure)};
}

std::string line_words(const Evidence& evidence) {
    const auto tank = [&](const Case& one) { return of_a_tank(one.scenario, evidence.scale); };
    if (!std::ranges::any_of(evidence.campaign.cases, tank))
        return "ISO 19906: its line above measured pressures of thick massive ice that crushes.";
    return fmt::format(
        "Ice thinner than {:g} m is taken as a tank's: its pressures are not those that the line of ISO 19906 is "
        "above. "
        "--scale L shows them at full scale, by Froude, where the ice is L times as strong.",
        tank_ice);
}

Datum datum_of(const std::optional<Interval>& value, double Interval::*limit) {
    return value ? Datum((*value).*limit) : Undefined{};
}

}  // namespace

std::vector<PressureRow> find_pressures(const Campaign& campaign, const CampaignTable& table, double scale) {
    std::vector<PressureRow> rows;
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases[k].scenario;
        const std::vector<std::string> names = scenario.structure.shape.parts();
        if (names.size() < 2) continue;
        const Areas areas(scenario);
        const std::vector<double> times = scenario.averaging_times();
        for (std::size_t p = 0; p < names.size(); ++p) {
            for (std::size_t t = 0; t < times.size(); ++t) {
                std::vector<double> forces;
                for (const MemberRow* member : done_members(table, k))
                    if (p < member->parts.size() && t < member->parts[p].normal_maximum.size())
                        forces.push_back(member->parts[p].normal_maximum[t]);
                if (forces.empty()) continue;
                PressureRow row{.case_index = k,
                                .part = names[p],
                                .surface = scale * scale * areas.surface[p],
                                .reached = scale * scale * areas.reached[p],
                                .averaging = std::sqrt(scale) * times[t],
                                .members = static_cast<double>(forces.size())};
                if (row.reached > 0) {
                    for (double& one : forces) one *= scale / areas.reached[p];
                    row.pressure = mean_interval(forces);
                    if (!of_a_tank(scenario, scale)) row.line = pressure_of_area(row.reached);
                }
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

Section pressure_section(const Evidence& evidence) {
    const std::vector<PressureRow> rows = find_pressures(evidence.campaign, evidence.table, evidence.scale);
    if (rows.empty())
        return {.missing = "Pressures: unknown, because the members were computed without normal forces of parts.\n"};
    return {
        .table = table_of(evidence, rows),
        .after =
            "\nThe part's normal force, averaged over a time, over its surface between the lower and the upper "
            "side of the floating ice; mean over segments and arrangements of the largest. " +
            line_words(evidence) + "\n",
        .records = {make_rows<PressureRow>(
            "pressures", rows,
            {{"case", [&](const PressureRow& row) { return Datum(evidence.summary.name_of(row.case_index)); }},
             {"part", [](const PressureRow& row) { return Datum(row.part); }},
             {"surface_m2", &PressureRow::surface},
             {"reached_m2", &PressureRow::reached},
             {"averaging_s", &PressureRow::averaging},
             {"pressure_Pa", [](const PressureRow& row) { return datum_of(row.pressure, &Interval::estimate); }},
             {"low", [](const PressureRow& row) { return datum_of(row.pressure, &Interval::low); }},
             {"high", [](const PressureRow& row) { return datum_of(row.pressure, &Interval::high); }},
             {"iso_19906_Pa", [](const PressureRow& row) { return row.line ? Datum(*row.line) : Datum(Undefined{}); }},
             {"members", &PressureRow::members}})},
        .figures = figures_of(evidence, rows)};
}

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
