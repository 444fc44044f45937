#include "match/match_sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "match/predict.hpp"
#include "tables/number_text.hpp"

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

namespace {

struct TargetRow {
    const EmulatedTarget* target;
    const TargetVerdict* verdict;
};

struct AxisRow {
    const MatchAxis* axis;
    const AxisLeft* left;  ///< null where nothing is left
};

const char* kind_word(const EmulatedTarget& target) {
    if (!target.emulated()) return "none";
    switch (target.mean().kind()) {
        case EmulatorKind::constant:
            return "constant";
        case EmulatorKind::linear:
            return "linear";
        case EmulatorKind::quadratic:
            return "quadratic";
        case EmulatorKind::gaussian_process:
            break;
    }
    return "Gaussian process";
}

/// Root of the mean of the squared errors in standard deviations: 1 for a right emulator.
double error_of_left_out(const EmulatedTarget& target) {
    if (!target.emulated()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for (const LeftOut& one : target.mean().left_out()) sum += one.standardised() * one.standardised();
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, target.mean().left_out().size())));
}

std::string percent(double share) {
    const double shown = share / unit::percent;
    return shown > 0 && shown < 0.1 ? "< 0.1" : fixed(shown, shown < 10 ? 1 : 0);
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
        "No combination of the inputs meets all of them: the best one misses a target by {:.1f} standard deviations.\n",
        found.best_implausibility);
    for (const auto& [a, b] : found.conflicts)
        told +=
            fmt::format("No combination meets both {} and {}.\n", targets[static_cast<std::size_t>(a)].target().name(),
                        targets[static_cast<std::size_t>(b)].target().name());
    return told;
}

Section target_section(const std::vector<EmulatedTarget>& targets, const Matching& found) {
    std::vector<TargetRow> rows;
    for (std::size_t k = 0; k < targets.size(); ++k) rows.push_back({&targets[k], &found.verdicts[k]});
    Section section{.title = "Targets", .before = verdict_text(targets, found) + "\n"};
    section.table = {
        {"target", "measured", "emulator", "left-out error", "least implausibility", "rules out, %", "alone, %"}};
    for (const auto& [target, verdict] : rows) {
        const Target& about = target->target();
        const bool used = target->unused().empty();
        section.table.push_back({about.name(), about.shown(about.value), kind_word(*target),
                                 fixed(error_of_left_out(*target), 2), fixed(verdict->least, 2),
                                 used ? percent(verdict->rules_out) : "-", used ? percent(verdict->alone) : "-"});
    }
    section.after =
        "\nLeft-out error: of points predicted from the others, in standard deviations; 1 is right. Least "
        "implausibility: "
        "how far the target is from its prediction at the best point for it, in standard deviations. Rules out: share "
        "of the inputs' ranges where that is above 3; alone: that no other target rules out.\n";
    for (const auto& [reason, names] : unused_by_reason(targets))
        section.notes.push_back(fmt::format("Not used: {}: {}", fmt::join(names, ", "), reason));
    if (std::ranges::any_of(found.verdicts, [](const TargetVerdict& one) { return one.rules_out > 0; }))
        section.figures = {ruled_out_figure(targets, found)};
    using Row = const TargetRow&;
    using Whole = const Matching&;
    section.records = {
        make_object<Matching>("match", found,
                              {{"left", [](Whole all) { return all.share(); }},
                               {"sampled", [](Whole all) { return all.sampled; }},
                               {"best_implausibility", [](Whole all) { return all.best_implausibility; }}}),
        make_rows<TargetRow>(
            "match/targets", rows,
            {{"quantity", [](Row row) { return std::string(row.target->target().quantity.key.view()); }},
             {"case", [](Row row) { return row.target->target().case_name; }},
             {"value", [](Row row) { return row.target->target().value; }},
             {"uncertainty", [](Row row) { return row.target->target().uncertainty; }},
             {"discrepancy", [](Row row) { return row.target->target().discrepancy; }},
             {"runs", [](Row row) { return row.target->target().runs; }},
             {"emulator", [](Row row) { return kind_word(*row.target); }},
             {"left_out_error", [](Row row) { return error_of_left_out(*row.target); }},
             {"unused", [](Row row) { return row.target->unused(); }},
             {"least_implausibility", [](Row row) { return row.verdict->least; }},
             {"rules_out", [](Row row) { return row.verdict->rules_out; }},
             {"alone", [](Row row) { return row.verdict->alone; }}})};
    return section;
}

Section axis_section(const MatchData& data, const Matching& found) {
    std::vector<AxisRow> rows;
    for (std::size_t k = 0; k < data.axes.size(); ++k)
        rows.push_back({&data.axes[k], found.axes.empty() ? nullptr : &found.axes[k]});
    Section section{.title = "Inputs", .figures = {inputs_figure(data, found)}};
    section.table = {{"input", "range", "not ruled out", "median", "best point"}};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto& [axis, left] = rows[k];
        section.table.push_back({axis->key, fmt::format("{:.4g} to {:.4g}", axis->from, axis->to),
                                 left != nullptr ? fmt::format("{:.4g} to {:.4g}", left->low, left->high) : "nothing",
                                 left != nullptr ? fmt::format("{:.4g}", left->middle) : "",
                                 fmt::format("{:.4g}", axis->value(found.best[static_cast<Eigen::Index>(k)]))});
    }
    section.after =
        fmt::format("\nBest point: the largest implausibility there is {:.2f}.\n", found.best_implausibility);
    using Row = const AxisRow&;
    const auto of_left = [](double AxisLeft::*field) {
        return [field](Row row) { return row.left != nullptr ? Datum(row.left->*field) : Datum(Undefined{}); };
    };
    section.records = {make_rows<AxisRow>("match/inputs", rows,
                                          {{"key", [](Row row) { return row.axis->key; }},
                                           {"from", [](Row row) { return row.axis->from; }},
                                           {"to", [](Row row) { return row.axis->to; }},
                                           {"low", of_left(&AxisLeft::low)},
                                           {"high", of_left(&AxisLeft::high)},
                                           {"median", of_left(&AxisLeft::middle)}})};
    return section;
}

Section correlation_section(const MatchData& data, const Matching& found) {
    Section section{.title = "Correlations of the inputs in what is not ruled out"};
    if (found.left < 3) {
        section.before = "Too few points are left.\n";
        return section;
    }
    section.table = {{""}};
    for (const MatchAxis& axis : data.axes) section.table.front().emplace_back(axis.key);
    for (std::size_t i = 0; i < data.axes.size(); ++i) {
        std::vector<Cell> line{data.axes[i].key};
        for (std::size_t k = 0; k < data.axes.size(); ++k)
            line.emplace_back(fixed(found.correlations(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)), 2));
        section.table.push_back(std::move(line));
    }
    return section;
}

}  // namespace

std::vector<Section> match_sections(const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                    const Matching& found) {
    return {target_section(targets, found), axis_section(data, found), correlation_section(data, found)};
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
    struct Row {
        const EmulatedTarget* target;
        double predicted;
        double difference;
        double implausibility;
    };
    std::vector<Row> rows;
    std::vector<std::string> against;
    for (const EmulatedTarget& one : targets) {
        if (!one.emulated()) continue;
        rows.push_back({&one, one.mean().at(at).mean, one.expected_difference(at), one.implausibility(at)});
        if (one.rules_out(at)) against.push_back(one.target().name());
    }
    std::string place;
    for (std::size_t k = 0; k < data.axes.size(); ++k)
        place += fmt::format("{}{} = {:.4g}", k > 0 ? ", " : "", data.axes[k].key,
                             data.axes[k].value(at[static_cast<Eigen::Index>(k)]));
    Section section{.title = "At " + place,
                    .before = against.empty() ? "Not ruled out.\n\n"
                                              : fmt::format("Ruled out by {}.\n\n", fmt::join(against, ", "))};
    section.table = {{"target", "measured", "predicted", "expected to differ by", "implausibility"}};
    for (const Row& row : rows) {
        const Target& about = row.target->target();
        section.table.push_back({about.name(), about.shown(about.value), about.shown(row.predicted),
                                 about.shown(row.difference, 3), fixed(row.implausibility, 2)});
    }
    section.after =
        "\nExpected to differ by: one standard deviation, of the emulator, single runs, measurement and model.\n";
    section.records = {make_rows<Row>(
        "match/point", rows,
        {{"quantity", [](const Row& row) { return std::string(row.target->target().quantity.key.view()); }},
         {"case", [](const Row& row) { return row.target->target().case_name; }},
         {"predicted", [](const Row& row) { return row.predicted; }},
         {"difference", [](const Row& row) { return row.difference; }},
         {"implausibility", [](const Row& row) { return row.implausibility; }}})};
    return section;
}

namespace {

std::string exceeded_words(const DesignLoadRequest& request) {
    return fmt::format("exceeded with {:.3g} %", (1 - request.quantiles.front()) / unit::percent);
}

Table table_of(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    double largest = 0;
    for (const PredictedDesignLoad& one : designs) largest = std::max(largest, one.quantile.high);
    const LoadUnit unit = load_unit(largest);
    const auto cell = [&](const PredictedRange& range) { return range_cell(range, unit.factor); };
    Table table{{"case", fmt::format("expected, {}", unit.name), "weighed",
                 fmt::format("{}, {}", exceeded_words(request), unit.name), "weighed", "growth", "lower half",
                 "upper half", "runs"}};
    for (const PredictedDesignLoad& one : designs)
        table.push_back({one.case_name.empty() ? "all" : one.case_name, cell(one.expected), cell(one.expected_weighed),
                         cell(one.quantile), cell(one.quantile_weighed),
                         Cell{fixed(one.growth_quantile.value, 2),
                              bracket(one.growth_quantile.interval.low, one.growth_quantile.interval.high, 2)},
                         fixed(one.growth_lower_half, 2), fixed(one.growth_upper_half, 2),
                         fmt::format("{}{}", one.runs, one.only_left ? "" : " *")});
    return table;
}

DataRows records_of(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    using Row = const PredictedDesignLoad&;
    std::vector<DataColumn<PredictedDesignLoad>> columns{{"case", &PredictedDesignLoad::case_name},
                                                         {"exposure_s", [&](Row) { return request.exposure; }},
                                                         {"averaging_s", [&](Row) { return request.averaging; }},
                                                         {"scale", [&](Row) { return request.scale; }},
                                                         {"quantile", [&](Row) { return request.quantiles.front(); }}};
    const auto add_range = [&](const std::string& name, PredictedRange PredictedDesignLoad::*range) {
        columns.push_back({name + "_N", [=](Row row) { return Datum((row.*range).mean); }});
        columns.push_back({name + "_low_N", [=](Row row) { return Datum((row.*range).low); }});
        columns.push_back({name + "_high_N", [=](Row row) { return Datum((row.*range).high); }});
    };
    add_range("expected", &PredictedDesignLoad::expected);
    add_range("expected_weighted", &PredictedDesignLoad::expected_weighed);
    add_range("quantile", &PredictedDesignLoad::quantile);
    add_range("quantile_weighted", &PredictedDesignLoad::quantile_weighed);
    columns.push_back({"growth_expected", [](Row row) { return row.growth_expected.value; }});
    columns.push_back({"growth_quantile", [](Row row) { return row.growth_quantile.value; }});
    columns.push_back({"growth_quantile_low", [](Row row) { return row.growth_quantile.interval.low; }});
    columns.push_back({"growth_quantile_high", [](Row row) { return row.growth_quantile.interval.high; }});
    columns.push_back({"growth_lower_half", &PredictedDesignLoad::growth_lower_half});
    columns.push_back({"growth_upper_half", &PredictedDesignLoad::growth_upper_half});
    columns.push_back({"runs", &PredictedDesignLoad::runs});
    columns.push_back({"only_left", &PredictedDesignLoad::only_left});
    return make_rows<PredictedDesignLoad>("match/design_load", designs, columns);
}

}  // namespace

Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request) {
    const bool all_left = std::ranges::all_of(designs, &PredictedDesignLoad::only_left);
    return {
        .title = fmt::format("Design load over what is not ruled out: the largest load averaged over {:g} s in {:g} h",
                             request.averaging, request.exposure / unit::hour),
        .table = table_of(designs, request),
        .after = fmt::format(
            "\nIn brackets 95 %, of the inputs, the emulator and the tail together; weighed: by the likelihood of the "
            "targets.\n"
            "The emulated mean of the segment maxima times a growth: that to the load {}, from both tails of all runs "
            "at inputs that are left, each divided by its mean maximum. The halves have the runs with the smaller and "
            "the "
            "larger mean maxima; where they differ by more than the interval, the growth depends on the inputs.\n{}",
            exceeded_words(request),
            all_left
                ? ""
                : fmt::format("* Fewer than {} runs are at inputs that are left, so the runs at all points count.\n",
                              fewest_growth_runs)),
        .records = {records_of(designs, request)}};
}

}  // namespace floes
