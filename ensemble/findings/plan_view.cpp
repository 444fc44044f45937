#include "findings/plan_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "shapes/moorings.hpp"
#include "shapes/path.hpp"

namespace floes {

Way way_of(const Scenario& scenario) {
    constexpr int most = 400;  // parts of the way that are drawn
    const int steps = scenario.step_count();
    const int parts = std::clamp(steps, 1, most);
    const double step = scenario.general.time_step;
    const std::vector<PathPlace> places = scenario.places();
    Way way{.length = scenario.towed(), .interval = step * steps / parts};
    for (int k = 0; k <= parts; ++k) {
        const double time = way.time(way.poses.size());
        PlanarPose pose{scenario.structure.start + scenario.structure.speed * time, 0, 0};
        if (!places.empty()) {
            const auto at = static_cast<std::size_t>(std::lround(1.0 * k * steps / parts));
            pose = places[std::min(at, places.size() - 1)].pose;
            pose.x += scenario.structure.start;
        }
        if (time < scenario.analysis.steady_start) way.first_measured = way.poses.size() + 1;
        way.poses.push_back(pose);
    }
    way.first_measured = std::min(way.first_measured, way.poses.size() - 1);
    return way;
}

Vec2 place_of(const PlanarPose& pose) {
    return {pose.x, pose.z};
}

Figure::Points from_above(const std::vector<Vec2>& own, const PlanarPose& pose) {
    Figure::Points points;
    for (const Vec2& point : own) {
        const Vec2 at = place_of(pose) + turned(point, pose.yaw);
        points.emplace_back(at.x(), at.y());
    }
    return points;
}

Figure::Points floe_from_above(const FloeShape& floe, const PlanarPose& pose) {
    std::vector<Vec2> corners;
    for (const Corner& own : floe.corners()) corners.emplace_back(own.x, own.z);
    return from_above(corners, pose);
}

std::vector<Figure::Points> waterlines_at(const Shape& shape, const PlanarPose& pose) {
    std::vector<Figure::Points> outlines;
    for (const std::vector<Vec2>& piece : shape.waterlines()) outlines.push_back(from_above(piece, pose));
    return outlines;
}

Figure plan_figure(const Seen& seen, std::string description, double widest) {
    const Vec2 size = seen.sizes();
    return {.description = std::move(description),
            .x = {"along the tow, m", seen.min().x(), seen.max().x()},
            .y = {.label = "across, m", .low = seen.min().y(), .high = seen.max().y(), .downwards = true},
            .size = to_scale(size.x(), size.y(), widest)};
}

double drawn_bank(const Scenario& scenario) {
    constexpr double least = 0.03;  // of the field's half width: narrower ones would not be seen
    constexpr double most = 0.2;
    const Field& field = scenario.field;
    return std::clamp(field.sheet_width, least * field.half_width, most * field.half_width);
}

void add_banks(Figure& plan, const Scenario& scenario) {
    const Field& field = scenario.field;
    const double inner = field.half_width;
    const double outer = inner + drawn_bank(scenario);
    const double begin = std::max(field.begin, plan.x.low);
    const double end = field.endless() ? plan.x.high : std::min(scenario.field_end(), plan.x.high);
    const bool closed = field.far_end == FarEnd::ice_sheet;
    const double far = closed ? std::min(end + drawn_bank(scenario), plan.x.high) : end;
    if (field.sides == FieldSides::ice_sheet)
        for (const double sign : {-1.0, 1.0})
            plan.area({{begin, sign * inner}, {far, sign * inner}, {far, sign * outer}, {begin, sign * outer}},
                      "sheet");
    if (closed && far > end) plan.area({{end, -inner}, {far, -inner}, {far, inner}, {end, inner}}, "sheet");
}

void add_floes(Figure& plan, const FloeSet& floes, const std::set<int>& broken) {
    for (std::size_t i = 0; i < floes.size(); ++i)
        plan.area(floe_from_above(floes.shape(i), floes.floes[i].pose),
                  broken.contains(static_cast<int>(i)) ? "ice broken" : "ice");
}

void add_hull(Figure& plan, const Shape& shape, const PlanarPose& pose) {
    for (Figure::Points& outline : waterlines_at(shape, pose)) plan.area(std::move(outline), "structure");
}

namespace {

/// Which shares of a segment lie within the axes (Liang and Barsky); the first is above the second where none does.
std::pair<double, double> within(const Figure& figure, const std::pair<double, double>& from,
                                 const std::pair<double, double>& to) {
    double first = 0;
    double last = 1;
    const auto cut = [&](double begin, double way, double low, double high) {
        if (way == 0) {
            if (begin < low || begin > high) last = -1;
            return;
        }
        const auto [in, out] = std::minmax({(low - begin) / way, (high - begin) / way});
        first = std::max(first, in);
        last = std::min(last, out);
    };
    cut(from.first, to.first - from.first, figure.x.low, figure.x.high);
    cut(from.second, to.second - from.second, figure.y.low, figure.y.high);
    return {first, last};
}

}  // namespace

void add_clipped(Figure& figure, const Figure::Points& points, const std::string& style) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Figure::Points kept;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const auto& [x, y] = points[k];
        const double along = points[k + 1].first - x;
        const double up = points[k + 1].second - y;
        const auto [first, last] = within(figure, points[k], points[k + 1]);
        if (first > last) continue;
        if (first > 0 || kept.empty() || kept.back() != points[k]) {
            if (!kept.empty()) kept.emplace_back(gap, gap);
            kept.emplace_back(x + first * along, y + first * up);
        }
        kept.emplace_back(last < 1 ? std::pair(x + last * along, y + last * up) : points[k + 1]);
    }
    if (!kept.empty()) figure.line(std::move(kept), style);
}

void add_arrow(Figure& figure, const Vec2& from, const Vec2& to, double head, const std::string& style) {
    const Vec2 way = (to - from).normalized();
    const Vec2 aside(-way.y(), way.x());
    const Vec2 neck = to - head * way;
    figure.line({{from.x(), from.y()}, {neck.x(), neck.y()}}, style);
    Figure::Points tip;
    for (const Vec2& point : {to, Vec2(neck + 0.4 * head * aside), Vec2(neck - 0.4 * head * aside)})
        tip.emplace_back(point.x(), point.y());
    figure.area(std::move(tip), style);
}

void add_scale_bar(Figure& figure) {
    const double width = figure.x.high - figure.x.low;
    const double height = figure.y.high - figure.y.low;
    const double length = round_below(width / 6);
    const double up = figure.y.downwards ? -1 : 1;
    const double x = figure.x.low + 0.015 * width;
    const double half = 0.006 * width;  // of the strokes at its ends
    const double inwards = std::max(half, std::min(0.04 * height, 0.015 * width));
    const double y = (figure.y.downwards ? figure.y.high : figure.y.low) + up * inwards;
    const double end = up * half;
    for (const double at : {x, x + length}) figure.line({{at, y - end}, {at, y + end}}, "");
    figure.line({{x, y}, {x + length, y}}, "");
    figure.text(x + length + 0.008 * width, y, fmt::format("{:g} m", length), "start", "halo");
}

void add_hull_from_abeam(Figure& figure, const Shape& shape) {
    for (const std::vector<Vec2>& piece : shape.side_view()) {
        Figure::Points outline;
        for (const Vec2& point : piece) outline.emplace_back(point.x(), point.y());
        figure.area(std::move(outline), "structure");
    }
}

Figure elevation_of(const Scenario& scenario, const std::string& names, double widest) {
    const Shape& shape = scenario.structure.shape;
    const double reach = 1.6 * shape.largest_radius();
    const double air = 0.12 * (shape.top() - shape.bottom());
    const Water& water = scenario.water;
    const bool near_bed = water.has_bed() && water.depth < 2 * shape.draught();
    const double low = std::min(shape.bottom(), near_bed ? -water.depth : 0.0) - air;
    const double high = shape.top() + air;
    Figure figure{.description = "Section of the structure with the water's surface and the ice",
                  .x = {names + "m", -reach, reach},
                  .y = {"height, m", low, high},
                  .size = to_scale(2 * reach, high - low, widest)};
    figure.area({{-reach, low}, {reach, low}, {reach, 0}, {-reach, 0}}, "water");
    const double draught = scenario.floe.thickness * scenario.ice.density / scenario.water.density;
    const double freeboard = scenario.floe.thickness - draught;
    const double beside = shape.waterline_ahead() + 0.02 * reach;
    for (const double sign : {-1.0, 1.0})
        figure.area({{sign * beside, -draught},
                     {sign * reach, -draught},
                     {sign * reach, freeboard},
                     {sign * beside, freeboard}},
                    "ice");
    add_hull_from_abeam(figure, shape);
    if (near_bed) {
        const auto bed = [&](double x) { return std::clamp(-water.depth + std::tan(water.bed_slope) * x, low, high); };
        figure.area({{-reach, low}, {reach, low}, {reach, bed(reach)}, {-reach, bed(-reach)}}, "sheet");
    }
    figure.level(0, "dashed");
    return figure;
}

}  // namespace floes
