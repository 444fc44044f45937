#include "match/match_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace floes {
namespace {

/// For `rows` of names.
Figure::Size bars_size(std::size_t rows) {
    return {720, 84 + 24 * static_cast<double>(rows)};
}

double percent_of_range(double coordinate) {
    return (coordinate + 1) / 2 / unit::percent;
}

}  // namespace

Figure left_out_figure(const EmulatedTarget& target) {
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
    Figure figure{.description = "Predictions of left-out points of " + about.name(),
                  .x = across,
                  .y = up,
                  .size = {250, 230},
                  .legend = {{"", about.name()}}};
    const double low = std::max(across.low, up.low);
    const double high = std::min(across.high, up.high);
    if (low < high) figure.line({{low, low}, {high, high}}, "thin");
    if (measured > across.low && measured < across.high) figure.upright(measured, "dotted c2");
    for (const LeftOut& one : points) {
        const char* style = std::abs(one.standardised()) > 2 ? "c1" : "c0";
        const double x = one.value * factor;
        figure.line({{x, (one.predicted - 2 * one.sd) * factor}, {x, (one.predicted + 2 * one.sd) * factor}},
                    fmt::format("{} thin", style));
        figure.dot(x, one.predicted * factor, style, 2);
    }
    return figure;
}

Figure ruled_out_figure(const std::vector<EmulatedTarget>& targets, const Matching& found) {
    std::vector<std::size_t> used;
    for (std::size_t k = targets.size(); k-- > 0;)
        if (targets[k].unused().empty()) used.push_back(k);
    Axis up{"", 0, static_cast<double>(used.size())};
    for (const std::size_t k : used) up.names.push_back(targets[k].target().name());
    Figure figure{.description = "What each target rules out",
                  .x = {"share of the inputs' ranges, %", 0, 100},
                  .y = up,
                  .size = bars_size(used.size()),
                  .legend = {{"c5", "ruled out"}, {"c0", "by no other target"}},
                  .caption = "What each target rules out of the inputs' ranges."};
    for (std::size_t i = 0; i < used.size(); ++i) {
        const TargetVerdict& verdict = found.verdicts[used[i]];
        const double y = static_cast<double>(i) + 0.2;
        if (verdict.rules_out > 0) figure.cell(0, y, verdict.rules_out / unit::percent, 0.6, 0.6, "c5");
        if (verdict.alone > 0) figure.cell(0, y, verdict.alone / unit::percent, 0.6, 1, "c0");
    }
    return figure;
}

Figure inputs_figure(const MatchData& data, const Matching& found) {
    const std::size_t count = data.axes.size();
    Axis up{"", 0, static_cast<double>(count)};
    for (std::size_t k = count; k-- > 0;) up.names.push_back(data.axes[k].key);
    Figure figure{
        .description = "Inputs before and after",
        .x = {"place in the range before, %", 0, 100},
        .y = up,
        .size = bars_size(count),
        .legend = {{"label", "before"}, {"c2", "not ruled out"}, {"", "| median"}, {"", "× best point"}},
        .caption =
            "Each input's range, and from where to where it is not ruled out. A narrow region can lie aslant, so "
            "that no input alone is narrow: see the pairs of inputs."};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t axis = count - 1 - i;
        const double y = static_cast<double>(i);
        figure.cell(0, y + 0.2, 100, 0.6, 1, "void");
        if (!found.axes.empty()) {
            const AxisLeft& left = found.axes[axis];
            const auto place = [&](double value) { return percent_of_range(data.axes[axis].coordinate(value)); };
            figure.cell(place(left.low), y + 0.3, std::max(0.3, place(left.high) - place(left.low)), 0.4, 1, "c2");
            figure.line({{place(left.middle), y + 0.2}, {place(left.middle), y + 0.8}}, "");
        }
        figure.cross(percent_of_range(found.best[static_cast<Eigen::Index>(axis)]), y + 0.5, "");
    }
    return figure;
}

}  // namespace floes
