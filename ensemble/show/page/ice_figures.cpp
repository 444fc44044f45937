// Figures of ice and structure: the scenario, and the results of closed formulas for it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/units.hpp"
#include "findings/paper_table3.hpp"
#include "page/plot.hpp"
#include "scenario/floes.hpp"
#include "page/report_figures.hpp"

namespace floes {
namespace {

constexpr double margin_x = 80;  // of a figure, for axes and labels
constexpr double margin_y = 74;

/// Size of a figure with the same scale along both axes.
Size to_scale(double width_m, double height_m, double widest) {
    const double scale = std::min((widest - margin_x) / width_m, 420 / height_m);
    return {margin_x + scale * width_m, margin_y + scale * height_m};
}

Plot::Points square(const PlanarPose& pose, double length, double breadth) {
    Plot::Points corners;
    const double c = std::cos(pose.yaw);
    const double s = std::sin(pose.yaw);
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const double along = a * length / 2;
        const double across = b * breadth / 2;
        corners.emplace_back(pose.x + c * along + s * across, pose.z - s * along + c * across);
    }
    return corners;
}

Plot::Points ring(double x, double z, double radius) {
    Plot::Points points;
    for (int degree = 0; degree < 360; degree += 5)
        points.emplace_back(x + radius * std::cos(degree * unit::degree), z + radius * std::sin(degree * unit::degree));
    return points;
}

}  // namespace

std::string joint_figure(const Scenario& scenario) {
    const FloeShape& floe = scenario.floe;
    const double margin = 0.15 * std::max(floe.length, floe.breadth);
    Plot plot("One floe seen from above: square elements and the joints at the middle of their edges",
              {"along the floe, m", -margin, floe.length + margin}, {"across, m", -margin, floe.breadth + margin},
              to_scale(floe.length + 2 * margin, floe.breadth + 2 * margin, 420));
    const double side = floe.element;
    for (int i = 0; i < floe.elements_long(); ++i) {
        for (int k = 0; k < floe.elements_broad(); ++k) {
            const double x = (i + 0.5) * side;
            const double z = (k + 0.5) * side;
            plot.area(square({x, z, 0}, 0.97 * side, 0.97 * side), "ice");
        }
    }
    for (int i = 0; i < floe.elements_long(); ++i) {
        for (int k = 0; k < floe.elements_broad(); ++k) {
            const double x = (i + 0.5) * side;
            const double z = (k + 0.5) * side;
            if (i + 1 < floe.elements_long()) plot.dot(x + side / 2, z, "c1", 4);
            if (k + 1 < floe.elements_broad()) plot.dot(x, z + side / 2, "c1", 4);
        }
    }
    return plot.svg();
}

std::string section_figure(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    Plot::Points outline;
    for (const Vec2& point : shape.section()) outline.emplace_back(point.x(), point.y());
    const double reach = 1.6 * shape.largest_radius();
    const double low = shape.bottom() - 0.08;
    const double high = shape.top() + 0.08;
    Plot plot("Section of the structure with the water's surface and the ice", {"m", -reach, reach},
              {"height above the water, m", low, high}, to_scale(2 * reach, high - low, 720));
    plot.area({{-reach, low}, {reach, low}, {reach, 0}, {-reach, 0}}, "water");
    const double draught = scenario.floe.thickness * scenario.ice.density / scenario.water.density;
    const double freeboard = scenario.floe.thickness - draught;
    for (const double sign : {-1.0, 1.0}) {
        const double near = sign * (shape.waterline_radius() + 0.02);
        plot.area({{near, -draught}, {sign * reach, -draught}, {sign * reach, freeboard}, {near, freeboard}}, "ice");
    }
    plot.area(outline, "structure");
    plot.level(0, "dashed");
    return plot.svg();
}

std::string arrangement_figure(const ReportData& data) {
    if (data.largest_member < 0) return "";
    const MemberRow& member = data.table.members[static_cast<std::size_t>(data.largest_member)];
    const Scenario& scenario = data.campaign.cases[static_cast<std::size_t>(member.case_index)].scenario;
    const Field& field = scenario.field;
    const double low =
        std::min(scenario.structure.start - scenario.structure.shape.waterline_radius(), field.begin) - 0.3;
    const double high = scenario.field_end() + std::min(field.sheet_width, 0.5);
    const double half = field.half_width + std::min(field.sheet_width, 0.5);
    Plot plot("The floes at the start, from above; floes that broke are marked", {"along the tow, m", low, high},
              {"across, m", -half, half}, to_scale(high - low, 2 * half, 720));
    for (const double sign : {-1.0, 1.0})
        plot.area({{field.begin, sign * field.half_width},
                   {high, sign * field.half_width},
                   {high, sign * half},
                   {field.begin, sign * half}},
                  "sheet");
    if (field.far_end == FarEnd::ice_sheet)
        plot.area({{scenario.field_end(), -field.half_width},
                   {high, -field.half_width},
                   {high, field.half_width},
                   {scenario.field_end(), field.half_width}},
                  "sheet");
    std::set<int> broken;
    for (const BreakRow& row : data.breaks) {
        if (row.member == data.largest_member) broken.insert(row.floe);
    }
    const FloeSet floes = floes_of(scenario);
    for (std::size_t i = 0; i < data.largest_poses.size(); ++i)
        plot.area(square(data.largest_poses[i], floes.shape(i).length, floes.shape(i).breadth),
                  broken.contains(static_cast<int>(i)) ? "ice broken" : "ice");
    plot.area(ring(scenario.structure.start, 0, scenario.structure.shape.waterline_radius()), "structure");
    return plot.svg();
}

std::string modulus_figure(const ReportData& data) {
    if (data.curve.empty()) return "";
    std::vector<double> moduli{200};
    Plot::Points points;
    constexpr double least_cfm = 1e-4;  // start of the axis; smaller values are drawn at its edge
    double largest_cfm = 0.1;
    for (const CurvePoint& point : data.curve) {
        points.emplace_back(std::max(point.cfm, least_cfm), point.elastic_modulus / unit::megapascal);
        moduli.push_back(points.back().second);
        largest_cfm = std::max(largest_cfm, point.cfm);
    }
    Axis y = axis_around("elastic modulus E, MPa", moduli, true);
    Plot plot("Elastic modulus over constraint force mixing",
              {"constraint force mixing Σ (1e-10 at the left edge)", least_cfm, largest_cfm, true}, y);
    plot.line(points, "c0");
    for (const auto& [cfm, modulus] : points) plot.dot(cfm, modulus, "c0");
    std::vector<std::pair<std::string, std::string>> legend{{"c0", "plate tests of this ice"}};
    if (is_the_papers(data.campaign.cases.front().scenario)) {
        for (const PaperRow& row : paper_table3)
            plot.cross(std::max(row.cfm, least_cfm), row.elastic_modulus_mpa, "c1", 5);
        legend.emplace_back("c1", "the paper's pairs ×");
    }
    plot.legend(legend);
    return plot.svg();
}

std::string hybrid_figure(const ReportData& data) {
    const HybridCurve& curve = *data.hybrid;
    Plot::Points stress;
    Plot::Points momentum;
    Plot::Points lower;
    std::vector<double> loads;
    for (const HybridPoint& point : curve.points) {
        const double modulus = point.elastic_modulus / unit::megapascal;
        stress.emplace_back(modulus, point.limit_stress.total());
        momentum.emplace_back(modulus, point.limit_momentum);
        lower.emplace_back(modulus, point.load);
        loads.push_back(point.load);
    }
    for (const CaseSummary& row : data.summary.cases) loads.push_back(row.of(quantity("mean_load")).high);
    const bool papers = is_the_papers(data.campaign.cases.front().scenario);
    if (papers)
        for (const PaperRow& row : paper_table3) loads.push_back(row.mean);
    Axis y = axis_around("mean load, N", loads, true);
    y.high *= 1.3;
    for (Plot::Points* points : {&stress, &momentum})
        std::erase_if(*points, [&](const auto& point) { return point.second > y.high; });
    Plot plot(
        fmt::format("Mean load over the elastic modulus: hybrid model, this campaign{}", papers ? ", the paper" : ""),
        {"elastic modulus E, MPa", stress.empty() ? 1 : lower.front().first, lower.back().first, true}, y, {720, 360});
    plot.line(stress, "c0 dashed");
    plot.line(momentum, "c1 dashed");
    plot.line(lower, "ink thick");
    for (const CaseSummary& row : data.summary.cases) {
        const double modulus = row.about.elastic_modulus / unit::megapascal;
        plot.line({{modulus, row.of(quantity("mean_load")).low}, {modulus, row.of(quantity("mean_load")).high}},
                  "c2 thick");
        plot.dot(modulus, row.of(quantity("mean_load")).estimate, "c2", 4.5);
    }
    std::vector<std::pair<std::string, std::string>> legend{
        {"c0", "Lindqvist × IC"}, {"c1", "KPR"}, {"ink", "hybrid"}, {"c2", "this campaign"}};
    if (papers) {
        for (const PaperRow& row : paper_table3) plot.cross(row.elastic_modulus_mpa, row.mean, "c3", 5);
        plot.dot(Experiment{}.elastic_modulus_mpa, Experiment{}.mean, "c4", 4.5);
        legend.insert(legend.end(), {{"c3", "the paper ×"}, {"c4", "experiment"}});
    }
    plot.legend(legend);
    return plot.svg();
}

}  // namespace floes
