#include "findings/parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "findings/estimates.hpp"
#include "shapes/shape.hpp"
#include "theory/level_ice.hpp"

namespace floes {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Areas of the case's parts in the campaign, m².
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

bool has_line(const Results& rows) {
    for (std::size_t r = 0; r < rows.rows.size(); ++r)
        if (std::isfinite(rows.number(r, "iso_19906"))) return true;
    return false;
}

/// Log-log, a point for each part and averaging time; the names stand at the shortest.
std::vector<Figure> figures_of(const Evidence& evidence, const Results& rows) {
    constexpr double margin = 2;
    double smallest = infinite, widest = 0, low = infinite, high = 0;
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
        const double pressure = rows.number(r, "pressure");
        if (!(pressure > 0)) continue;
        smallest = std::min(smallest, rows.number(r, "reached"));
        widest = std::max(widest, rows.number(r, "reached"));
        low = std::min(low, pressure);
        high = std::fmax(std::max(high, pressure), rows.number(r, "iso_19906"));
    }
    if (!(widest > 0)) return {};
    Figure figure{.description = "Largest pressure on each part of the hull over the area that ice reaches",
                  .x = {"area reached by ice, m²", smallest / margin, widest * margin, true},
                  .y = {"largest pressure", low / margin, high * margin, true, {}, 0, "Pa"},
                  .legend = case_legend(evidence.summary),
                  .caption =
                      "Each part of the hull, averaged over each of analysis.averaging_s, the highest point over "
                      "the shortest."};
    if (has_line(rows)) {
        Figure::Points line;
        constexpr int points = 40;
        for (int k = 0; k <= points; ++k) {
            const double area = figure.x.low * std::pow(figure.x.high / figure.x.low, k / double{points});
            line.emplace_back(area, pressure_of_area(area));
        }
        figure.line(std::move(line), "ink dashed");
        figure.legend.emplace_back("ink dashed", "ISO 19906, thick massive ice");
    }
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
        const auto* pressure = std::get_if<Estimate>(&rows.at(r, "pressure").get());
        const std::size_t of_case = case_index(evidence.summary, rows.name(r, "case"));
        if (pressure == nullptr || std::ranges::find(drawn, of_case) == drawn.end()) continue;
        const double reached = rows.number(r, "reached");
        figure.dot(reached, pressure->value, colour(of_case), 3.5);
        const bool fresh = r == 0 || rows.name(r - 1, "part") != rows.name(r, "part") ||
                           rows.name(r - 1, "case") != rows.name(r, "case");
        if (!fresh) continue;
        if (pressure->low > 0)
            figure.line({{reached, pressure->low}, {reached, pressure->high}}, colour(of_case) + " thin");
        if (of_case == drawn.front()) figure.text(reached * 1.05, pressure->value, rows.name(r, "part"), "start");
    }
    return {std::move(figure)};
}

std::string line_words(const Evidence& evidence) {
    const auto tank = [&](const Case& one) { return of_a_tank(one.scenario, evidence.scale); };
    if (!std::ranges::any_of(evidence.campaign.cases, tank))
        return "ISO 19906: its line above measured pressures of thick massive ice that crushes.";
    return fmt::format(
        "Ice thinner than {:g} m is taken as a tank's: its pressures are not those that the line of ISO 19906 is "
        "above. --scale L shows them at full scale, by Froude, where the ice is L times as strong.",
        tank_ice);
}

/// A row for every `what` of every case, by a label for people and both names for programs.
Results results_of(std::string place, std::string what, std::string words) {
    return {.place = std::move(place), .columns = {{"", std::move(words)}, {"case"}, {std::move(what)}}};
}

std::vector<Datum> row_of(const Evidence& evidence, std::size_t of_case, const Named& what) {
    const std::string& label = evidence.summary.label_of(of_case);
    return {evidence.campaign.cases.size() > 1 ? label + ", " + what.label : what.label,
            evidence.summary.name_of(of_case), what.name};
}

}  // namespace

Results find_pressures(const Evidence& evidence) {
    const double scale = evidence.scale;
    Results rows = results_of("pressures", "part", "pressure on a part");
    rows.columns =
        rows.columns + std::vector<ResultColumn>{{.key = "surface", .words = "surface", .unit = "m²", .digits = 3},
                                                 {.key = "reached", .words = "reached", .unit = "m²", .digits = 3},
                                                 {.key = "averaging", .words = "over", .unit = "s", .digits = 3},
                                                 estimates("pressure", "largest", "Pa"),
                                                 {.key = "iso_19906", .words = "ISO 19906", .unit = "Pa", .digits = 4},
                                                 {"members"}};
    for (std::size_t k = 0; k < evidence.sample.cases(); ++k) {
        const Scenario& scenario = evidence.campaign.cases[k].scenario;
        const std::vector<std::string> names = scenario.structure.shape.parts();
        if (names.size() < 2) continue;
        const Areas areas(scenario);
        const std::vector<double> times = scenario.averaging_times();
        for (std::size_t p = 0; p < names.size(); ++p) {
            for (std::size_t t = 0; t < times.size(); ++t) {
                std::vector<double> forces =
                    evidence.sample.values(evidence.sample.done(k), "parts/normal_maximum", p, t);
                std::erase_if(forces, [](double force) { return !std::isfinite(force); });
                if (forces.empty()) continue;
                const auto members = forces.size();
                const double reached = scale * scale * areas.reached[p];
                for (double& force : forces) force *= scale / areas.reached[p];
                rows.add(row_of(evidence, k, {names[p], names[p]}) +
                         std::vector<Datum>{
                             scale * scale * areas.surface[p], reached, std::sqrt(scale) * times[t],
                             if_known(reached > 0, over(std::move(forces))),
                             if_known(reached > 0 && !of_a_tank(scenario, scale), pressure_of_area(reached)), members});
            }
        }
    }
    return rows;
}

Section pressure_section(const Evidence& evidence) {
    Results rows = find_pressures(evidence);
    if (rows.empty())
        return {.missing = "Pressures: unknown, because the members were computed without normal forces of parts.\n"};
    std::vector<Figure> figures = figures_of(evidence, rows);
    if (!has_line(rows)) std::ranges::find(rows.columns, "iso_19906", &ResultColumn::key)->words.clear();
    return {.results = {std::move(rows)},
            .after =
                "\nThe part's normal force, averaged over a time, over its surface between the lower and the upper "
                "side of the floating ice, which is what ice reaches; mean over segments and arrangements of the "
                "largest. " +
                line_words(evidence) + "\n",
            .figures = std::move(figures)};
}

Results find_parts(const Evidence& evidence) {
    struct Statistic {
        ResultColumn column;
        std::string_view array;
        double time = 0;  ///< that it is averaged over; 0: none
    };
    std::set<double> times;
    for (const Case& one : evidence.campaign.cases)
        for (const double time : one.scenario.averaging_times()) times.insert(time);
    std::vector<Statistic> statistics{{estimates("mean_load", "mean", "N"), "parts/mean_load"},
                                      {estimates("sd_load", "SD", "N"), "parts/sd_load"},
                                      {estimates("maximum_load", "largest of a step", "N"), "parts/maximum_load"}};
    for (const double time : times)
        statistics.push_back(
            {estimates(fmt::format("mean_maximum_{}s", time), fmt::format("largest over {} s", time), "N"),
             "parts/mean_maximum", time});
    statistics.push_back({estimates("mean_sway", "", "N"), "parts/mean_sway"});
    statistics.push_back({estimates("mean_heave", "", "N"), "parts/mean_heave"});

    Results rows = results_of("parts", "part", "load on a part against the tow");
    for (const Statistic& statistic : statistics) rows.columns.push_back(statistic.column);
    rows.columns.push_back({"members"});
    for (std::size_t k = 0; k < evidence.sample.cases(); ++k) {
        const Members& done = evidence.sample.done(k);
        const std::vector<std::string> names = evidence.campaign.cases[k].scenario.structure.shape.parts();
        for (std::size_t p = 0; p < names.size(); ++p) {
            std::vector<Datum> row = row_of(evidence, k, {names[p], names[p]});
            std::size_t members = 0;
            for (const auto& [column, array, time] : statistics) {
                const auto place = time > 0 && !done.empty() ? evidence.sample.place_of_time(done.front(), time) : 0;
                std::vector<double> values =
                    place ? evidence.sample.values(done, array, p, *place) : std::vector<double>{};
                std::erase_if(values, [](double value) { return !std::isfinite(value); });
                members = std::max(members, values.size());
                row.emplace_back(over(std::move(values)));
            }
            row.emplace_back(members);
            if (members > 0) rows.add(std::move(row));
        }
    }
    return rows;
}

namespace {

constexpr std::array<std::pair<const char*, const char*>, 3> axes{
    {{"yaw", "yaw, + bow to port"},
     {"roll", "overturning about the tow, + heels to starboard"},
     {"pitch", "overturning across the tow, + lifts the bow"}}};

Section moments_section(const Evidence& evidence) {
    Results rows = results_of("moments", "moment", "moment about the axis at the waterline");
    for (const auto& [key, words] : {std::pair{"mean", "mean"}, std::pair{"sd", "SD"}, std::pair{"largest", "largest"}})
        rows.columns.push_back(estimates(key, words, "N m"));
    for (std::size_t k = 0; k < evidence.sample.cases(); ++k) {
        for (const auto& [axis, words] : axes) {
            std::vector<Datum> row = row_of(evidence, k, {axis, words});
            bool measured = true;
            for (const char* statistic : {"mean", "sd", "largest"}) {
                const Estimate moment = over(evidence.sample, evidence.sample.done(k),
                                             *find_quantity(fmt::format("{}_{}_moment", statistic, axis)));
                measured = measured && std::isfinite(moment.value);
                row.emplace_back(moment);
            }
            if (measured) rows.add(std::move(row));
        }
    }
    if (rows.empty()) return {.missing = "Moments: unknown, because the members were computed without them.\n"};
    return {.results = {std::move(rows)}, .after = "\nLargest: of the magnitude, of a step.\n"};
}

}  // namespace

std::vector<Section> parts_sections(Evidence& evidence) {
    std::vector<Section> sections;
    if (Results parts = find_parts(evidence); !parts.empty())
        sections.push_back(
            {.results = {std::move(parts)},
             .after =
                 "\nBrackets: 95 % interval over arrangements. Largest over a time: mean over segments and "
                 "arrangements of the largest load on the part averaged over it. Parts are loaded at different times, "
                 "so their largest loads do not add up.\n"});
    sections.push_back(pressure_section(evidence));
    sections.push_back(moments_section(evidence));
    return sections;
}

}  // namespace floes
