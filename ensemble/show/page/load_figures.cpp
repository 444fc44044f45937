// Figures of loads: over time, across arrangements, in pairs, over the number of arrangements.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "findings/paper_table3.hpp"
#include "page/case_colours.hpp"
#include "page/plot.hpp"
#include "page/report_figures.hpp"

namespace floes {
namespace {

/// Done members of a case in order of arrangement.
std::vector<const MemberRow*> done_members(const ReportData& data, std::size_t of_case) {
    std::vector<const MemberRow*> members;
    for (const MemberRow& member : data.table.members) {
        if (member.done() && member.case_index == static_cast<int>(of_case)) members.push_back(&member);
    }
    return members;
}

/// Reverses the names, so that the first one is at the top.
std::vector<std::string> from_the_bottom(std::vector<std::string> names) {
    std::ranges::reverse(names);
    return names;
}

double height_for(std::size_t rows) {
    return 70 + 34 * static_cast<double>(rows);
}

}  // namespace

std::string histories_figure(const ReportData& data) {
    std::vector<double> loads;
    double end = 1;
    for (const DrawnHistory& history : data.histories) {
        for (const auto& [time, load] : history.points) {
            loads.push_back(load);
            end = std::max(end, time);
        }
    }
    const double largest = loads.empty() ? 1 : std::ranges::max(loads);
    const double shift = std::max(100.0, 100 * std::ceil(0.7 * largest / 100));
    const double count = static_cast<double>(data.histories.size());
    Plot plot("Surge load over time, one curve for each case",
              {fmt::format("time since the tow began, s; each case shifted by {:g} N", shift), 0, end},
              {"surge load, N", 0, std::max(1.0, shift * (count - 1) + 1.05 * largest)}, {720, 160 + 90 * count});
    for (std::size_t i = 0; i < data.histories.size(); ++i) {
        const DrawnHistory& history = data.histories[i];
        const double base = shift * static_cast<double>(i);
        Plot::Points points = history.points;
        for (auto& [time, load] : points) load += base;
        const auto style = colour(static_cast<std::size_t>(history.case_index));
        plot.line(points, style + " thin");
        const CaseRow& about = data.summary.cases[static_cast<std::size_t>(history.case_index)].about;
        plot.text(end * 0.01, base + 0.45 * shift, about.name, "start", "key " + style);
        plot.upright(about.analysis.steady_start, "dashed");
    }
    return plot.svg();
}

std::string strips_figure(const ReportData& data, const Quantity& quantity) {
    const double factor = quantity.factor();
    const auto& cases = data.summary.cases;
    std::vector<double> values;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        for (const MemberRow* member : done_members(data, i)) values.push_back(factor * quantity.of(*member));
        const Estimate& estimate = cases[i].of(quantity);
        values.insert(values.end(), {factor * estimate.prediction_low, factor * estimate.prediction_high});
    }
    Plot plot(fmt::format("{} of every arrangement, with the mean of each case", quantity.label),
              axis_around(std::string(quantity.label.view()), values, true),
              {"", 0, static_cast<double>(cases.size()), false, from_the_bottom(case_names(data))},
              {720, height_for(cases.size())});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double middle = static_cast<double>(cases.size() - i) - 0.5;
        const Estimate& estimate = cases[i].of(quantity);
        plot.line(
            {{factor * estimate.prediction_low, middle - 0.28}, {factor * estimate.prediction_high, middle - 0.28}},
            "dashed");
        plot.line({{factor * estimate.low, middle - 0.28}, {factor * estimate.high, middle - 0.28}}, "thick");
        plot.dot(factor * estimate.estimate, middle - 0.28, "ink", 4.5);
        int turn = 0;  // spreads dots over the strip's height, always in the same way
        for (const MemberRow* member : done_members(data, i)) {
            const double lift = 0.08 * (turn++ * 2 % 5);
            plot.dot(factor * quantity.of(*member), middle - 0.04 + lift, colour(i) + " faint");
        }
    }
    return plot.svg();
}

std::string pairs_figure(const ReportData& data, const Quantity& quantity) {
    const double factor = quantity.factor();
    const std::vector<std::string> names = case_names(data);
    std::vector<const PairRow*> rows;
    std::vector<std::string> labels;
    std::vector<double> values{0};
    for (const PairRow& row : *data.pairs) {
        if (!(row.quantity.key == quantity.key)) continue;
        rows.push_back(&row);
        labels.push_back(names[row.second] + " − " + names[row.first]);
        values.insert(values.end(), {factor * row.found.t_interval.low, factor * row.found.t_interval.high,
                                     factor * row.found.difference});
    }
    if (rows.empty()) return "";
    Plot plot(fmt::format("Paired differences of {}", quantity.label),
              axis_around(fmt::format("difference of {} within an arrangement, 95 % interval", quantity.label), values,
                          false),
              {"", 0, static_cast<double>(rows.size()), false, from_the_bottom(labels)},
              {720, height_for(rows.size())});
    plot.upright(0, "dashed");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double at = static_cast<double>(rows.size() - i) - 0.5;
        plot.line({{factor * rows[i]->found.t_interval.low, at}, {factor * rows[i]->found.t_interval.high, at}},
                  "thick");
        plot.dot(factor * rows[i]->found.difference, at, "ink", 4.5);
    }
    return plot.svg();
}

std::string convergence_figure(const ReportData& data) {
    struct Curve {
        Plot::Points mean;
        Plot::Points low;
        Plot::Points high;
    };
    std::vector<Curve> curves;
    std::vector<double> values;
    double most = 2;
    for (std::size_t i = 0; i < data.summary.cases.size(); ++i) {
        Curve& curve = curves.emplace_back();
        std::vector<double> so_far;
        for (const MemberRow* member : done_members(data, i)) {
            so_far.push_back(member->load.mean);
            if (so_far.size() < 3) continue;  // the interval of two arrangements is too wide to draw
            const double n = static_cast<double>(so_far.size());
            const Interval interval = mean_interval(so_far);
            curve.mean.emplace_back(n, interval.estimate);
            curve.low.emplace_back(n, interval.low);
            curve.high.emplace_back(n, interval.high);
            values.insert(values.end(), {interval.low, interval.high});
            most = std::max(most, n);
        }
    }
    Plot plot("Mean load over the number of arrangements, with its interval", {"arrangements", 0, 1.02 * most},
              axis_around("mean load, N", values, true));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Plot::Points band = curves[i].low;
        band.insert(band.end(), curves[i].high.rbegin(), curves[i].high.rend());
        plot.area(band, colour(i) + " veil");
        plot.line(curves[i].mean, colour(i));
    }
    plot.legend(case_legend(data));
    return plot.svg();
}

std::string failures_figure(const ReportData& data) {
    constexpr std::array modes{"bending", "shear", "compression"};
    constexpr std::array strokes{"", " dashed", " dotted"};
    const auto& cases = data.summary.cases;
    double end = 1;
    for (const CaseSummary& row : cases)
        end = std::max(end, row.about.analysis.steady_start + row.about.analysis.window);
    std::vector<std::pair<std::string, Plot::Points>> curves;
    std::vector<double> counts{1};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (cases[i].done == 0) continue;
        for (std::size_t mode = 0; mode < modes.size(); ++mode) {
            std::vector<double> times;
            for (const BreakRow& row : data.breaks) {
                const MemberRow& member = data.table.members[static_cast<std::size_t>(row.member)];
                if (member.case_index == static_cast<int>(i) && row.mode == static_cast<int>(mode))
                    times.push_back(row.time);
            }
            if (times.empty()) continue;
            std::ranges::sort(times);
            Plot::Points points{{0, 0}};
            for (std::size_t k = 0; k < times.size(); ++k) {
                points.emplace_back(times[k], points.back().second);
                points.emplace_back(times[k], static_cast<double>(k + 1) / cases[i].done);
            }
            points.emplace_back(end, points.back().second);
            counts.push_back(points.back().second);
            curves.emplace_back(colour(i) + strokes[mode], std::move(points));
        }
    }
    Plot plot("Failed joints over time by mode, mean over arrangements", {"time since the tow began, s", 0, end},
              axis_around("failed joints per run", counts, true));
    for (const auto& [style, points] : curves) plot.line(points, style);
    plot.legend(case_legend(data));
    return plot.svg();
}

}  // namespace floes
