#include "findings/load_map_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace floes {
namespace {

constexpr double angle_width = 360.0 / LoadMap::angles;  // degrees
constexpr Figure::Size panel{404, 250};
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
                      .size = panel,
                      .heat_scale = fmt::format("up to {:.2g} N; {:.1f} N in all", largest, found.load())};
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
                  .x = {"ahead, N per 10°", -reach / 2, reach},
                  .y = {"to the side, N per 10°", -0.75 * reach, 0.75 * reach},
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
                  .x = axis_around("N per m of height", loads, true),
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
                  .y = axis_around("surge load, N", loads, true),
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

}  // namespace floes
