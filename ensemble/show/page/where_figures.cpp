// Figures of where on the structure and when along the tow the load acts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "page/case_colours.hpp"
#include "page/plot.hpp"
#include "page/where_section.hpp"
#include "statistics/load_map.hpp"

namespace floes {
namespace {

constexpr double angle_width = 360.0 / LoadMap::angles;  // degrees
constexpr Size panel{404, 250};
constexpr int least_for_interval = 4;  // members; those of fewer would fill the figure

const Scenario& scenario_of(const ReportData& data, std::size_t of_case) {
    return data.campaign.cases[of_case].scenario;
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
double drawn_angle(const ReportData& data) {
    double angle = 90;
    const auto holds = [&](const CaseLoadMap& found) { return std::abs(1 - found.share_within(angle)) < 0.01; };
    while (angle < 180 && !std::ranges::all_of(data.load_maps, holds)) angle += 30;
    return angle;
}

std::pair<double, double> in_plan(double degrees, double radius) {
    return {radius * std::cos(degrees * unit::degree), radius * std::sin(degrees * unit::degree)};
}

std::vector<std::pair<std::string, std::string>> mapped_legend(const ReportData& data) {
    std::vector<std::pair<std::string, std::string>> legend;
    for (const CaseLoadMap& found : data.load_maps)
        legend.emplace_back(colour(found.case_index), data.summary.cases[found.case_index].about.name);
    return legend;
}

}  // namespace

std::vector<std::string> load_map_figures(const ReportData& data) {
    double largest = 0;
    for (const CaseLoadMap& found : data.load_maps) largest = std::max(largest, std::ranges::max(found.mean.surge));
    const double reach = drawn_angle(data);
    std::vector<std::string> figures;
    for (const CaseLoadMap& found : data.load_maps) {
        const Shape& shape = scenario_of(data, found.case_index).structure.shape;
        const std::string name = data.summary.cases[found.case_index].about.name;
        Plot plot(fmt::format("Case {}: mean load by angle and height on the structure", name),
                  {fmt::format("{}: degrees from straight ahead", name), -reach, reach, false, {}, 30},
                  {"height above the water, m", shape.bottom(), shape.top()}, panel);
        for (std::size_t bin = 0; bin < found.mean.surge.size(); ++bin) {
            if (std::abs(middle_angle(bin % LoadMap::angles)) > reach) continue;
            const double share = found.mean.surge[bin] / largest;
            const std::size_t h = bin / LoadMap::angles;
            const double low = height_of(shape, static_cast<double>(h) / LoadMap::heights);
            plot.cell(middle_angle(bin % LoadMap::angles) - angle_width / 2, low, angle_width,
                      height_of(shape, static_cast<double>(h + 1) / LoadMap::heights) - low, std::abs(share),
                      share > 0 ? "heat" : "cold");
        }
        plot.level(0, "dashed");
        plot.text(reach - 2, 0.01, "water", "end");
        plot.colour_bar("heat", fmt::format("up to {:.2g} N; {:.1f} N in all", largest, found.load()));
        figures.push_back(plot.svg());
    }
    return figures;
}

std::string load_rose_figure(const ReportData& data) {
    double largest = 0;
    for (const CaseLoadMap& found : data.load_maps) largest = std::max(largest, std::ranges::max(by_angle(found)));
    const double reach = 1.08 * largest;
    Plot plot("Mean load by angle round the structure, seen from above", {"ahead, N per 10°", -reach / 2, reach},
              {"to the side, N per 10°", -0.75 * reach, 0.75 * reach}, {panel.width, 74 + panel.width - 80});
    for (const double degrees : {-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0}) {
        plot.line({{0, 0}, in_plan(degrees, 0.63 * reach)}, "dotted thin");
        const auto [x, y] = in_plan(degrees, 0.68 * reach);
        plot.text(x, y, fmt::format("{:g}°", degrees), "middle");
    }
    for (const CaseLoadMap& found : data.load_maps) {
        const std::vector<double> loads = by_angle(found);
        Plot::Points outline;
        for (std::size_t a = 0; a < loads.size(); ++a)
            for (const double side : {-0.5, 0.5})
                outline.push_back(in_plan(middle_angle(a) + side * angle_width, std::max(0.0, loads[a])));
        outline.push_back(outline.front());
        plot.line(outline, colour(found.case_index));
    }
    plot.legend(mapped_legend(data));
    return plot.svg();
}

std::string load_profile_figure(const ReportData& data) {
    std::vector<double> loads;
    double low = 0;
    double high = 0;
    for (const CaseLoadMap& found : data.load_maps) {
        const Shape& shape = scenario_of(data, found.case_index).structure.shape;
        for (const double load : by_height(found, shape)) loads.push_back(load);
        low = std::min(low, shape.bottom());
        high = std::max(high, shape.top());
    }
    Plot plot("Mean load by height on the structure", axis_around("N per m of height", loads, true),
              {"height above the water, m", low, high}, {panel.width, 74 + panel.width - 80});
    for (const CaseLoadMap& found : data.load_maps) {
        const Shape& shape = scenario_of(data, found.case_index).structure.shape;
        const std::vector<double> of_heights = by_height(found, shape);
        Plot::Points steps;
        for (std::size_t h = 0; h < of_heights.size(); ++h)
            for (const std::size_t edge : {h, h + 1})
                steps.emplace_back(of_heights[h], height_of(shape, static_cast<double>(edge) / LoadMap::heights));
        plot.line(steps, colour(found.case_index));
    }
    plot.level(0, "dashed");
    plot.legend(mapped_legend(data));
    return plot.svg();
}

std::string load_along_tow_figure(const ReportData& data) {
    std::vector<double> loads;
    std::vector<double> distances;
    const auto distance = [&](std::size_t of_case, double share) {
        const Scenario& scenario = scenario_of(data, of_case);
        return scenario.structure.speed * (scenario.analysis.steady_start + share * scenario.analysis.window);
    };
    for (const CaseLoadMap& found : data.load_maps) {
        for (const Interval& part : found.along_tow) {
            loads.push_back(part.estimate);
            if (found.members >= least_for_interval) loads.insert(loads.end(), {part.low, part.high});
        }
        for (const double share : {0.0, 1.0}) distances.push_back(distance(found.case_index, share));
    }
    const auto [first, last] = std::ranges::minmax(distances);
    Plot plot("Mean load along the tow, in 24 parts of the window", {"distance towed, m", first, last},
              axis_around("surge load, N", loads, true));
    for (const CaseLoadMap& found : data.load_maps) {
        Plot::Points mean;
        Plot::Points low;
        Plot::Points high;
        for (std::size_t part = 0; part < found.along_tow.size(); ++part) {
            const double x = distance(found.case_index, middle_part(part));
            mean.emplace_back(x, found.along_tow[part].estimate);
            low.emplace_back(x, found.along_tow[part].low);
            high.emplace_back(x, found.along_tow[part].high);
        }
        high.insert(high.end(), low.rbegin(), low.rend());
        if (found.members >= least_for_interval) plot.area(high, colour(found.case_index) + " veil");
        plot.line(mean, colour(found.case_index));
    }
    plot.legend(mapped_legend(data));
    return plot.svg();
}

}  // namespace floes
