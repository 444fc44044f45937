// Structures that gave way in the simulation: how they moved, what their lines bore, and their design values.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/moored.hpp"
#include "member/array_output.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

std::vector<double> values_of(const Evidence& evidence, std::size_t of_case, std::string_view key) {
    return evidence.sample.values(evidence.sample.done(of_case), *find_quantity(key));
}

/// For a case; not known where a run has none: no lines, no tension; no thrusters, no thrust.
Estimate mean_of_runs(const Evidence& evidence, std::size_t of_case, std::string_view key) {
    const std::vector<double> values = values_of(evidence, of_case, key);
    if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return {};
    return over(values);
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        if (std::isfinite(value)) sum += value;
    return sum;
}

/// Whether some run of a structure that gives way has the quantity.
bool anywhere(const Evidence& evidence, std::string_view key) {
    for (std::size_t index = 0; index < evidence.campaign.cases.size(); ++index)
        if (evidence.campaign.cases[index].scenario.moorings.give_way() &&
            std::isfinite(mean_of_runs(evidence, index, key).value))
            return true;
    return false;
}

/// Whether a case has the design value.
bool has(const Case& one, const DesignOf& of) {
    return of.value != nullptr && of.is_of(one.scenario);
}

bool by_thrusters_alone(const Case& one) {
    const Moorings& moorings = one.scenario.moorings;
    const auto held_by_moorings = [&](Motion motion) {
        const auto k = static_cast<int>(motion);
        return moorings.is_free(motion) && moorings.stiffness()(k, k) != 0;
    };
    return moorings.give_way() && moorings.thrusters.any() && !held_by_moorings(Motion::surge) &&
           !held_by_moorings(Motion::sway);
}

/// Its place along the arrays "responses/..." of members.
std::size_t place_of(const DesignOf& of) {
    const auto kinds = response_kinds();
    return static_cast<std::size_t>(std::ranges::find(kinds, of.word, &DesignOf::word) - kinds.begin());
}

/// The largest of a segment, of each member, by case.
std::map<std::size_t, std::vector<double>> segment_maxima(const Evidence& evidence, std::string_view word) {
    std::map<std::size_t, std::vector<double>> found;
    const std::size_t place = place_of(*find_design_of(word));
    for (std::size_t k = 0; k < evidence.sample.cases.size(); ++k)
        for (const std::size_t member : evidence.sample.done(k))
            if (const auto own = evidence.sample.along("responses/segment_maximum", member, place); !own.empty())
                found[k].push_back(mean_of(own));
    return found;
}

Results run_results(const Evidence& evidence) {
    const bool lines = anywhere(evidence, "largest_line_tension");
    const bool thrusters = anywhere(evidence, "largest_surge_thrust");
    const bool floats = anywhere(evidence, "largest_pitch");
    std::map<std::size_t, std::vector<double>> forces = segment_maxima(evidence, "mooring_force");
    std::map<std::size_t, std::vector<double>> offsets = segment_maxima(evidence, "offset");
    const auto if_any = [](bool any, const char* words) { return any ? words : ""; };
    Results results{
        .place = "moored/simulated",
        .columns = {
            {"case", "gives way"},
            {"runs", "runs"},
            estimates("mean_load", "mean load", "N"),
            estimates("mean_offset", "mean offset, m"),
            estimates("sd_offset", "SD of offset, m"),
            estimates("mean_force", "", "N"),
            estimates("largest_force", "largest mooring force of a segment, along the tow", "N"),
            estimates("largest_resultant", if_any(!forces.empty(), "the same, horizontal resultant"), "N"),
            estimates("largest_place_offset", if_any(!offsets.empty(), "largest horizontal offset of a segment, m")),
            {"largest_yaw"},
            {.words = "largest yaw, °", .decimals = 1},
            {.key = "velocity_ratio", .words = "rms velocity / drift", .decimals = 3},
            {.key = "largest_heave", .words = if_any(floats, "largest heave, m"), .decimals = 3},
            {.key = "largest_pitch_deg", .words = if_any(floats, "largest pitch, °"), .decimals = 2},
            {.key = "largest_roll_deg", .words = if_any(floats, "largest roll, °"), .decimals = 2},
            estimates("largest_tension", if_any(lines, "largest tension of a line"), "N"),
            {.key = "broken_lines", .words = if_any(lines, "lines broken"), .decimals = 0},
            estimates("largest_thrust", if_any(thrusters, "largest thrust in surge"), "N"),
            estimates("thrust_at_limit", if_any(thrusters, "time at the limit of thrust"), "share")}};
    for (std::size_t index = 0; index < evidence.campaign.cases.size(); ++index) {
        const Scenario& scenario = evidence.campaign.cases[index].scenario;
        if (!scenario.moorings.give_way() || evidence.sample.done(index).empty()) continue;
        const auto mean = [&](std::string_view key) { return mean_of_runs(evidence, index, key); };
        const auto most = [&](std::string_view key) { return std::ranges::max(values_of(evidence, index, key)); };
        const std::vector<double> yaw = values_of(evidence, index, "largest_yaw");
        results.add(
            {evidence.summary.named(index), yaw.size(),
             estimate_of(evidence.summary.cases[index], quantity("mean_load")), mean("mean_surge_offset"),
             mean("sd_surge_offset"), mean("mean_surge_mooring"), mean("mean_maximum_surge_mooring"),
             over(forces[index]), over(offsets[index]), std::ranges::max(yaw), std::ranges::max(yaw) / unit::degree,
             population_sd(values_of(evidence, index, "rms_surge_velocity"), 0) / scenario.drift(),
             most("largest_heave_offset"), most("largest_pitch") / unit::degree, most("largest_roll") / unit::degree,
             mean("largest_line_tension"), sum_of(values_of(evidence, index, "broken_lines")),
             mean("largest_surge_thrust"), mean("thrust_at_limit")});
    }
    return results;
}

}  // namespace

std::optional<Section> moored_runs_section(const Evidence& evidence) {
    Results results = run_results(evidence);
    if (results.empty()) return {};
    return Section{
        .title = "Structures that give way in the simulation",
        .results = {std::move(results)},
        .after =
            "\nMean and SD of the offset: of the hull's axis along the surge load, from where the moorings would have "
            "it; mooring force: what springs, lines and turret bear of that load, and their resultant in the "
            "horizontal plane; horizontal offset: of the turret, without one of the hull's axis. Largest of a segment: "
            "mean over segments and arrangements; tension: mean over arrangements of the largest of any line; yaw, "
            "heave, pitch and roll: of all runs; thrust likewise, and the share of the window in which thrusters are "
            "at a limit in any direction; brackets: 95 % (t). docs/moorings.md\n"};
}

namespace {

/// Largest tension of each line over a run, and in how many runs it broke.
struct LineRuns {
    std::vector<std::vector<double>> tensions;  ///< by line, N
    std::vector<int> broken;
};

std::vector<LineRuns> line_runs(const Evidence& evidence) {
    std::vector<LineRuns> found(evidence.campaign.cases.size());
    for_each_history(evidence.file, array_output("members/line_tension"), [&](const StoredHistory& lines) {
        LineRuns& one = found[evidence.case_of(lines.member)];
        one.tensions.resize(lines.values.size());
        for (std::size_t line = 0; line < lines.values.size(); ++line) one.tensions[line].push_back(lines.values[line]);
    });
    for (LineRuns& one : found) one.broken.resize(one.tensions.size());
    for_each_history(evidence.file, array_output("members/line_broken_at"), [&](const StoredHistory& lines) {
        LineRuns& one = found[evidence.case_of(lines.member)];
        for (std::size_t line = 0; line < lines.values.size(); ++line)
            one.broken.at(line) += std::isfinite(lines.values[line]) ? 1 : 0;
    });
    return found;
}

double azimuth_of(const Moorings& moorings, std::size_t line) {
    const std::size_t weightless = moorings.lines.size();
    return line < weightless ? moorings.lines[line].azimuth : moorings.hanging.at(line - weightless).azimuth;
}

}  // namespace

std::optional<Section> mooring_lines_section(const Evidence& evidence) {
    if (evidence.file.empty()) return {};
    Results results{.place = "moored/lines",
                    .columns = {{"case", "case"},
                                {"line", "line"},
                                {.key = "azimuth_deg"},
                                {.key = "break_load"},
                                estimates("tension", "largest tension", "N"),
                                estimates("ratio", "over break load", "1", 2),
                                {.key = "broken_runs", .words = "broke in"}},
                    .view = Results::View::none};
    const std::vector<LineRuns> runs = line_runs(evidence);
    for (std::size_t index = 0; index < runs.size(); ++index) {
        const Moorings& moorings = evidence.campaign.cases[index].scenario.moorings;
        for (std::size_t line = 0; line < runs[index].tensions.size(); ++line) {
            std::vector<double> tensions = runs[index].tensions[line];
            const Estimate tension = over(tensions);
            const double strength = break_load(moorings, line);
            for (double& one : tensions) one = strength > 0 ? one / strength : std::nan("");
            const double azimuth = azimuth_of(moorings, line) / unit::degree;
            results.add({evidence.summary.named(index),
                         Named{fmt::format("{}", line), fmt::format("{}, towards {:.4g}°", line + 1, azimuth)}, azimuth,
                         strength > 0 ? Datum(strength) : Undefined{}, tension, over(tensions),
                         runs[index].broken[line]});
        }
    }
    if (results.empty()) return {};
    const bool break_loads = std::ranges::any_of(
        evidence.campaign.cases, [](const Case& one) { return has_lines_that_break(one.scenario.moorings); });
    Results shown = pivot(results, "line", "case", {break_loads ? "ratio" : "tension"});
    for (ResultColumn& column : shown.columns)
        if (column.holds == ResultColumn::Holds::estimates && break_loads) column.limit = 1 / evidence.safety_factor;
    shown.view = Results::View::drawn;
    return Section{.title = fmt::format("Lines: largest tension of a run{}, mean over arrangements",
                                        break_loads ? " over the break load" : ""),
                   .results = {std::move(shown), std::move(results)}};
}

namespace {

constexpr std::size_t periods_shown = 16;

/// Largest k x over the largest averaged load at one natural period.
struct Point {
    std::size_t case_index;
    double period;  ///< s at full scale
    Interval amplification;
};

/// Hulls of natural periods from the shortest that the histories of a case have to the longest that its window has, at
/// full scale; none where that is shorter. Their stiffness does not matter to the ratio.
std::vector<MooredRequest> hulls_of(const Evidence& evidence, double damping_ratio, double averaging, double scale) {
    double low = HUGE_VAL;
    double high = 0;
    const double to_full = std::sqrt(scale);
    for (const CaseRow& one : evidence.sample.cases) {
        const double step = one.time_step * one.analysis.history_stride;
        low = std::min(low, to_full * fewest_values * step * 1.001);
        high = std::max(high, to_full * one.analysis.window / fewest_periods * 0.999);
    }
    std::vector<MooredRequest> hulls;
    for (std::size_t k = 0; k < periods_shown && low < high; ++k) {
        const double period = low * std::pow(high / low, static_cast<double>(k) / (periods_shown - 1.0));
        const double omega = 2 * std::numbers::pi / period;
        hulls.push_back({{1, 1 / (omega * omega), damping_ratio}, scale, averaging});
    }
    return hulls;
}

/// For one case.
struct Ratios {
    double step = 0;
    LastEntry entry = {};
    std::vector<std::vector<double>> of_hull;  ///< of each member
};

/// Cases of which stored loads move a hull: those that hold still in the simulation.
Which held_still(const Evidence& evidence) {
    return [&](std::size_t k) { return !evidence.campaign.cases[k].scenario.moorings.give_way(); };
}

std::vector<Point> points_of(const Evidence& evidence, const std::vector<MooredRequest>& hulls) {
    if (hulls.empty()) return {};
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary, held_still(evidence));
    std::map<std::size_t, Ratios> found;
    for_each_history(evidence.file, [&](const StoredHistory& history) {
        const std::size_t index = evidence.case_of(history.member);
        if (std::ranges::find(drawn, index) == drawn.end()) return;
        Ratios& one = found[index];
        one.step = history.step;
        one.of_hull.resize(hulls.size());
        one.entry.add(first_load(history.values, history.step),
                      history.step * static_cast<double>(history.values.size()));
        const Analysis& analysis = evidence.sample.cases[index].analysis;
        const double load =
            load_in_window(history.values, history.step, analysis, hulls.front().model_averaging()).mean_maximum;
        for (std::size_t k = 0; k < hulls.size() && load > 0; ++k) {
            const std::vector<double> force = mooring_force(history.values, history.step, analysis, hulls[k]);
            one.of_hull[k].push_back(mean_of(part_maxima(force, static_cast<std::size_t>(analysis.segments))) / load);
        }
    });
    std::vector<Point> points;
    for (const auto& [index, one] : found)
        for (std::size_t k = 0; k < hulls.size(); ++k) {
            const Analysis& analysis = evidence.sample.cases[index].analysis;
            if (!one.of_hull[k].empty() && moored_refusal(analysis, one.step, one.entry.time, hulls[k]).empty())
                points.push_back({index, hulls[k].hull.period(), mean_interval(one.of_hull[k])});
        }
    return points;
}

Figure figure_of(const Evidence& evidence, const std::vector<Point>& points, const std::string& caption) {
    std::vector<double> heights{1};
    std::map<std::size_t, Figure::Points> curves;
    for (const Point& point : points) {
        heights.push_back(point.amplification.estimate);
        curves[point.case_index].emplace_back(point.period, point.amplification.estimate);
    }
    const auto [shortest, longest] = std::ranges::minmax_element(points, {}, &Point::period);
    Figure figure{.description = "Largest mooring force over largest load, over the natural period",
                  .x = {"natural period, s", shortest->period, longest->period, true},
                  .y = axis_around("largest k x / largest load", heights, true),
                  .legend = case_legend(evidence.summary),
                  .caption = caption + undrawn_text(evidence.summary, held_still(evidence))};
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

/// Points at equal periods stand together.
Results spectrum_rows(const Summary& summary, const std::vector<Point>& points, double damping_ratio) {
    Results results{.place = "moored/spectrum",
                    .columns = {{"case", "case"},
                                {.key = "period", .words = "natural period, s", .digits = 3},
                                {"damping_ratio"},
                                estimates("amplification", "largest k x / largest load", "1", 2)},
                    .view = Results::View::none};
    for (const Point& point : points)
        results.add({summary.named(point.case_index), point.period, damping_ratio, estimate(point.amplification)});
    return results;
}

}  // namespace

Section moored_spectrum(const Evidence& evidence, double damping_ratio, double averaging, double scale) {
    const std::vector<Point> points = points_of(evidence, hulls_of(evidence, damping_ratio, averaging, scale));
    if (points.empty())
        return {.missing =
                    "Moored hull: unknown, because the file keeps no load histories (analysis.history_steps), or their "
                    "run-up and window are too short for any natural period.\n"};
    const std::string caption = fmt::format(
        "Largest mooring force k x over the largest load averaged over {:g} s, for hulls of any natural period with "
        "{:g} % of the critical damping: what moorings make of these loads.",
        averaging, damping_ratio / unit::percent);
    Results rows = spectrum_rows(evidence.summary, points, damping_ratio);
    Results shown = pivot(rows, "period", "case", {"amplification"});
    return {.title = "Response spectrum",
            .results = {std::move(shown), std::move(rows)},
            .after = "\n" + caption + undrawn_text(evidence.summary, held_still(evidence)) + "\n",
            .figures = {figure_of(evidence, points, "Dashed: the moorings feel the load as it is.")}};
}

namespace {

/// Why no member has it, a sentence or two.
std::string no_response(const Evidence& evidence, const DesignOf& of) {
    if (std::ranges::any_of(evidence.campaign.cases, [&](const Case& one) { return has(one, of); }))
        return fmt::format(
            "{}: no member has it: none is done, or they are of floes 3.0 or earlier, which kept no responses; run "
            "them again.",
            of.title);
    return fmt::format(
        "{}: no case gives way in {}. moorings.mass_t makes a structure give way, moorings.free says in which motions. "
        "--mooring-kN-m, --mass-t and --damping-percent move a hull by the stored loads of a fixed one.{}",
        of.title, of.motion_words(), of.has == nullptr ? "" : " Lines that never break (a break load of 0) have none.");
}

}  // namespace

std::vector<CasePeaks> simulated_peaks(const Evidence& evidence, const DesignOf& of) {
    const Sample& sample = evidence.sample;
    const std::size_t place = place_of(of);
    std::vector<CasePeaks> all(sample.cases.size());
    for (std::size_t index = 0; index < all.size(); ++index) {
        const Scenario& scenario = evidence.campaign.cases[index].scenario;
        const Analysis& analysis = sample.cases[index].analysis;
        if (!has(evidence.campaign.cases[index], of)) continue;
        all[index].measured = measured_in(analysis, separation_of(scenario, of));
        Lack& lacks = all[index].lacks;
        if (of.unit == "N" && by_thrusters_alone(evidence.campaign.cases[index]))
            lacks = {
                "held by thrusters alone, so there is no mooring force; summarize --parts moored has their thrust "
                "and the time at its limit",
                "thrusters alone"};
        else
            lacks = {period_refusal(analysis, scenario.general.time_step, period_of(scenario, of), 1),
                     "window too short"};
        if (lacks) continue;
        for (const std::size_t member : sample.done(index)) {
            PeakRow row = peak_row(sample, "responses", member, place);
            if (row.segment_maxima.empty()) continue;
            const double mean = sample.along("responses/mean", member)[place];
            const double rise = sample.along("responses/rise", member)[place];
            all[index].trends.push_back(member_trend(mean, rise, row.segment_maxima));
            all[index].add(static_cast<int>(member), sample.arrangement_of(member), std::move(row), mean);
        }
    }
    if (std::ranges::all_of(all, [](const CasePeaks& one) { return one.rows.empty() && !one.lacks; }))
        throw InputError(no_response(evidence, of));
    for (CasePeaks& one : all) one.average();
    return all;
}

std::string mooring_notes(const Evidence& evidence) {
    const Quantity& broken = *find_quantity("broken_lines");
    std::string text;
    for (std::size_t index = 0; index < evidence.sample.cases.size(); ++index) {
        const std::string label = evidence.summary.label_of(index);
        const Members& members = evidence.sample.done(index);
        const auto count =
            std::ranges::count_if(evidence.sample.values(members, broken), [](double lines) { return lines > 0; });
        if (count > 0)
            text += fmt::format(
                "! {}: lines broke in {} of {} members: they are held by fewer lines from then on, and their force is "
                "no design force of lines that hold.\n",
                label, count, members.size());
    }
    return text;
}

DesignLoads find_simulated_designs(const Evidence& evidence, const DesignLoadRequest& request) {
    DesignLoads designs = find_design_loads(evidence.sample, request, simulated_peaks(evidence, request.of));
    std::erase_if(designs.of_cases,
                  [&](const CaseDesignLoad& one) { return !has(evidence.campaign.cases[one.case_index], request.of); });
    return designs;
}

namespace {

/// Without what is for programs; a sentence for each case where none has any.
Section for_people(const Evidence& evidence, const DesignLoads& design) {
    if (!design.refused.empty()) return {.missing = design.refused + "\n"};
    Section section = design_values_section(evidence.summary, design);
    if (!design.known()) return {.missing = fmt::format("{}: {}", design.asked.of.title, section.before)};
    std::erase_if(section.results, [](const Results& one) { return !one.for_people(); });
    return section;
}

}  // namespace

const std::vector<DesignLoads>& simulated_of(Evidence& evidence) {
    return evidence.kept.once([&] {
        std::vector<DesignLoads> found;
        for (const DesignOf& of : response_kinds()) {
            if (of.part || std::ranges::none_of(evidence.campaign.cases, [&](const Case& one) { return has(one, of); }))
                continue;
            DesignLoads& one = found.emplace_back(evidence.design_request.value_or(DesignLoadRequest{}));
            one.asked.of = of;
            try {
                one = find_simulated_designs(evidence, one.asked);
            } catch (const InputError& refused) {
                one.refused = refused.what();
            }
        }
        return found;
    });
}

std::vector<Section> simulated_designs(Evidence& evidence) {
    std::vector<Section> sections;
    for (const DesignLoads& design : simulated_of(evidence)) sections.push_back(for_people(evidence, design));
    return sections;
}

}  // namespace floes
