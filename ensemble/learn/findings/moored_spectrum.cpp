#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "campaign_file/read_history.hpp"
#include "core/units.hpp"
#include "findings/moored_cases.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr std::size_t periods_shown = 16;

/// Largest k x over the largest averaged load at one natural period.
struct Point {
    std::size_t case_index;
    double period;  ///< s at full scale
    Interval amplification;
};

/// A hull of this natural period, s at full scale; its stiffness does not matter to the ratio.
MooredRequest hull_of(double period, double damping_ratio, double averaging, double scale) {
    const double omega = 2 * std::numbers::pi / period;
    return {{1, 1 / (omega * omega), damping_ratio}, scale, averaging};
}

struct Range {
    double low = HUGE_VAL;
    double high = 0;
};

/// Of every case, at full scale: from the shortest period that its histories have to the longest that its window has.
Range range_of(const Evidence& evidence, double scale) {
    Range range;
    const double to_full = std::sqrt(scale);
    for (const CaseRow& one : evidence.table.cases) {
        const double step = one.time_step * one.analysis.history_stride;
        range.low = std::min(range.low, to_full * fewest_values * step * 1.001);
        range.high = std::max(range.high, to_full * one.analysis.window / fewest_periods * 0.999);
    }
    return range;
}

std::vector<double> periods_in(const Range& range) {
    std::vector<double> periods;
    for (std::size_t k = 0; k < periods_shown; ++k)
        periods.push_back(range.low * std::pow(range.high / range.low, static_cast<double>(k) / (periods_shown - 1.0)));
    return periods;
}

/// Of one case.
struct Ratios {
    double step = 0;
    double first_load = HUGE_VAL;              ///< s, the earliest
    std::vector<std::vector<double>> of_hull;  ///< of each member
};

std::vector<Point> points_of(const Evidence& evidence, const std::vector<MooredRequest>& hulls) {
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    std::map<std::size_t, Ratios> found;
    for_each_history(evidence.file, [&](const SurgeHistory& history) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(history.member)];
        const auto index = static_cast<std::size_t>(member.case_index);
        if (std::ranges::find(drawn, index) == drawn.end() ||
            evidence.campaign.cases[index].scenario.moorings.give_way())
            return;
        Ratios& one = found[index];
        one.step = history.step;
        one.of_hull.resize(hulls.size());
        for (std::size_t k = 0; k < hulls.size(); ++k) {
            const MooredRun run =
                moored_run(history.surge, history.step, evidence.table.cases[index].analysis, hulls[k]);
            one.first_load = std::min(one.first_load, run.first_load);
            if (run.load.mean_maximum > 0) one.of_hull[k].push_back(run.amplification());
        }
    });
    std::vector<Point> points;
    for (const auto& [index, one] : found)
        for (std::size_t k = 0; k < hulls.size(); ++k) {
            const Analysis& analysis = evidence.table.cases[index].analysis;
            if (!one.of_hull[k].empty() && moored_refusal(analysis, one.step, one.first_load, hulls[k]).empty())
                points.push_back({index, hulls[k].hull.period(), mean_interval(one.of_hull[k])});
        }
    return points;
}

Figure figure_of(const Evidence& evidence, const std::vector<Point>& points, const std::string& caption) {
    std::vector<double> heights{1};
    std::map<std::size_t, Figure::Points> curves;
    Range range;
    for (const Point& point : points) {
        heights.push_back(point.amplification.estimate);
        curves[point.case_index].emplace_back(point.period, point.amplification.estimate);
        range = {std::min(range.low, point.period), std::max(range.high, point.period)};
    }
    Figure figure{.description = "Largest mooring force over largest load, over the natural period",
                  .x = {"natural period, s", range.low, range.high, true},
                  .y = axis_around("largest k x / largest load", heights, true),
                  .legend = case_legend(evidence.summary),
                  .caption = caption + undrawn_text(evidence.summary)};
    figure.level(1, "dashed");
    for (auto& [index, curve] : curves) {
        for (const Point& point : points)
            if (point.case_index == index && std::isfinite(point.amplification.low))
                figure.line({{point.period, point.amplification.low}, {point.period, point.amplification.high}},
                            colour(index) + " thin");
        figure.line(std::move(curve), colour(index));
    }
    if (evidence.moored) figure.upright(evidence.moored->hull.period(), "dotted");
    return figure;
}

Table table_of(const Summary& summary, const std::vector<Point>& points) {
    std::map<double, std::map<std::size_t, double>> found;
    std::vector<std::size_t> cases;
    for (const Point& point : points) {
        found[point.period][point.case_index] = point.amplification.estimate;
        if (std::ranges::find(cases, point.case_index) == cases.end()) cases.push_back(point.case_index);
    }
    Table table{{"natural period, s"}};
    for (const std::size_t index : cases) table.front().emplace_back(summary.label_of(index));
    for (const auto& [period, of_case] : found) {
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(fmt::format("{:.3g}", period));
        for (const std::size_t index : cases)
            line.emplace_back(of_case.contains(index) ? fixed(of_case.at(index), 2) : "–");
    }
    return table;
}

}  // namespace

Section moored_spectrum(const Evidence& evidence, double damping_ratio, double averaging, double scale) {
    const Range range = range_of(evidence, scale);
    std::vector<MooredRequest> hulls;
    if (range.low < range.high)
        for (const double period : periods_in(range)) hulls.push_back(hull_of(period, damping_ratio, averaging, scale));
    const std::vector<Point> points = points_of(evidence, hulls);
    if (points.empty())
        return {.missing =
                    "Moored hull: unknown, because the file keeps no load histories (analysis.history_steps), or "
                    "their run-up and window are too short for any natural period.\n"};
    const std::string caption = fmt::format(
        "Largest mooring force k x over the largest load averaged over {:g} s, for hulls of any natural period "
        "with {:g} % of the critical damping: what moorings make of these loads.",
        averaging, damping_ratio / unit::percent);
    DataRows records =
        make_rows<Point>("moored/spectrum", points,
                         {{"case", [&](const Point& one) { return evidence.summary.name_of(one.case_index); }},
                          {"period_s", &Point::period},
                          {"damping_ratio", [=](const Point&) { return damping_ratio; }},
                          {"amplification", [](const Point& one) { return one.amplification.estimate; }},
                          {"low", [](const Point& one) { return one.amplification.low; }},
                          {"high", [](const Point& one) { return one.amplification.high; }}});
    return {.title = "Response spectrum",
            .table = table_of(evidence.summary, points),
            .after = "\n" + caption + undrawn_text(evidence.summary) + "\n",
            .records = {std::move(records)},
            .figures = {figure_of(evidence, points, "Dashed: the moorings feel the load as it is.")}};
}

}  // namespace floes
