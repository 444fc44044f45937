#include "findings/load_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/units.hpp"
#include "findings/catalogue.hpp"

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

std::vector<CaseLoadMap> find_load_maps(const CampaignFile& file, const CampaignTable& table) {
    std::vector<CaseLoadMap> of_cases(table.cases.size());
    std::vector<Parts> parts(table.cases.size(), Parts(LoadMap::parts));
    for_each_load_map(file, [&](int member, const LoadMap& map) {
        const auto index = static_cast<std::size_t>(table.members.at(static_cast<std::size_t>(member)).case_index);
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

const Scenario& scenario_of(const Evidence& evidence, std::size_t of_case) {
    return evidence.campaign.cases[of_case].scenario;
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

}  // namespace

std::vector<Figure> wall_figures(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    double largest = 0;
    for (const CaseLoadMap& found : maps) largest = std::max(largest, std::ranges::max(found.mean.surge));
    const double reach = drawn_angle(maps);
    std::vector<Figure> figures;
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = scenario_of(evidence, found.case_index).structure.shape;
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

Figure load_profile(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    std::vector<double> loads;
    double low = 0;
    double high = 0;
    for (const CaseLoadMap& found : maps) {
        const Shape& shape = scenario_of(evidence, found.case_index).structure.shape;
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
        const Shape& shape = scenario_of(evidence, found.case_index).structure.shape;
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

Figure load_along_tow(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    std::vector<double> loads;
    std::vector<double> distances;
    const auto distance = [&](std::size_t of_case, double share) {
        const Scenario& scenario = scenario_of(evidence, of_case);
        return scenario.structure.speed * (scenario.analysis.steady_start + share * scenario.analysis.window);
    };
    for (const CaseLoadMap& found : maps) {
        for (const Interval& part : found.along_tow) {
            loads.push_back(part.estimate);
            if (found.members >= least_for_interval) loads.insert(loads.end(), {part.low, part.high});
        }
        for (const double share : {0.0, 1.0}) distances.push_back(distance(found.case_index, share));
    }
    const auto [first, last] = std::ranges::minmax(distances);
    Figure figure{.description = "Mean load along the tow, in 24 parts of the window",
                  .x = {"distance towed, m", first, last},
                  .y = axis_around("surge load", loads, true, "N"),
                  .legend = legend_of(evidence, maps)};
    for (const CaseLoadMap& found : maps) {
        Figure::Points mean;
        Figure::Points low;
        Figure::Points high;
        for (std::size_t part = 0; part < found.along_tow.size(); ++part) {
            const double x = distance(found.case_index, middle_part(part));
            mean.emplace_back(x, found.along_tow[part].estimate);
            low.emplace_back(x, found.along_tow[part].low);
            high.emplace_back(x, found.along_tow[part].high);
        }
        if (found.members >= least_for_interval) figure.band(std::move(low), high, colour(found.case_index) + " veil");
        figure.line(mean, colour(found.case_index));
    }
    return figure;
}

namespace {

/// Share of the depth at which the water stands.
double waterline(const Shape& shape) {
    return -shape.bottom() / (shape.top() - shape.bottom());
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
        const double water = waterline(evidence.campaign.cases[found.case_index].scenario.structure.shape);
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
    std::vector<CaseLoadMap> maps = find_load_maps(evidence.file, evidence.table);
    std::erase_if(maps, [&](const CaseLoadMap& found) { return !std::ranges::binary_search(drawn, found.case_index); });
    if (maps.empty()) return {.before = "No figure: the file has no maps of the load.\n"};
    Section section{.results = {share_table(evidence, maps)},
                    .after =
                        "Normal forces: mean sum of their magnitudes, in whatever direction they press on the "
                        "wall." +
                        undrawn_text(evidence.summary),
                    .figures = wall_figures(evidence, maps)};
    section.figures.back().caption =
        "Mean surge load on the wall, unrolled, mean over members, in each cell of 10° by a twelfth of the depth. "
        "All cases have the same colours. Blue: drags the structure along.";
    section.figures.push_back(load_rose(evidence, maps));
    section.figures.push_back(load_profile(evidence, maps));
    section.figures.back().caption = "The same by angle, seen from above with the tow to the right, and by height.";
    section.figures.push_back(load_along_tow(evidence, maps));
    section.figures.back().caption =
        "Mean surge load in 24 equal parts of the window, mean over arrangements with its 95 % interval, where there "
        "are four or more.";
    return section;
}

}  // namespace floes
