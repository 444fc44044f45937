// What was run, drawn: hulls, single floes, the load over time, and how floes lay in the member with the largest load.

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "arrangement/arrangement.hpp"
#include "campaign_file/read.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/plan_view.hpp"
#include "findings/sections.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

namespace {

constexpr std::size_t most_figures = 12;  // of hulls, and of floes

/// "E30, E60: ", the cases of one drawing of several; empty of the only one.
std::string names_of(const std::vector<std::size_t>& cases, std::size_t drawings, const Summary& summary) {
    return drawings < 2 ? "" : label_list(summary, cases) + ": ";
}

/// What is drawn of a case: floes by area.
std::vector<FloeShape> drawn_floes(const Campaign& campaign, std::size_t of_case) {
    const Scenario& scenario = campaign.cases[of_case].scenario;
    std::vector<FloeShape> shapes =
        floes_of(scenario, {arrangement_seed(campaign, static_cast<int>(of_case)), 0}).shapes;
    if (!sizes_may_differ(scenario) && !scenario.shapes.any()) return {shapes.front()};
    for (FloeShape& shape : shapes) shape.thickness = scenario.floe.thickness;  // not seen from above
    std::ranges::stable_sort(shapes, {}, &FloeShape::area);
    std::vector<FloeShape> drawn;
    for (const FloeShape& shape : {shapes.front(), shapes[shapes.size() / 2], shapes.back()})
        if (std::ranges::find(drawn, shape) == drawn.end()) drawn.push_back(shape);
    return drawn;
}

void add_floe(Figure& figure, const FloeShape& floe, double x) {
    const CutFloe cut = floe.cut();
    const double left = std::ranges::min(floe.corners(), {}, &Corner::x).x;
    for (const CutElement& element : cut.elements) {
        Figure::Points points;
        for (const Corner& corner : from_axes(element.corners, element.centre, element.axis)) {
            const Corner inside = element.centre + 0.97 * (corner - element.centre);
            points.emplace_back(x + inside.x - left, inside.z);
        }
        figure.area(std::move(points), "ice");
    }
    for (const CutJoint& joint : cut.joints) figure.dot(x + joint.pivot.x - left, joint.pivot.z, "c1", 4);
}

Figure side_by_side(const std::vector<FloeShape>& floes, const std::string& names) {
    double length = 0;
    double breadth = 0;
    for (const FloeShape& floe : floes) {
        length += floe.length;
        breadth = std::max({breadth, floe.breadth, 0.2 * floe.length});
    }
    const double margin = 0.15 * std::max(length / static_cast<double>(floes.size()), breadth);
    length += margin * static_cast<double>(floes.size() - 1);
    const double half = 0.5 * breadth + margin + 0.1 * breadth;
    Figure figure{.description = "Floes seen from above: their elements, and the joints at the middle of common edges",
                  .x = {names + "along the floe, m", -margin, length + margin},
                  .y = {"across, m", -half, half},
                  .size = to_scale(length + 2 * margin, 2 * half, floes.size() > 1 ? 720 : 360)};
    double x = 0;
    for (const FloeShape& floe : floes) {
        add_floe(figure, floe, x);
        x += floe.length + margin;
    }
    return figure;
}

/// Once for all cases whose floes are alike: the floe, or where floes differ the smallest, the middle one and the
/// largest of the case's first arrangement.
std::vector<Figure> single_floes(Evidence& evidence) {
    const Campaign& campaign = evidence.campaign;
    const auto groups = grouped(campaign.cases.size(), [&](std::size_t k) {
        std::vector<FloeShape> drawn = drawn_floes(campaign, k);
        for (FloeShape& floe : drawn) floe.thickness = 0;  // cases that differ in it alone have one drawing
        return drawn;
    });
    const std::size_t count = std::min(groups.size(), most_figures);
    std::vector<Figure> figures;
    for (std::size_t k = 0; k < count; ++k)
        figures.push_back(side_by_side(groups[k].first, names_of(groups[k].second, groups.size(), evidence.summary)));
    const std::vector<FloeShape>& first = groups.front().first;
    const bool one_floe = groups.size() == 1 && first.size() == 1;
    figures.back().caption =
        one_floe ? fmt::format("A floe of {:g} m × {:g} m in {} of {:g} m; dots are breakable joints.",
                               first.front().length, first.front().breadth,
                               first.front().cut().squares ? "elements" : "cells", first.front().element)
                 : "Floes and their elements; where floes differ, the smallest, the middle one by area and the largest "
                   "of the first arrangement. Dots are breakable joints.";
    return figures;
}

/// Every hull once, with the names of its cases.
std::vector<Figure> hulls(const Campaign& campaign, const Summary& summary) {
    const auto groups =
        grouped(campaign.cases.size(), [&](std::size_t k) { return campaign.cases[k].scenario.structure.shape; });
    const std::size_t drawn = std::min(groups.size(), most_figures);
    std::vector<Figure> figures;
    for (std::size_t k = 0; k < drawn; ++k) {
        const std::vector<std::size_t>& cases = groups[k].second;
        figures.push_back(elevation_of(campaign.cases[cases.front()].scenario, names_of(cases, drawn, summary),
                                       drawn == 1 ? 720 : 400));
    }
    std::vector<double> values;
    for (const Case& one : campaign.cases) values.push_back(one.scenario.floe.thickness);
    const std::string thickness = range_text(values);
    figures.back().caption =
        fmt::format("The structure from abeam and the ice on the water, to scale; the ice is {} m thick{}.", thickness,
                    thickness.find("to") == std::string::npos ? "" : ", drawn as in the first case of each");
    if (drawn < groups.size())
        figures.back().caption += fmt::format(" {} of {} hulls are drawn.", drawn, groups.size());
    return figures;
}

}  // namespace

Section what_was_run(Evidence& evidence) {
    const MemberCounts counts = evidence.summary.counts();
    std::vector<Figure> figures = hulls(evidence.campaign, evidence.summary);
    std::ranges::move(single_floes(evidence), std::back_inserter(figures));
    return {.before = fmt::format("{}, each over up to {}: {} done, {} set aside as failed, {} not computed.\n",
                                  counted(std::ssize(evidence.summary.cases), "case"),
                                  counted(evidence.campaign.arrangements, "random arrangement"),
                                  counted(counts.done, "simulation"), counts.failed_members, counts.missing_members),
            .figures = std::move(figures)};
}

namespace {

constexpr std::size_t drawn_columns = 700;

struct DrawnHistory {
    std::size_t case_index = 0;
    int floes = 0;          ///< equal for those that began from the same floes
    Figure::Points points;  ///< s after the tow began, N
};

/// The smallest and the largest value of each column, in order of time, so that peaks are kept.
Figure::Points thinned(const StoredHistory& history) {
    Figure::Points points;
    const std::size_t width = std::max<std::size_t>(1, history.values.size() / drawn_columns);
    for (std::size_t first = 0; first < history.values.size(); first += width) {
        const auto column = history.values.subspan(first, std::min(width, history.values.size() - first));
        const auto [low, high] = std::ranges::minmax_element(column);
        const auto [early, late] = std::minmax(low, high);
        for (const auto& value : {early, late})
            points.emplace_back(history.step * static_cast<double>(first + 1 + (value - column.begin())), *value);
    }
    return points;
}

/// The number of the first arrangement that is done in every case; -1 if there is none. Cases whose fields differ have
/// other floes under one number.
int common_arrangement(const Sample& sample) {
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < sample.cases.size(); ++k)
        for (const std::size_t member : sample.done(k)) {
            const auto number = static_cast<std::size_t>(sample.number_of(member));
            if (number >= done.size()) done.resize(number + 1);
            ++done[number];
        }
    const auto found = std::ranges::find(done, sample.cases.size());
    return found == done.end() ? -1 : static_cast<int>(found - done.begin());
}

Figure history_figure(const Summary& summary, std::vector<DrawnHistory> histories) {
    double largest = 0;
    double end = 0;
    for (const DrawnHistory& history : histories) {
        for (const auto& [time, load] : history.points) {
            largest = std::max(largest, load);
            end = std::max(end, time);
        }
    }
    const double shift = largest > 0 ? round_above(0.7 * largest) : 1;
    const double count = static_cast<double>(histories.size());
    Figure figure{.description = "Surge load over time, one curve for each case",
                  .x = {count > 1 ? fmt::format("time since the tow began, s; each case shifted by {:g} N", shift)
                                  : std::string{"time since the tow began, s"},
                        0, std::max(end, 1e-3)},
                  .y = {"surge load, N", 0, shift * (count - 1) + std::max(1.05 * largest, 0.6 * shift)},
                  .size = {720, 160 + 90 * count}};
    double base = 0;
    for (DrawnHistory& history : histories) {
        for (auto& [time, load] : history.points) load += base;
        const CaseRow& about = summary.cases[history.case_index].about;
        figure.line(std::move(history.points), colour(history.case_index) + " thin");
        figure.text(end * 0.01, base + 0.45 * shift, summary.label_of(history.case_index), "start",
                    "key " + colour(history.case_index));
        figure.upright(about.analysis.steady_start, "dashed");
        base += shift;
    }
    return figure;
}

}  // namespace

Section histories_section(Evidence& evidence) {
    std::vector<DrawnHistory> histories;
    const Sample& sample = evidence.sample;
    const int arrangement = common_arrangement(sample);
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    for_each_history(evidence.file, [&](const StoredHistory& history) {
        const auto member = static_cast<std::size_t>(history.member);
        if (sample.number_of(member) == arrangement && std::ranges::count(drawn, sample.case_of(member)))
            histories.push_back({sample.case_of(member), sample.arrangement_of(member), thinned(history)});
    });
    if (histories.empty())
        return {.before = "No figure: the file has no load histories of an arrangement that is done in every case.\n"};
    const bool same = std::ranges::all_of(
        histories, [&](const DrawnHistory& history) { return history.floes == histories.front().floes; });
    Figure figure = history_figure(evidence.summary, std::move(histories));
    figure.caption = std::string(evidence.summary.cases.size() < 2 ? "One arrangement"
                                 : same                            ? "One arrangement, every case, shifted upwards"
                                        : "One run of every case, shifted upwards; they begin from different floes") +
                     ". Dashed: start of the analysis window." + undrawn_text(evidence.summary);
    if (std::ranges::any_of(evidence.sample.cases, [](const CaseRow& one) { return one.analysis.history_stride > 1; }))
        figure.caption += " The file holds means over several steps, whose peaks are lower than the measured ones.";
    return {.figures = {std::move(figure)}};
}

namespace {

Figure plan_view(const Scenario& scenario, const FloeSet& floes, const std::set<int>& broken) {
    const Field& field = scenario.field;
    const double radius = scenario.structure.shape.largest_radius();
    const double bank = drawn_bank(scenario);
    const double half = field.half_width + bank;
    const Seen seen(Vec2(std::min(scenario.structure.start - radius, field.begin) - bank, -half),
                    Vec2(scenario.field_end() + bank, half));
    Figure figure = plan_figure(seen, "The floes at the start, from above; floes that broke are marked", 720);
    add_banks(figure, scenario);
    add_floes(figure, floes, broken);
    add_hull(figure, scenario.structure.shape, {scenario.structure.start, 0, 0});
    return figure;
}

}  // namespace

Section largest_load_section(Evidence& evidence) {
    const std::optional<int> number = most_loaded_member(evidence);
    if (!number || evidence.pictured) return {};
    const std::size_t of_case = evidence.case_of(*number);
    std::set<int> broken;
    for (const BreakRow& row : breaks_of(evidence))
        if (row.member == *number) broken.insert(row.floe);
    const Scenario& scenario = evidence.campaign.cases[of_case].scenario;
    const std::uint64_t seed = arrangement_seed(evidence.campaign, static_cast<int>(of_case));
    const auto arrangement = static_cast<std::uint32_t>(member_key(evidence.campaign, *number).arrangement);
    // Without an end the first floes are of several draws, in the order of their places.
    const bool drawn_in_parts = scenario.field.endless() && !scenario.arrangement.level();
    FloeSet floes =
        drawn_in_parts ? make_arrangement(scenario, seed, arrangement) : floes_of(scenario, {seed, arrangement});
    const std::vector<PlanarPose> poses = read_poses(evidence.file, *number);
    for (std::size_t i = 0; i < floes.size(); ++i) floes.floes[i].pose = poses.at(i);
    Figure figure = plan_view(scenario, floes, broken);
    const auto value = [&](const char* key) {
        return evidence.sample.value(static_cast<std::size_t>(*number), *find_quantity(key));
    };
    figure.caption =
        fmt::format("Member {}, case {}: largest load {}, mean {}, {:.1f} % of the floes broke (marked).", *number,
                    evidence.summary.name_of(of_case), evidence.units.text(value("maximum_load"), "N"),
                    evidence.units.text(value("mean_load"), "N"), value("failure_ratio") / unit::percent);
    return {.notes = {"To watch it: " + replay_command(evidence, *number)}, .figures = {std::move(figure)}};
}

}  // namespace floes
