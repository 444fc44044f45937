// A matching as sections for people: targets, emulators, what is left, and how the next wave goes on.

#include "match/matching.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/summary.hpp"

namespace floes {

namespace {

/// For `rows` of names.
Figure::Size bars_size(std::size_t rows) {
    return {720, 84 + 24 * static_cast<double>(rows)};
}

double percent_of_range(double coordinate) {
    return (coordinate + 1) / 2 / unit::percent;
}

/// Each left-out point of a target that is emulated: simulated against predicted, with bars of two standard deviations.
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

/// For each used target, the share that it rules out and the part of it that no other does. Some target is used.
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

/// For each input, its range and what of it is left.
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
        .caption = fmt::format(
            "Each input's range, and from where to where it is not ruled out.{}",
            count < 2 ? ""
                      : " A narrow region can lie aslant, so that no input alone is narrow: see the pairs of inputs.")};
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

}  // namespace

Figure along_figure(const MatchData& data, const Matching& found) {
    FLOES_EXPECTS(data.axes.size() == 1);
    // Beyond this all points are ruled out alike, and one far off would press the others flat.
    constexpr double highest = 4 * ruled_out_above;
    const RangedAxis& axis = data.axes.front();
    Figure::Points line;
    for (Eigen::Index k = 0; k < found.points.rows(); ++k)
        line.emplace_back(axis.value(found.points(k, 0)), found.implausibility[k]);
    std::ranges::sort(line);
    double largest = 2 * ruled_out_above;
    for (const auto& [x, y] : line) largest = std::max(largest, y);
    Figure figure{
        .description = "Implausibility along the input",
        .x = {axis.key, axis.from, axis.to, axis.scale == AxisScale::log},
        .y = {"implausibility", 0, std::min(largest, highest)},
        .caption = fmt::format(
            "The largest implausibility of the targets at {} points of the input's range; above {:g}, the dashed line, "
            "a point is ruled out. The cross is the best point; ticks at the bottom are the points simulated.",
            found.sampled, ruled_out_above)};
    for (auto& [x, y] : line) y = std::min(y, figure.y.high);
    figure.level(ruled_out_above, "dashed");
    figure.line(std::move(line), "c2 thick");
    for (const MatchPoint& point : data.points) {
        const double x = axis.value(point.coordinates.front());
        if (x >= axis.from && x <= axis.to) figure.line({{x, 0}, {x, 0.04 * figure.y.high}}, "");
    }
    figure.cross(axis.value(found.best[0]), std::min(found.best_implausibility, figure.y.high), "");
    return figure;
}

namespace {

/// Root of the mean of the squared errors in standard deviations: 1 for a right emulator.
double error_of_left_out(const EmulatedTarget& target) {
    if (!target.emulated()) return undefined;
    const std::vector<LeftOut>& points = target.mean().left_out();
    double sum = 0;
    for (const LeftOut& one : points) sum += one.standardised() * one.standardised();
    return std::sqrt(sum / static_cast<double>(points.size()));
}

std::string percent(double share) {
    const double shown = share / unit::percent;
    return shown > 0 && shown < 0.1 ? "< 0.1" : fmt::format("{:.{}f}", shown, shown < 10 ? 1 : 0);
}

/// The names of the targets that are not used, by the reason, in the order of the first.
std::vector<std::pair<std::string, std::vector<std::string>>> unused_by_reason(
    const std::vector<EmulatedTarget>& targets) {
    std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
    for (const EmulatedTarget& target : targets) {
        if (target.unused().empty()) continue;
        auto known = std::ranges::find(reasons, target.unused(), [](const auto& one) { return one.first; });
        if (known == reasons.end()) known = reasons.insert(known, {target.unused(), {}});
        known->second.push_back(target.target().name());
    }
    return reasons;
}

std::string verdict_text(const std::vector<EmulatedTarget>& targets, const Matching& found) {
    const auto used = std::ranges::count_if(targets, [](const EmulatedTarget& one) { return one.unused().empty(); });
    std::string told = fmt::format("{} of {} used. ", used, counted(std::ssize(targets), "target"));
    if (found.left > 0) {
        return told + fmt::format("{} % of the inputs' ranges are not ruled out (of {} points looked at).\n",
                                  percent(found.share()), found.sampled);
    }
    told += fmt::format(
        "No combination of the inputs meets all of them: at the best one a target has an implausibility of {:.1f}; "
        "above {:g} it is ruled out.\n",
        found.best_implausibility, ruled_out_above);
    for (const auto& [a, b] : found.conflicts)
        told +=
            fmt::format("No combination meets both {} and {}.\n", targets[static_cast<std::size_t>(a)].target().name(),
                        targets[static_cast<std::size_t>(b)].target().name());
    return told;
}

/// What an implausibility is, for people.
std::string implausibility_words() {
    return fmt::format(
        "Implausibility: by how many times the expected difference (one standard deviation) measured and predicted "
        "differ, as a share of the multiple that rules out, times {0:g}: above {0:g} a point is ruled out. That "
        "multiple is {0:g}, and more where the scatter is known from few runs (Student's quantile that 1 % exceed).",
        ruled_out_above);
}

/// A sentence where the scatter is so uncertain that differences count only far beyond three standard deviations.
void note_bound(Section& section, const EmulatedTarget& target, double bound) {
    constexpr double much_above = 4;
    if (!(bound > much_above)) return;
    section.notes.push_back(
        fmt::format("{}: ruled out only beyond {:.1f} times the expected difference, not {:g}, because the scatter of "
                    "single runs is known from so few; run more arrangements.",
                    target.target().name(), bound, ruled_out_above));
}

/// For a target: what people call it, and its names for programs.
std::vector<ResultColumn> target_columns() {
    return {{"", "target"}, {"quantity"}, {"case"}};
}

std::vector<Datum> named(const Target& target) {
    return {target.name(), std::string{target.quantity.key.view()}, target.case_name};
}

Section target_section(const std::vector<EmulatedTarget>& targets, const Matching& found) {
    Results whole{.place = "match", .columns = program_columns("left sampled best_implausibility"), .object = true};
    whole.add({found.share(), found.sampled, found.best_implausibility});
    Results rows{.place = "match/targets",
                 .columns = target_columns() +
                            std::vector<ResultColumn>{
                                {"", "measured"},
                                {"value"},
                                {"uncertainty"},
                                {"discrepancy"},
                                {"runs"},
                                {"emulator", "emulator"},
                                {"points"},
                                {.key = "left_out_error", .words = "left-out error", .decimals = 2},
                                {"unused"},
                                {.key = "least_implausibility", .words = "least implausibility", .decimals = 2},
                                {"bound"},
                                {.key = "rules_out", .words = "rules out", .unit = "share", .decimals = 1},
                                {.key = "alone", .words = "alone", .unit = "share", .decimals = 1}}};
    for (std::size_t k = 0; k < targets.size(); ++k) {
        const Target& about = targets[k].target();
        const TargetVerdict& verdict = found.verdicts[k];
        const bool emulated = targets[k].emulated();
        rows.add(named(about) + std::vector<Datum>{about.shown(about.value), about.value, about.uncertainty,
                                                   about.discrepancy, about.runs,
                                                   emulated ? name_of(targets[k].mean().kind()) : "none",
                                                   emulated ? targets[k].mean().left_out().size() : 0,
                                                   error_of_left_out(targets[k]), targets[k].unused(), verdict.least,
                                                   verdict.bound, verdict.rules_out, verdict.alone});
    }
    Section section{
        .title = "Targets",
        .before = verdict_text(targets, found) + "\n",
        .results = {std::move(whole), std::move(rows)},
        .after = fmt::format("\nLeft-out error: of points predicted from the others, in standard deviations; 1 is "
                             "right. {} Least: at the best point for the target. Rules out: share of the inputs' "
                             "ranges that it rules out; alone: that no other target does.\n",
                             implausibility_words())};
    for (const auto& [reason, names] : unused_by_reason(targets))
        section.notes.push_back(fmt::format("Not used: {}: {}", fmt::join(names, ", "), reason));
    for (std::size_t k = 0; k < targets.size(); ++k)
        if (targets[k].unused().empty()) {
            note_bound(section, targets[k], found.verdicts[k].bound);
            for (std::string& note : targets[k].simplifications()) section.notes.push_back(std::move(note));
        }
    if (std::ranges::any_of(found.verdicts, [](const TargetVerdict& one) { return one.rules_out > 0; }))
        section.figures = {ruled_out_figure(targets, found)};
    return section;
}

Section axis_section(const MatchData& data, const Matching& found) {
    Results rows{.place = "match/inputs",
                 .columns = {{"key", "input"},
                             {.key = "from", .words = "from", .digits = 4},
                             {.key = "to", .words = "to", .digits = 4},
                             {.key = "low", .words = "not ruled out from", .digits = 4},
                             {.key = "high", .words = "to", .digits = 4},
                             {.key = "median", .words = "median", .digits = 4},
                             {.key = "best", .words = "best point", .digits = 4}}};
    for (std::size_t k = 0; k < data.axes.size(); ++k) {
        const RangedAxis& axis = data.axes[k];
        const AxisLeft left = found.axes.empty() ? AxisLeft{undefined, undefined, undefined} : found.axes[k];
        rows.add({axis.key, axis.from, axis.to, left.low, left.high, left.middle,
                  axis.value(found.best[static_cast<Eigen::Index>(k)])});
    }
    return {
        .title = "Inputs",
        .results = {std::move(rows)},
        .after = fmt::format("\nBest point: the largest implausibility there is {:.2f}.\n", found.best_implausibility),
        .figures = {inputs_figure(data, found)}};
}

Section correlation_section(const MatchData& data, const Matching& found) {
    Section section{.title = "Correlations of the inputs in what is not ruled out"};
    if (found.left < 3) {
        section.before = "Too few points are left.\n";
        return section;
    }
    Results rows{.place = "match/correlations", .columns = {{"key", "input"}}};
    for (const RangedAxis& axis : data.axes)
        rows.columns.push_back({.key = axis.key, .words = axis.key, .decimals = 2});
    for (std::size_t i = 0; i < data.axes.size(); ++i) {
        std::vector<Datum> row{data.axes[i].key};
        for (std::size_t k = 0; k < data.axes.size(); ++k)
            row.emplace_back(found.correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
        rows.add(std::move(row));
    }
    section.results = {std::move(rows)};
    return section;
}

}  // namespace

std::vector<Section> match_sections(const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                    const Matching& found) {
    std::vector<Section> sections{target_section(targets, found), axis_section(data, found)};
    if (data.axes.size() > 1) sections.push_back(correlation_section(data, found));
    return sections;
}

Section check_section(const std::vector<EmulatedTarget>& targets) {
    Section section{.title = "Checks of the emulators"};
    for (const EmulatedTarget& target : targets) {
        if (!target.emulated()) continue;
        section.figures.push_back(left_out_figure(target));
        if (const std::string fault = target.mean().fault(); !fault.empty())
            section.notes.push_back(target.target().name() + ": " + fault);
    }
    if (section.figures.empty()) {
        section.before = "No target has an emulator.\n";
    } else {
        section.figures.back().caption =
            "Each point of the design as simulated, against its prediction from the other points with two standard "
            "deviations of a new value there; on the line both agree. Of a right emulator one in twenty bars misses "
            "the line (orange). Green: the measured value.";
    }
    return section;
}

Section point_section(const MatchData& data, const std::vector<EmulatedTarget>& targets, const Eigen::VectorXd& at) {
    Results rows{
        .place = "match/point",
        .columns = target_columns() +
                   std::vector<ResultColumn>{{"", "measured"},
                                             {"", "predicted"},
                                             {"", "expected to differ by"},
                                             {"predicted"},
                                             {"difference"},
                                             {.key = "ratio", .words = "differs by times", .decimals = 2},
                                             {.key = "bound", .words = "ruled out above", .decimals = 2},
                                             {.key = "implausibility", .words = "implausibility", .decimals = 2}}};
    std::vector<std::string> against;
    Section section;
    for (const EmulatedTarget& one : targets) {
        if (!one.emulated()) continue;
        const Target& about = one.target();
        const Comparison here = one.compared(at);
        rows.add(named(about) + std::vector<Datum>{about.shown(about.value), about.shown(here.predicted),
                                                   about.shown(here.expected, 3), here.predicted, here.expected,
                                                   here.ratio, here.bound, here.implausibility()});
        if (one.rules_out(at)) against.push_back(about.name());
        note_bound(section, one, here.bound);
    }
    std::string place;
    for (std::size_t k = 0; k < data.axes.size(); ++k)
        place += fmt::format("{}{} = {:.4g}", k > 0 ? ", " : "", data.axes[k].key,
                             data.axes[k].value(at[static_cast<Eigen::Index>(k)]));
    section.title = "At " + place;
    section.before =
        against.empty() ? "Not ruled out.\n\n" : fmt::format("Ruled out by {}.\n\n", fmt::join(against, ", "));
    section.results = {std::move(rows)};
    section.after = fmt::format(
        "\nExpected to differ by: one standard deviation, of the emulator, single runs, measurement and model. Differs "
        "by times: the difference of measured and predicted over that; ruled out above: its bound. {}\n",
        implausibility_words());
    return section;
}

namespace {

std::string exceeded_words(const DesignLoadRequest& request) {
    return fmt::format("exceeded with {:.3g} %", (1 - request.quantiles.front()) / unit::percent);
}

Results results_of(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    Results rows{.place = "match/design_load",
                 .columns = {{"case", "case"},
                             {"exposure"},
                             {"averaging"},
                             {"scale"},
                             {"quantile"},
                             estimates("expected", "expected", "N"),
                             estimates("expected_weighted", "weighed", "N"),
                             estimates("quantile_load", exceeded_words(request), "N"),
                             estimates("quantile_load_weighted", "weighed", "N"),
                             {"growth_expected"},
                             estimates("growth_quantile", "growth"),
                             {.key = "growth_lower_half", .words = "lower half", .decimals = 2},
                             {.key = "growth_upper_half", .words = "upper half", .decimals = 2},
                             {"runs", "runs"},
                             {"only_left", "at inputs left"}}};
    for (const PredictedDesignLoad& one : designs) {
        if (!one.known()) continue;
        rows.add({Named{one.case_name, one.case_name.empty() ? "all" : one.case_name}, request.exposure,
                  request.averaging, request.scale, request.quantiles.front(), one.expected, one.expected_weighed,
                  one.quantile, one.quantile_weighed, one.growth_expected.value,
                  within(one.growth_quantile.value, one.growth_quantile.interval), one.growth_lower_half,
                  one.growth_upper_half, one.runs, one.only_left});
    }
    return rows;
}

}  // namespace

Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    const bool all_left =
        std::ranges::all_of(designs, [](const PredictedDesignLoad& one) { return !one.known() || one.only_left; });
    Section section{
        .title = fmt::format("Design load over what is not ruled out: the largest load averaged over {:g} s in {:g} h",
                             request.averaging, request.exposure / unit::hour)};
    for (const PredictedDesignLoad& one : designs)
        if (!one.unknown.empty()) section.notes.push_back(one.unknown);
    for (const PredictedDesignLoad& one : designs)
        section.notes.insert(section.notes.end(), one.notes.begin(), one.notes.end());
    if (std::ranges::none_of(designs, &PredictedDesignLoad::known)) return section;
    section.results = {results_of(designs, request)};
    section.after = fmt::format(
        "\nIn brackets 95 %, of the inputs, the emulator and the tail together; weighed: by the likelihood of the "
        "targets.\nThe emulated mean of the segment maxima times a growth: that to the load {}, from both tails of all "
        "runs at inputs that are left, each divided by its mean maximum. The halves have the runs with the smaller and "
        "the larger mean maxima; where they differ by more than the interval, the growth depends on the inputs.\n{}",
        exceeded_words(request),
        all_left ? ""
                 : fmt::format("Where fewer than {} runs are at inputs that are left, the runs at all points count.\n",
                               fewest_growth_runs));
    return section;
}

}  // namespace floes
