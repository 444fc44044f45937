// What the load is made of: where on the structure and when along the tow it acts, on which part of the hull, and where
// the work of the tow goes.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/units.hpp"
#include "findings/sections.hpp"
#include "findings/summary.hpp"
#include "shapes/shape.hpp"
#include "theory/level_ice.hpp"

namespace floes {

namespace {

void add(std::vector<double>& sums, const std::vector<double>& values) {
    sums.resize(values.size(), 0.0);
    std::ranges::transform(sums, values, sums.begin(), std::plus{});
}

/// Values of each part of the window, one a member.
using Parts = std::vector<std::vector<double>>;

void finish(CaseLoadMap& found, const Parts& parts) {
    for (std::vector<double>* sums : {&found.mean.surge, &found.mean.normal})
        for (double& value : *sums) value /= found.members;
    for (const std::vector<double>& part : parts) {
        found.along_tow.push_back(mean_interval(part));
        found.mean.along_tow.push_back(found.along_tow.back().estimate);
    }
}

/// Share of the load in the bins for which the function of height and angle is true.
template <class Function>
double share_of(const CaseLoadMap& found, Function counts) {
    double part = 0;
    for (std::size_t h = 0; h < LoadMap::heights; ++h)
        for (std::size_t a = 0; a < LoadMap::angles; ++a)
            if (counts(middle_height(h), middle_angle(a))) part += found.mean.surge[h * LoadMap::angles + a];
    return part / found.load();
}

}  // namespace

double CaseLoadMap::load() const {
    return std::accumulate(mean.surge.begin(), mean.surge.end(), 0.0);
}

double CaseLoadMap::share_within(double angle) const {
    return share_of(*this, [&](double, double middle) { return std::abs(middle) < angle; });
}

double CaseLoadMap::share_between(double low, double high) const {
    return share_of(*this, [&](double middle, double) { return low <= middle && middle < high; });
}

std::vector<CaseLoadMap> find_load_maps(const CampaignFile& file, const Sample& sample) {
    std::vector<CaseLoadMap> of_cases(sample.cases.size());
    std::vector<Parts> parts(sample.cases.size(), Parts(LoadMap::parts));
    for_each_load_map(file, [&](int member, const LoadMap& map) {
        const std::size_t index = sample.case_of(static_cast<std::size_t>(member));
        CaseLoadMap& found = of_cases.at(index);
        found.case_index = index;
        ++found.members;
        add(found.mean.surge, map.surge);
        add(found.mean.normal, map.normal);
        for (std::size_t part = 0; part < LoadMap::parts; ++part) parts[index][part].push_back(map.along_tow.at(part));
    });
    for (std::size_t k = 0; k < of_cases.size(); ++k)
        if (of_cases[k].members > 0) finish(of_cases[k], parts[k]);
    std::erase_if(of_cases, [](const CaseLoadMap& found) { return found.members == 0; });
    return of_cases;
}

namespace {

constexpr double angle_width = 360.0 / LoadMap::angles;  // degrees
constexpr Figure::Size map_panel{404, 250};
constexpr Figure::Size square_panel{404, 398};
constexpr int least_for_interval = 4;  // members; those of fewer would fill the figure

const Shape& shape_of(const Evidence& evidence, const CaseLoadMap& found) {
    return evidence.campaign.cases[found.case_index].scenario.structure.shape;
}

/// Height above the water of a share of the depth, m.
double height_of(const Shape& shape, double share) {
    return shape.bottom() + share * (shape.top() - shape.bottom());
}

/// Load of each angle, N.
std::vector<double> by_angle(const CaseLoadMap& found) {
    std::vector<double> loads(LoadMap::angles, 0.0);
    for (std::size_t bin = 0; bin < found.mean.surge.size(); ++bin)
        loads[bin % LoadMap::angles] += found.mean.surge[bin];
    return loads;
}

/// Load of each height, N per m of height.
std::vector<double> by_height(const CaseLoadMap& found, const Shape& shape) {
    const double height = (shape.top() - shape.bottom()) / LoadMap::heights;
    std::vector<double> loads(LoadMap::heights, 0.0);
    for (std::size_t bin = 0; bin < found.mean.surge.size(); ++bin)
        loads[bin / LoadMap::angles] += found.mean.surge[bin] / height;
    return loads;
}

/// Degrees to both sides, a multiple of 30, within which all but a hundredth of every case's load acts.
double drawn_angle(const std::vector<CaseLoadMap>& maps) {
    double angle = 90;
    const auto holds = [&](const CaseLoadMap& found) { return std::abs(1 - found.share_within(angle)) < 0.01; };
    while (angle < 180 && !std::ranges::all_of(maps, holds)) angle += 30;
    return angle;
}

std::pair<double, double> in_plan(double degrees, double radius) {
    return {radius * std::cos(degrees * unit::degree), radius * std::sin(degrees * unit::degree)};
}

std::vector<std::pair<std::string, std::string>> legend_of(const Evidence& evidence,
                                                           const std::vector<CaseLoadMap>& maps) {
    std::vector<std::pair<std::string, std::string>> legend;
    for (const CaseLoadMap& found : maps)
        legend.emplace_back(colour(found.case_index), evidence.summary.label_of(found.case_index));
    return legend;
}

/// For each map, the wall unrolled: angle by height, all in one scale of colours.
std::vector<Figure> wall_figures(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    double largest = 0;
    for (const CaseLoadMap& found : maps) largest = std::max(largest, std::ranges::max(found.mean.surge));
    const double reach = drawn_angle(maps);
    std::vector<Figure> figures;
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = shape_of(evidence, found);
        const std::string name = evidence.summary.label_of(found.case_index);
        Figure figure{.description = fmt::format("Case {}: mean load by angle and height on the structure", name),
                      .x = {fmt::format("{}: degrees from straight ahead", name), -reach, reach, false, {}, 30},
                      .y = {"height above the water, m", shape.bottom(), shape.top()},
                      .size = map_panel,
                      .heat_scale = fmt::format("up to {}; {} in all", evidence.units.text(largest, "N", 2),
                                                evidence.units.text(found.load(), "N"))};
        for (std::size_t bin = 0; bin < found.mean.surge.size(); ++bin) {
            if (std::abs(middle_angle(bin % LoadMap::angles)) > reach) continue;
            const double share = found.mean.surge[bin] / largest;
            const std::size_t h = bin / LoadMap::angles;
            const double low = height_of(shape, static_cast<double>(h) / LoadMap::heights);
            figure.cell(middle_angle(bin % LoadMap::angles) - angle_width / 2, low, angle_width,
                        height_of(shape, static_cast<double>(h + 1) / LoadMap::heights) - low, std::abs(share),
                        share > 0 ? "heat" : "cold");
        }
        figure.level(0, "dashed");
        figure.text(reach - 2, 0.01, "water", "end");
        figures.push_back(std::move(figure));
    }
    return figures;
}

/// By angle, in plan.
Figure load_rose(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    double largest = 0;
    for (const CaseLoadMap& found : maps) largest = std::max(largest, std::ranges::max(by_angle(found)));
    const double reach = 1.08 * largest;
    Figure figure{.description = "Mean load by angle round the structure, seen from above",
                  .x = {"ahead, per 10°", -reach / 2, reach, false, {}, 0, "N"},
                  .y = {"to the side, per 10°", -0.75 * reach, 0.75 * reach, false, {}, 0, "N"},
                  .size = square_panel,
                  .legend = legend_of(evidence, maps)};
    for (const double degrees : {-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0}) {
        figure.line({{0, 0}, in_plan(degrees, 0.63 * reach)}, "dotted thin");
        const auto [x, y] = in_plan(degrees, 0.68 * reach);
        figure.text(x, y, fmt::format("{:g}°", degrees), "middle");
    }
    for (const CaseLoadMap& found : maps) {
        const std::vector<double> loads = by_angle(found);
        Figure::Points outline;
        for (std::size_t a = 0; a < loads.size(); ++a)
            for (const double side : {-0.5, 0.5})
                outline.push_back(in_plan(middle_angle(a) + side * angle_width, std::max(0.0, loads[a])));
        outline.push_back(outline.front());
        figure.line(outline, colour(found.case_index));
    }
    return figure;
}

/// By height.
Figure load_profile(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    std::vector<double> loads;
    double low = 0;
    double high = 0;
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = shape_of(evidence, found);
        for (const double load : by_height(found, shape)) loads.push_back(load);
        low = std::min(low, shape.bottom());
        high = std::max(high, shape.top());
    }
    Figure figure{.description = "Mean load by height on the structure",
                  .x = axis_around("load by height", loads, true, "N m-1"),
                  .y = {"height above the water, m", low, high},
                  .size = square_panel,
                  .legend = legend_of(evidence, maps)};
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = shape_of(evidence, found);
        const std::vector<double> of_heights = by_height(found, shape);
        Figure::Points steps;
        for (std::size_t h = 0; h < of_heights.size(); ++h)
            for (const std::size_t edge : {h, h + 1})
                steps.emplace_back(of_heights[h], height_of(shape, static_cast<double>(edge) / LoadMap::heights));
        figure.line(steps, colour(found.case_index));
    }
    figure.level(0, "dashed");
    return figure;
}

/// How far the structure has gone at these shares of the window, which rise, m.
std::vector<double> distances_at(const Scenario& scenario, const std::vector<double>& shares) {
    const std::vector<PathPlace> places = scenario.places();
    const double step = scenario.general.time_step;
    std::vector<double> distances;
    double gone = 0;
    std::size_t k = 0;
    for (const double share : shares) {
        const double time = scenario.analysis.steady_start + share * scenario.analysis.window;
        for (; k < places.size() && step * static_cast<double>(k) < time + step / 2; ++k)
            gone += step * places[k].velocity.norm();
        distances.push_back(places.empty() ? scenario.structure.speed * time : gone);
    }
    return distances;
}

/// Over the distance towed.
Figure load_along_tow(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    std::vector<double> shares{0};
    for (std::size_t part = 0; part < LoadMap::parts; ++part) shares.push_back(middle_part(part));
    shares.push_back(1);
    std::vector<double> loads;
    std::vector<std::vector<double>> distances;
    double first = HUGE_VAL;
    double last = 0;
    for (const CaseLoadMap& found : maps) {
        for (const Interval& part : found.along_tow) {
            loads.push_back(part.estimate);
            if (found.members >= least_for_interval) loads.insert(loads.end(), {part.low, part.high});
        }
        const std::vector<double>& own =
            distances.emplace_back(distances_at(evidence.campaign.cases[found.case_index].scenario, shares));
        first = std::min(first, own.front());
        last = std::max(last, own.back());
    }
    if (last == first) last += 1;  // a path on which the structure stands
    Figure figure{.description = "Mean load along the tow, in 24 parts of the window",
                  .x = {"distance towed, m", first, last},
                  .y = axis_around("surge load", loads, true, "N"),
                  .legend = legend_of(evidence, maps)};
    for (std::size_t map = 0; map < maps.size(); ++map) {
        const CaseLoadMap& found = maps[map];
        Figure::Points mean;
        Figure::Points low;
        Figure::Points high;
        for (std::size_t part = 0; part < found.along_tow.size(); ++part) {
            const double x = distances[map].at(part + 1);
            mean.emplace_back(x, found.along_tow[part].estimate);
            low.emplace_back(x, found.along_tow[part].low);
            high.emplace_back(x, found.along_tow[part].high);
        }
        if (found.members >= least_for_interval) figure.band(std::move(low), high, colour(found.case_index) + " veil");
        figure.line(mean, colour(found.case_index));
    }
    return figure;
}

Results share_table(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    Results results{.place = "load_shares", .columns = {{"case", "share of the mean load"}}};
    for (const auto& [key, words] :
         {std::pair{"within_30_degrees", "within 30° of ahead"}, std::pair{"within_60_degrees", "within 60°"},
          std::pair{"lower_draught", "lower half of the draught"}, std::pair{"upper_draught", "upper half"},
          std::pair{"above_water", "above water"}})
        results.columns.push_back({.key = key, .words = words, .unit = "share", .decimals = 0});
    results.columns.push_back({.key = "normal_forces", .words = "normal forces", .unit = "N"});
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = shape_of(evidence, found);
        const double water = -shape.bottom() / (shape.top() - shape.bottom());  // share of the depth
        results.add({evidence.summary.named(found.case_index), found.share_within(30), found.share_within(60),
                     found.share_between(0, water / 2), found.share_between(water / 2, water),
                     found.share_between(water, 1),
                     std::accumulate(found.mean.normal.begin(), found.mean.normal.end(), 0.0)});
    }
    return results;
}

}  // namespace

Section load_map_section(Evidence& evidence) {
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    if (drawn.empty()) return {};
    std::vector<CaseLoadMap> maps = find_load_maps(evidence.file, evidence.sample);
    std::erase_if(maps, [&](const CaseLoadMap& found) { return !std::ranges::binary_search(drawn, found.case_index); });
    if (maps.empty()) return {.before = "No figure: the file has no maps of the load.\n"};
    Section section{
        .results = {share_table(evidence, maps)},
        .after = "Normal forces: mean sum of their magnitudes, in whatever direction they press on the wall." +
                 undrawn_text(evidence.summary),
        .figures = wall_figures(evidence, maps)};
    section.figures.back().caption =
        "Mean surge load on the wall, unrolled, mean over members, in each cell of 10° by a twelfth of the depth. All "
        "cases have the same colours. Blue: drags the structure along.";
    section.figures.push_back(load_rose(evidence, maps));
    section.figures.push_back(load_profile(evidence, maps));
    section.figures.back().caption = "The same by angle, seen from above with the tow to the right, and by height.";
    section.figures.push_back(load_along_tow(evidence, maps));
    section.figures.back().caption =
        "Mean surge load in 24 equal parts of the window, mean over arrangements with its 95 % interval, where there "
        "are four or more.";
    return section;
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Ice thinner than this, m, is taken as a tank's. Judgement: tanks make a few centimetres, and ice of no thickness
/// that structures are designed for is thinner.
constexpr double tank_ice = 0.15;

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
    Figure figure{
        .description = "Largest pressure on each part of the hull over the area that ice reaches",
        .x = {"area reached by ice, m²", smallest / margin, widest * margin, true},
        .y = {"largest pressure", low / margin, high * margin, true, {}, 0, "Pa"},
        .legend = case_legend(evidence.summary),
        .caption =
            "Each part of the hull, averaged over each of analysis.averaging_s, the highest point over the shortest."};
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
    for (std::size_t k = 0; k < evidence.sample.cases.size(); ++k) {
        const Scenario& scenario = evidence.campaign.cases[k].scenario;
        const std::vector<std::string> names = scenario.structure.shape.parts();
        if (names.size() < 2) continue;
        const Areas areas(scenario);
        const std::vector<double> times = scenario.averaging_times();
        for (std::size_t p = 0; p < names.size(); ++p) {
            for (std::size_t t = 0; t < times.size(); ++t) {
                std::vector<double> forces =
                    measured(evidence.sample.values(evidence.sample.done(k), "parts/normal_maximum", p, t));
                if (forces.empty()) continue;
                const double reached = scale * scale * areas.reached[p];
                for (double& force : forces) force *= scale / areas.reached[p];
                rows.add(
                    row_of(evidence, k, {names[p], names[p]}) +
                    std::vector<Datum>{scale * scale * areas.surface[p], reached, std::sqrt(scale) * times[t],
                                       if_known(reached > 0, over(forces)),
                                       if_known(reached > 0 && !of_a_tank(scenario, scale), pressure_of_area(reached)),
                                       forces.size()});
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
    return {
        .results = {std::move(rows)},
        .after =
            "\nThe part's normal force, averaged over a time, over its surface between the lower and the upper side of "
            "the floating ice, which is what ice reaches; mean over segments and arrangements of the largest. " +
            line_words(evidence) + "\n",
        .figures = std::move(figures)};
}

namespace {

/// Surge loads by case and part; cases of a structure that is one part have none.
Results find_parts(const Evidence& evidence) {
    struct Statistic {
        ResultColumn column;
        std::string_view array;
        double time = 0;  ///< that it is averaged over; 0: none
    };
    std::set<double> times;
    for (const Case& one : evidence.campaign.cases)
        for (const double time : one.scenario.averaging_times()) times.insert(time);
    std::vector<Statistic> statistics{
        {estimates("mean_load", "mean", "N"), "parts/mean_load"},
        {estimates("sd_load", "SD", "N"), "parts/sd_load"},
        {estimates("maximum_load", times.empty() ? "largest of a step" : "", "N"), "parts/maximum_load"}};
    for (const double time : times)
        statistics.push_back(
            {estimates(fmt::format("mean_maximum_{}s", time), fmt::format("largest over {} s", time), "N"),
             "parts/mean_maximum", time});
    statistics.push_back({estimates("mean_sway", "", "N"), "parts/mean_sway"});
    statistics.push_back({estimates("mean_heave", "", "N"), "parts/mean_heave"});

    Results rows = results_of("parts", "part", "load on a part against the tow");
    for (const Statistic& statistic : statistics) rows.columns.push_back(statistic.column);
    rows.columns.push_back({"members"});
    for (std::size_t k = 0; k < evidence.sample.cases.size(); ++k) {
        const Members& done = evidence.sample.done(k);
        const std::vector<std::string> names = evidence.campaign.cases[k].scenario.structure.shape.parts();
        for (std::size_t p = 0; p < names.size(); ++p) {
            std::vector<Datum> row = row_of(evidence, k, {names[p], names[p]});
            std::size_t members = 0;
            for (const auto& [column, array, time] : statistics) {
                const auto place = time > 0 && !done.empty() ? evidence.sample.place_of_time(done.front(), time) : 0;
                const std::vector<double> values =
                    place ? measured(evidence.sample.values(done, array, p, *place)) : std::vector<double>{};
                members = std::max(members, values.size());
                row.emplace_back(over(values));
            }
            row.emplace_back(members);
            if (members > 0) rows.add(std::move(row));
        }
    }
    return rows;
}

constexpr std::array<std::pair<const char*, const char*>, 3> axes{
    {{"yaw", "yaw, + bow to port"},
     {"roll", "overturning about the tow, + heels to starboard"},
     {"pitch", "overturning across the tow, + lifts the bow"}}};

Section moments_section(const Evidence& evidence) {
    Results rows = results_of("moments", "moment", "moment about the axis at the waterline");
    for (const auto& [key, words] : {std::pair{"mean", "mean"}, std::pair{"sd", "SD"}, std::pair{"largest", "largest"}})
        rows.columns.push_back(estimates(key, words, "N m"));
    for (std::size_t k = 0; k < evidence.sample.cases.size(); ++k) {
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
        sections.push_back({.results = {std::move(parts)},
                            .after = "\nBrackets: 95 % interval over arrangements. Largest over a time: mean over "
                                     "segments and arrangements of the largest load on the part averaged over it. "
                                     "Parts are loaded at different times, so their largest loads do not add up.\n"});
    sections.push_back(pressure_section(evidence));
    sections.push_back(moments_section(evidence));
    return sections;
}

namespace {

constexpr std::array<std::pair<const char*, const char*>, 13> shares{{
    {"work_ice_friction", "friction, ice on ice"},
    {"work_ice_crushing", "crushing and stopping, ice on ice"},
    {"work_hull_friction", "friction on the structure"},
    {"work_hull_crushing", "crushing and stopping on the structure"},
    {"work_vertical_drag", "drag along the normals of the ice"},
    {"work_plane_drag", "form and skin drag"},
    {"work_waves", "waves"},
    {"work_joints", "bending and breaking"},
    {"work_lifting", "lifting and pushing under"},
    {"work_driving", "against sheets that give way and wind"},
    {"work_motion", "motion of ice and water"},
    {"work_giving_way", "motion of the structure on its moorings"},
    {"work_rest", "lost by finite steps"},
}};

/// What people see: drawn cases beside each other, with the sum; what nothing drives is left out.
Results shown(const Results& all, const Evidence& evidence) {
    Results some{.columns = all.columns};
    for (const std::size_t k : drawn_cases(evidence.summary)) {
        double sum = 0;
        for (std::size_t r = 0; r < all.rows.size(); ++r) {
            if (all.name(r, "case") != evidence.summary.name_of(k)) continue;
            const double force = all.number(r, "force");
            sum += force;
            const std::string cause = all.name(r, "quantity");
            if ((cause != "work_driving" && cause != "work_giving_way") || force != 0) some.add(all.rows[r]);
        }
        if (sum != 0)
            some.add({Named{"", evidence.summary.label_of(k)}, Named{"", "together"}, Estimate{.value = sum}, 1.0, 0});
    }
    return pivot(some, "quantity", "case", {"force", "share"});
}

}  // namespace

Results find_energy(const Sample& sample, const Summary& summary) {
    Results results{.place = "energy",
                    .columns = {{"case", "case"},
                                {"quantity", "work of the tow over its length"},
                                estimates("force", "force", "N"),
                                {.key = "share", .words = "share", .unit = "share", .decimals = 0},
                                {"members"}},
                    .view = Results::View::none};
    for (std::size_t k = 0; k < sample.cases.size(); ++k) {
        const std::size_t first = results.rows.size();
        double sum = 0;
        for (const auto& [key, words] : shares) {
            const std::vector<double> values = measured(sample.values(sample.done(k), *find_quantity(key)));
            if (values.empty()) continue;
            const Estimate force = over(values);
            sum += force.value;
            results.add({summary.named(k), Named{key, words}, force, 0.0, values.size()});
        }
        for (std::size_t r = first; r < results.rows.size(); ++r) results.rows[r][3] = results.number(r, "force") / sum;
    }
    return results;
}

/// Of a path the work is of the whole way, the mean load one over time.
std::string of_paths(const Campaign& campaign) {
    const bool any = std::ranges::any_of(campaign.cases, [](const Case& one) { return one.scenario.path.any(); });
    return any ? " Of a case on a path it is the mean over the way, of the force along it, not the mean over time."
               : "";
}

Section energy_section(Evidence& evidence) {
    Results all = find_energy(evidence.sample, evidence.summary);
    if (all.empty()) return {.missing = "Work of the tow: unknown, because the members were computed without it.\n"};
    Results some = shown(all, evidence);
    return {.results = {std::move(some), std::move(all)},
            .after =
                "\nWhere the work of the tow goes, divided by the distance towed: together it is the mean load, but "
                "for what the steps that were looked at (every fifth) differ from all. Brackets: 95 % interval over "
                "arrangements. Stopping: floes that meet lose speed without friction. Bending and breaking contains "
                "what joints still store." +
                of_paths(evidence.campaign) + undrawn_text(evidence.summary) + "\n"};
}

}  // namespace floes
