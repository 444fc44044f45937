#include "findings/scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrangement/arrangement.hpp"
#include "campaign/case_words.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/design_points.hpp"
#include "findings/plan_view.hpp"
#include "scenario/keys.hpp"
#include "shapes/moorings.hpp"
#include "shapes/polygon.hpp"

namespace floes {

namespace {

constexpr double widest = 960;  // of a figure, on the screen

/// As a member lays them; of a field without end all that is computed at its beginning.
FloeSet laid_floes(const Campaign& campaign, std::size_t of_case, int arrangement) {
    const Scenario& scenario = campaign.cases.at(of_case).scenario;
    LaidField laid = lay_field(scenario, arrangement_seed(campaign, static_cast<int>(of_case)),
                               static_cast<std::uint32_t>(arrangement));
    const double wanted = scenario.structure.start + scenario.window_ahead();
    const FloeSet& first = laid.laid();
    if (!laid.ahead.next || laid.ahead.end >= wanted) return first;
    std::vector<SingleFloe> all;
    for (std::size_t i = 0; i < first.size(); ++i)
        all.push_back({first.floes[i].pose, first.shape(i), first.material(i)});
    for (double end = laid.ahead.end; end < wanted;) {
        FieldPart part = laid.ahead.next();
        end = part.end;
        std::ranges::move(part.floes, std::back_inserter(all));
    }
    return gathered(all);
}

void extend(Seen& seen, const Figure::Points& points) {
    for (const auto& [x, y] : points) seen.extend(Vec2(x, y));
}

/// The hull from above at its widest, one outline; none of a hull that is in several pieces at the water.
Figure::Points widest_outline(const Shape& shape, const PlanarPose& pose) {
    if (shape.waterlines().size() != 1) return {};
    Outline points;
    for (const Vec3& point : shape.mesh(round_sides).points) points.push_back({point.x(), point.z()});
    std::vector<Vec2> rim;
    for (const Corner& corner : convex_hull(std::move(points))) rim.emplace_back(corner.x, corner.z);
    if (!rim.empty()) rim.push_back(rim.front());
    return from_above(rim, pose);
}

/// A mooring line as it lies before the first step, m in the world.
struct LaidLine {
    Vec3 fairlead;
    Vec3 anchor;
    std::vector<Vec3> course;
    bool hangs = false;

    /// Of a structure whose axis is at `x`.
    Figure::Points from_abeam(double x) const {
        Figure::Points points;
        for (const Vec3& point : course) points.emplace_back(point.x() - x, point.y());
        return points;
    }
};

std::vector<LaidLine> laid_lines(const Scenario& scenario, const PlanarPose& start) {
    const Moorings& moorings = scenario.moorings;
    std::vector<LaidLine> lines;
    const Vec3 place(start.x, 0, start.z);
    for (std::size_t k = 0; moorings.give_way() && k < moorings.line_count(); ++k) {
        const LinePull at_rest = pull(moorings, k, Vec6::Zero());
        lines.push_back({place + at_rest.fairlead, place + at_rest.anchor,
                         course(moorings, k, place + at_rest.fairlead, place + at_rest.anchor),
                         k >= moorings.lines.size()});
    }
    return lines;
}

/// All that is drawn of a case.
struct Drawn {
    const Scenario& scenario;
    FloeSet floes;
    Way way;
    std::vector<LaidLine> lines;

    const PlanarPose& start() const { return way.poses.front(); }
    const Shape& shape() const { return scenario.structure.shape; }
};

/// Hull, ice and banks; and of the way as much as leaves them large enough to be seen.
Seen seen_from_above(const Drawn& of) {
    constexpr double longest = 5;  // times its breadth
    const Scenario& scenario = of.scenario;
    const double half = scenario.field.half_width + drawn_bank(scenario);
    Seen seen(Vec2(scenario.field.begin, -half), Vec2(scenario.field.begin, half));
    extend(seen, widest_outline(of.shape(), of.start()));
    for (const Figure::Points& outline : waterlines_at(of.shape(), of.start())) extend(seen, outline);
    for (std::size_t i = 0; i < of.floes.size(); ++i)
        extend(seen, floe_from_above(of.floes.shape(i), of.floes.floes[i].pose));
    if (!scenario.field.endless()) seen.extend(Vec2(scenario.field_end() + drawn_bank(scenario), 0));
    const double most = std::max(seen.max().x(), seen.min().x() + longest * 2 * half);
    for (const PlanarPose& pose : of.way.poses)
        for (const Figure::Points& outline : waterlines_at(of.shape(), pose)) extend(seen, outline);
    seen.max().x() = std::min(seen.max().x(), most);
    const double air = 0.015 * seen.sizes().x();
    return Seen(seen.min() - Vec2(air, 0), seen.max() + Vec2(air, 0));
}

/// Points of the way from one pose to another.
Figure::Points way_points(const Way& way, std::size_t from, std::size_t to) {
    Figure::Points points;
    for (std::size_t k = from; k <= to; ++k) points.emplace_back(way.poses[k].x, way.poses[k].z);
    return points;
}

std::string time_text(double time) {
    return fmt::format("{:.6g} s", time);
}

void add_way(Figure& plan, const Drawn& of) {
    const Way& way = of.way;
    const double head = 0.016 * (plan.x.high - plan.x.low);
    const std::size_t last = way.poses.size() - 1;
    add_clipped(plan, way_points(way, 0, way.first_measured), "c0");
    add_clipped(plan, way_points(way, way.first_measured, last), "c1 thick");
    const double run = of.scenario.analysis.steady_start;
    for (Figure::Points outline : waterlines_at(of.shape(), way.poses[last])) {
        outline.push_back(outline.front());
        add_clipped(plan, outline, "dashed");
    }
    const PlanarPose& measured = way.poses[way.first_measured];
    if (measured.x < plan.x.high) plan.dot(measured.x, measured.z, "c1", 4);
    const Vec2 end = place_of(way.poses[last]);
    if (end.x() > plan.x.high) {
        const std::string from =
            measured.x > plan.x.high ? fmt::format("{:.4g} m, measured from there to ", measured.x) : "";
        plan.text(plan.x.high - 0.5 * head, way.poses[last].z - head,
                  fmt::format("on to x = {}{:.4g} m", from, end.x()), "end", "halo");
    } else {
        for (std::size_t k = last; k-- > 0;) {
            const Vec2 before = place_of(way.poses[k]);
            if ((end - before).norm() < head) continue;
            add_arrow(plan, before, end, head, "c1");
            break;
        }
    }
    if (way.first_measured > 0)
        plan.legend.emplace_back("c0", fmt::format("way through the ice until {}", time_text(run)));
    plan.legend.emplace_back("c1", fmt::format("measured: {} to {}", time_text(run), time_text(way.time(last))));
    if (end.x() <= plan.x.high) plan.legend.emplace_back("", "dashed: hull at the end");
}

bool leaves(const Figure& plan, const LaidLine& line) {
    return line.anchor.x() < plan.x.low || line.anchor.x() > plan.x.high || line.anchor.z() < plan.y.low ||
           line.anchor.z() > plan.y.high;
}

void add_lines(Figure& plan, const Drawn& of) {
    for (const LaidLine& line : of.lines) {
        Figure::Points points;
        for (const Vec3& point : line.course) points.emplace_back(point.x(), point.z());
        add_clipped(plan, points, "c3");
        plan.dot(line.fairlead.x(), line.fairlead.z(), "c3", 2);
        if (!leaves(plan, line)) plan.cross(line.anchor.x(), line.anchor.z(), "c3 thick", 4);
    }
    if (!of.lines.empty()) plan.legend.emplace_back("c3", "mooring lines, × anchors");
    const Turret& turret = of.scenario.moorings.turret;
    if (!of.scenario.moorings.give_way() || !turret.any()) return;
    const Vec2 at = place_of(of.start()) + turned({turret.ahead, 0}, of.start().yaw);
    plan.dot(at.x(), at.y(), "c2", 4);
    plan.legend.emplace_back("c2", "turret");
}

/// Where the hull goes at first, rad from +x towards +z.
double first_heading(const Way& way) {
    const Vec2 start = place_of(way.poses.front());
    for (const PlanarPose& pose : way.poses)
        if (const Vec2 gone = place_of(pose) - start; gone.norm() > 0) return std::atan2(gone.y(), gone.x());
    return 0;
}

/// Arrows of equal length for what moves: from the upper left, one after the other.
void add_streams(Figure& plan, const Drawn& of) {
    const Scenario& scenario = of.scenario;
    struct Stream {
        std::string words;
        double direction;  ///< rad, from +x towards +z
    };
    const double heading = first_heading(of.way);
    const bool passes = scenario.moorings.give_way() || (scenario.path.of == PathOf::ice && scenario.path.any()) ||
                        scenario.field.level_pushed;
    std::vector<Stream> streams{passes ? Stream{"drift of the ice", heading + std::numbers::pi}
                                       : Stream{scenario.path.any() ? "path" : "tow", heading}};
    if (scenario.water.current > 0)
        streams.push_back(
            {fmt::format("current {:.3g} m/s", scenario.water.current), scenario.water.current_direction});
    if (scenario.wind.speed > 0)
        streams.push_back({fmt::format("wind {:.3g} m/s", scenario.wind.speed), scenario.wind.direction});
    const double width = plan.x.high - plan.x.low;
    const double length = 0.035 * width;
    Vec2 at(plan.x.low + 0.015 * width + length / 2, plan.y.low + 0.6 * length);
    for (const Stream& stream : streams) {
        const Vec2 way = length / 2 * Vec2(std::cos(stream.direction), std::sin(stream.direction));
        add_arrow(plan, at - way, at + way, 0.35 * length, "");
        plan.text(at.x() + 0.65 * length, at.y(), stream.words, "start", "halo");
        at.x() += 1.8 * length + 7.5 / plan.size.width * width * static_cast<double>(stream.words.size());
    }
}

Figure plan_of(const Drawn& of) {
    const Scenario& scenario = of.scenario;
    Figure plan = plan_figure(seen_from_above(of), "Hull, ice and way from above, at the start", widest);
    add_banks(plan, scenario);
    add_floes(plan, of.floes);
    add_hull(plan, of.shape(), of.start());
    add_clipped(plan, widest_outline(of.shape(), of.start()), "thin");
    add_lines(plan, of);
    add_way(plan, of);
    if (scenario.field.endless()) {
        for (const double x : {of.start().x + scenario.window_ahead(), of.start().x - scenario.window_behind()})
            if (x > plan.x.low && x < plan.x.high) plan.upright(x, "dotted");
    }
    add_streams(plan, of);
    add_scale_bar(plan);
    plan.caption = fmt::format(
        "From above, to scale, before the first step. Blue: floes; grey: ice sheets; yellow: what the hull cuts out of "
        "the water{}.",
        widest_outline(of.shape(), of.start()).empty() ? "" : ", within the hull at its widest");
    if (scenario.field.endless())
        plan.caption += " Dotted: up to there floes are computed; more ice is laid as the hull goes on.";
    return plan;
}

/// The hull from abeam with the beginnings of its lines.
Figure hull_of(const Drawn& of) {
    const Shape& shape = of.shape();
    Figure figure = elevation_of(of.scenario, "from the axis, ", 0.6 * widest);
    for (const LaidLine& line : of.lines)
        if (line.hangs) add_clipped(figure, line.from_abeam(of.start().x), "c3");
    const Turret& turret = of.scenario.moorings.turret;
    if (of.scenario.moorings.give_way() && turret.any()) figure.upright(turret.ahead, "dotted c2");
    figure.caption = fmt::format(
        "The hull from abeam, to scale, its bow to the right: draught {:.4g} m, {:.4g} m above the water; the ice "
        "beside it is {:.4g} m thick{}.",
        shape.draught(), shape.top(), of.scenario.floe.thickness,
        of.scenario.water.has_bed() ? fmt::format(", the bed {:.4g} m below the water", of.scenario.water.depth) : "");
    return figure;
}

/// All lines to their anchors from above, and the ice among them.
Figure anchors_of(const Drawn& of) {
    Seen seen;
    for (const Figure::Points& outline : waterlines_at(of.shape(), of.start())) extend(seen, outline);
    for (const LaidLine& line : of.lines) seen.extend(Vec2(line.anchor.x(), line.anchor.z()));
    const Vec2 air = Vec2::Constant(0.06 * seen.sizes().maxCoeff());
    seen = Seen(seen.min() - air, seen.max() + air);
    Figure figure = plan_figure(seen, "Mooring lines and anchors from above, at the start", 0.75 * widest);
    for (std::size_t i = 0; i < of.floes.size(); ++i) {
        Figure::Points points = floe_from_above(of.floes.shape(i), of.floes.floes[i].pose);
        if (std::ranges::all_of(points, [&](const auto& one) { return seen.contains(Vec2(one.first, one.second)); }))
            figure.area(std::move(points), "ice");
    }
    add_hull(figure, of.shape(), of.start());
    add_lines(figure, of);
    add_scale_bar(figure);
    figure.caption = "The moorings from above, to scale, at the start.";
    return figure;
}

/// Lines that hang, from abeam, down to the bed.
Figure hanging_of(const Drawn& of) {
    Seen seen;
    double depth = 0;
    const double x = of.start().x;
    for (const LaidLine& line : of.lines) {
        if (!line.hangs) continue;
        depth = std::max(depth, -line.anchor.y());
        extend(seen, line.from_abeam(x));
    }
    seen.extend(Vec2(0, of.shape().top()));
    const double air = 0.08 * seen.sizes().y();
    seen = Seen(Vec2(seen.min().x() - 2 * air, -depth - air), Vec2(seen.max().x() + 2 * air, seen.max().y() + air));
    Figure figure{.description = "Mooring lines from abeam, down to the bed",
                  .x = {"from the axis, m", seen.min().x(), seen.max().x()},
                  .y = {"height, m", seen.min().y(), seen.max().y()},
                  .size = to_scale(seen.sizes().x(), seen.sizes().y(), widest)};
    const auto slab = [&](double low, double high, const std::string& style) {
        figure.area({{figure.x.low, low}, {figure.x.high, low}, {figure.x.high, high}, {figure.x.low, high}}, style);
    };
    slab(-depth, 0, "water");
    slab(figure.y.low, -depth, "sheet");
    add_hull_from_abeam(figure, of.shape());
    for (const LaidLine& line : of.lines) {
        if (!line.hangs) continue;
        figure.line(line.from_abeam(x), "c3");
        figure.cross(line.anchor.x() - x, line.anchor.y(), "c3 thick", 4);
    }
    figure.caption =
        fmt::format("Mooring lines from abeam, to scale, down to their anchors in {:.4g} m of water.", depth);
    return figure;
}

// In words.

std::string hull_line(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const Vec2 size = waterline_size(shape);
    return fmt::format("Hull: {:.4g} m x {:.4g} m at the waterline, {:.4g} m of draught; {}.", size.x(), size.y(),
                       shape.draught(), motion_words(scenario).text());
}

std::string run_line(const Scenario& scenario, const Way& way) {
    const Analysis& analysis = scenario.analysis;
    std::vector<std::string> times;
    for (const double time : scenario.averaging_times()) times.push_back(fmt::format("{:g}", time));
    const double end = analysis.steady_start + analysis.window;
    return fmt::format("Run: {:.4g} m in {}; loads are measured from {} to {}, in {} of {}{}.", way.length,
                       time_text(end), time_text(analysis.steady_start), time_text(end),
                       counted(analysis.segments, "segment"), time_text(analysis.window / analysis.segments),
                       times.empty() ? "" : fmt::format(", averaged over {} s", fmt::join(times, ", ")));
}

std::string numbers(const Campaign& campaign, const Drawn& of) {
    const std::string ice = floe_words(of.scenario).text();
    return fmt::format("Ice: {}; drawn are {} of {:.0f} elements.\n{}\n{}\n{} x {} = {}.\n", ice,
                       counted(std::ssize(of.floes.floes), "floe"), element_count(of.floes), hull_line(of.scenario),
                       run_line(of.scenario, of.way), capital(counted(std::ssize(campaign.cases), "case")),
                       counted(campaign.arrangements, "arrangement"), counted(member_count(campaign), "member"));
}

// What is seldom meant.

/// The first pose on its way at which the hull's waterline touches a floe that still lies where it was laid.
std::optional<std::size_t> first_meeting(const Shape& shape, const FloeSet& floes, const Way& way) {
    std::vector<Outline> ice;
    std::vector<double> reaches;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        Outline& outline = ice.emplace_back();
        for (const auto& [x, z] : floe_from_above(floes.shape(i), floes.floes[i].pose)) outline.push_back({x, z});
        reaches.push_back(reach_of(floes.shape(i).corners()));
        outline = convex_hull(std::move(outline));
    }
    for (std::size_t k = 0; k < way.poses.size(); ++k) {
        const Vec2 at = place_of(way.poses[k]);
        for (const Figure::Points& points : waterlines_at(shape, way.poses[k])) {
            Outline hull;
            for (const auto& [x, z] : points) hull.push_back({x, z});
            hull = convex_hull(std::move(hull));
            for (std::size_t i = 0; i < ice.size(); ++i) {
                const Vec2 apart = place_of(floes.floes[i].pose) - at;
                if (apart.norm() > shape.largest_radius() + reaches[i]) continue;
                if (separation(hull, ice[i]) <= 0) return k;
            }
        }
    }
    return std::nullopt;
}

/// Of the way to the first floe.
std::string far_ice(const Scenario& scenario, const FloeSet& floes, const Way& way) {
    const std::optional<std::size_t> met = first_meeting(scenario.structure.shape, floes, way);
    if (!met) {
        // Of a field without end the ice that is not laid yet may well lie there.
        if (scenario.field.endless()) return "";
        return "no floe lies on the way of the hull: it measures open water; look at structure.start_m, path and field";
    }
    double gone = 0;
    for (std::size_t k = 0; k < *met; ++k) gone += (place_of(way.poses[k + 1]) - place_of(way.poses[k])).norm();
    const double side = std::sqrt(covered_area(floes) / static_cast<double>(floes.size()));
    if (gone <= side + way.length / static_cast<double>(way.poses.size())) return "";
    return fmt::format(
        "the hull goes {:.3g} m before it meets a floe, {:.3g} s, and a floe is {:.3g} m long; a start nearer to it "
        "(structure.start_m) saves that time",
        gone, way.time(*met), side);
}

/// Of the hull past the last floe while loads are measured.
std::string past_the_ice(const Scenario& scenario, const FloeSet& floes, const Way& way) {
    constexpr double much = 0.05;  // of the window
    if (scenario.field.endless()) return "";
    double end = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < floes.size(); ++i)
        for (const auto& [x, z] : floe_from_above(floes.shape(i), floes.floes[i].pose)) end = std::max(end, x);
    const double ahead = scenario.structure.shape.waterline_ahead();
    const auto past = std::ranges::count_if(way.poses.begin() + static_cast<std::ptrdiff_t>(way.first_measured),
                                            way.poses.end(), [&](const PlanarPose& at) { return at.x + ahead > end; });
    const double share = static_cast<double>(past) / static_cast<double>(way.poses.size() - way.first_measured);
    if (share < much) return "";
    return fmt::format(
        "in {:.3g} % of the window the bow is past the last floe, which ends at x = {:.4g} m; take more floes "
        "(field.floes), or measure earlier",
        share / unit::percent, end);
}

/// Of lines whose azimuth turns them under the hull.
std::string crossing_line(const Scenario& scenario) {
    const Moorings& moorings = scenario.moorings;
    if (!moorings.give_way() || moorings.turret.lines) return "";
    std::vector<std::string> crossing;
    for (std::size_t k = 0; k < moorings.line_count(); ++k) {
        const LinePull at_rest = pull(moorings, k, Vec6::Zero());
        const Vec2 fairlead(at_rest.fairlead.x(), at_rest.fairlead.z());
        const Vec2 way = Vec2(at_rest.anchor.x(), at_rest.anchor.z()) - fairlead;
        if (fairlead.norm() < 0.1 * scenario.structure.shape.largest_radius()) continue;
        if (fairlead.dot(way) < -0.5 * fairlead.norm() * way.norm()) crossing.push_back(fmt::format("{}", k + 1));
    }
    if (crossing.empty()) return "";
    return fmt::format("mooring {} {} {} from {} fairlead{} across the hull; azimuths count from +x (0°) to +z (90°)",
                       crossing.size() == 1 ? "line" : "lines", name_list(crossing),
                       crossing.size() == 1 ? "leads" : "lead", crossing.size() == 1 ? "its" : "their",
                       crossing.size() == 1 ? "" : "s");
}

/// Of a hull from a file, whose axes are easily mistaken.
std::string hull_on_its_side(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const double longest = waterline_size(shape).maxCoeff();
    const double height = shape.top() - shape.bottom();
    if (shape.kind() != HullKind::file || height <= longest) return "";
    return fmt::format(
        "the hull is {:.4g} m high and at the waterline {:.4g} m long at most: if it lies on its side, "
        "another hull.up sets it upright",
        height, longest);
}

}  // namespace

std::vector<std::string> scene_oddities(const Scenario& scenario, const FloeSet& floes) {
    const Way way = way_of(scenario);
    std::vector<std::string> found{far_ice(scenario, floes, way), past_the_ice(scenario, floes, way),
                                   crossing_line(scenario), hull_on_its_side(scenario)};
    std::erase(found, "");
    return found;
}

Section scene(const Campaign& campaign, std::size_t of_case, int arrangement) {
    const Case& one = campaign.cases.at(of_case);
    const Way way = way_of(one.scenario);
    const Drawn drawn{one.scenario, laid_floes(campaign, of_case, arrangement), way,
                      laid_lines(one.scenario, way.poses.front())};
    Section told{.title = fmt::format("{}{}, arrangement {}", campaign.name,
                                      campaign.cases.size() > 1 ? ", case " + one.name : "", arrangement),
                 .before = numbers(campaign, drawn),
                 .figures = {plan_of(drawn), hull_of(drawn)}};
    for (const std::string& sentence : scene_oddities(one.scenario, drawn.floes))
        told.notes.push_back(capital(sentence) + ".");
    const Figure& plan = told.figures.front();
    if (std::ranges::any_of(drawn.lines, [&](const LaidLine& line) { return leaves(plan, line); }))
        told.figures.push_back(anchors_of(drawn));
    if (std::ranges::any_of(drawn.lines, &LaidLine::hangs)) told.figures.push_back(hanging_of(drawn));
    return told;
}

}  // namespace floes
