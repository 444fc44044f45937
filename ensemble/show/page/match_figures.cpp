#include "page/match_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "page/plot.hpp"

namespace floes {
namespace {

/// For `rows` of names.
Size bars_size(std::size_t rows) {
    return {720, 84 + 24 * static_cast<double>(rows)};
}

double percent_of_range(double coordinate) {
    return (coordinate + 1) / 2 / unit::percent;
}

}  // namespace

std::string left_out_figure(const EmulatedTarget& target) {
    const Target& about = target.target();
    const double factor = about.quantity.factor();
    const double measured = about.value * factor;
    const std::vector<LeftOut>& points = target.mean().left_out();
    std::vector<double> simulated;
    std::vector<double> predicted;
    for (const LeftOut& one : points) {
        simulated.push_back(one.value * factor);
        predicted.push_back((one.predicted - 2 * one.sd) * factor);
        predicted.push_back((one.predicted + 2 * one.sd) * factor);
    }
    const std::string_view shown = about.quantity.percent ? "%" : about.quantity.unit;
    const std::string unit = shown.empty() ? "" : fmt::format(", {}", shown);
    const Axis across = axis_around("simulated" + unit, simulated, false);
    const Axis up = axis_around("predicted without it" + unit, predicted, false);
    Plot plot("Predictions of left-out points of " + about.name(), across, up, {250, 230});
    plot.legend({{"", about.name()}});
    const double low = std::max(across.low, up.low);
    const double high = std::min(across.high, up.high);
    if (low < high) plot.line({{low, low}, {high, high}}, "thin");
    if (measured > across.low && measured < across.high) plot.upright(measured, "dotted c2");
    for (const LeftOut& one : points) {
        const char* style = std::abs(one.standardised()) > 2 ? "c1" : "c0";
        const double x = one.value * factor;
        plot.line({{x, (one.predicted - 2 * one.sd) * factor}, {x, (one.predicted + 2 * one.sd) * factor}},
                  fmt::format("{} thin", style));
        plot.dot(x, one.predicted * factor, style, 2);
    }
    return plot.svg();
}

std::string ruled_out_figure(const std::vector<EmulatedTarget>& targets, const Matching& found) {
    std::vector<std::size_t> used;
    for (std::size_t k = targets.size(); k-- > 0;)
        if (targets[k].unused().empty()) used.push_back(k);
    if (used.empty()) return "";
    Axis up{"", 0, static_cast<double>(used.size())};
    for (const std::size_t k : used) up.names.push_back(targets[k].target().name());
    Plot plot("What each target rules out", {"share of the inputs' ranges, %", 0, 100}, up, bars_size(used.size()));
    plot.legend({{"c5", "ruled out"}, {"c0", "by no other target"}});
    for (std::size_t i = 0; i < used.size(); ++i) {
        const TargetVerdict& verdict = found.verdicts[used[i]];
        const double y = static_cast<double>(i) + 0.2;
        if (verdict.rules_out > 0) plot.cell(0, y, verdict.rules_out / unit::percent, 0.6, 0.6, "c5");
        if (verdict.alone > 0) plot.cell(0, y, verdict.alone / unit::percent, 0.6, 1, "c0");
    }
    return plot.svg();
}

std::string inputs_figure(const MatchData& data, const Matching& found) {
    const std::size_t count = data.axes.size();
    Axis up{"", 0, static_cast<double>(count)};
    for (std::size_t k = count; k-- > 0;) up.names.push_back(data.axes[k].key);
    Plot plot("Inputs before and after", {"place in the range before, %", 0, 100}, up, bars_size(count));
    plot.legend({{"label", "before"}, {"c2", "not ruled out"}, {"", "| median"}, {"", "\u00d7 best point"}});
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t axis = count - 1 - i;
        const double y = static_cast<double>(i);
        plot.cell(0, y + 0.2, 100, 0.6, 1, "void");
        if (!found.axes.empty()) {
            const AxisLeft& left = found.axes[axis];
            const auto place = [&](double value) { return percent_of_range(data.axes[axis].coordinate(value)); };
            plot.cell(place(left.low), y + 0.3, std::max(0.3, place(left.high) - place(left.low)), 0.4, 1, "c2");
            plot.line({{place(left.middle), y + 0.2}, {place(left.middle), y + 0.8}}, "");
        }
        plot.cross(percent_of_range(found.best[static_cast<Eigen::Index>(axis)]), y + 0.5, "");
    }
    return plot.svg();
}

}  // namespace floes
