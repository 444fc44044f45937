#include "findings/extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/units.hpp"

namespace floes {

namespace {

/// Of the reported levels, in segments.
constexpr double return_periods[]{10, 100, 1000};

std::array<const FittedExtreme*, 2> fits_of(const CaseExtremes& one) {
    return {&one.gumbel, &one.gev};
}

std::string hours(double seconds) {
    return seconds < unit::hour ? fmt::format("{:.3g} min", seconds / 60)
                                : fmt::format("{:.3g} h", seconds / unit::hour);
}

/// Columns for people, then those for programs.
Results empty_fits() {
    Results results{.place = "extremes",
                    .columns = {{.words = "segment maxima"},
                                {.words = "location", .unit = "N"},
                                {.words = "scale", .unit = "N"},
                                {.words = "ξ", .decimals = 2},
                                {.words = "p A²", .p = true}}};
    for (const double period : return_periods)
        results.columns.push_back({.words = fmt::format("1 in {:g}", period), .unit = "N"});
    results.columns = std::move(results.columns) +
                      program_columns(
                          "case distribution averaging segment maxima location scale shape log_likelihood "
                          "anderson_darling anderson_darling_p kolmogorov_smirnov kolmogorov_smirnov_p");
    for (const double period : return_periods) results.columns.push_back({fmt::format("level_{:g}", period)});
    return results;
}

void add_fit(const Summary& summary, const CaseExtremes& extremes, const FittedExtreme& fitted, Results& results) {
    const bool gev = &fitted == &extremes.gev;
    std::vector<Datum> row{fmt::format("  {}{}", name_of(fitted.kind), fitted.fit.valid() ? "" : ": no fit"),
                           fitted.fit.location, fitted.fit.scale, gev ? Datum(fitted.fit.shape) : Datum(Absent{}),
                           fitted.goodness.anderson_darling_p};
    for (const double period : return_periods) row.push_back(return_level(fitted.fit, period));
    row.insert(row.end(),
               {summary.named(extremes.case_index), name_of(fitted.kind), extremes.averaging, extremes.segment,
                extremes.maxima, fitted.fit.location, fitted.fit.scale, fitted.fit.shape, fitted.fit.log_likelihood,
                fitted.goodness.found.anderson_darling, fitted.goodness.anderson_darling_p,
                fitted.goodness.found.kolmogorov_smirnov, fitted.goodness.kolmogorov_smirnov_p});
    for (const double period : return_periods) row.emplace_back(return_level(fitted.fit, period));
    const bool valid = extremes.gumbel.fit.valid();
    results.add(std::move(row), valid ? Results::For::everybody : Results::For::programs);
}

Results fit_results(const Summary& summary, const std::vector<CaseExtremes>& all) {
    Results results = empty_fits();
    for (const CaseExtremes& extremes : all) {
        results.add_heading(fmt::format("{}, {} maxima{}", summary.label_of(extremes.case_index), extremes.maxima,
                                        extremes.gumbel.fit.valid() ? ""
                                        : extremes.maxima >= fewest_maxima
                                            ? ": all equal, or nearly, which no distribution fits"
                                            : fmt::format(": too few to fit ({} or more)", fewest_maxima)));
        for (const FittedExtreme* fitted : fits_of(extremes)) add_fit(summary, extremes, *fitted, results);
    }
    return results;
}

std::string of_what(const std::vector<CaseExtremes>& all) {
    const double averaging = all.empty() ? 0 : all.front().averaging;
    return averaging > 0 ? fmt::format("of the load averaged over {:g} s", averaging)
                         : std::string{"of single steps, which depend on the time step"};
}

/// What the number of tests does to chance.
std::string chance_text(const std::vector<CaseExtremes>& extremes) {
    std::size_t tests = 0;
    for (const CaseExtremes& one : extremes) tests += one.gumbel.fit.valid() ? fits_of(one).size() : 0;
    if (tests < 2) return "";
    return fmt::format(" p A² stands here {} times; of fits that are right one in twenty is below 0.05.", tests);
}

/// The maxima with both fits, exceedance over load.
Figure exceedance_figure(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    std::vector<double> loads;
    double least = 1;
    for (const CaseExtremes& one : extremes) {
        for (const ExceedancePoint& point : one.exceedance) {
            loads.push_back(point.load);
            least = std::min(least, point.probability);
        }
    }
    const double floor = least / 20;
    Axis x = axis_around("largest load of a segment", loads, true, "N");
    x.high *= 1.4;
    Figure figure{.description = "Probability that a segment's largest load exceeds a load",
                  .x = x,
                  .y = {"probability of exceedance", floor, 1, true},
                  .size = {720, 380},
                  .legend = case_legend(summary),
                  .caption = fmt::format(
                      "Dots: maxima of all segments, {}. Lines: Gumbel, dashed: GEV, fitted by maximum likelihood.",
                      of_what(extremes))};
    for (std::size_t i = 0; i < extremes.size(); ++i) {
        const CaseExtremes& one = extremes[i];
        for (const ExceedancePoint& point : one.exceedance) figure.dot(point.load, point.probability, colour(i), 2.5);
        for (const FittedExtreme* fitted : fits_of(one)) {
            if (!fitted->fit.valid()) continue;
            Figure::Points curve;
            for (int step = 0; step <= 200; ++step) {
                const double load = x.low + (x.high - x.low) * step / 200;
                const double probability = 1 - extreme_cdf(fitted->fit, load);
                if (probability >= floor && probability < 1) curve.emplace_back(load, probability);
            }
            figure.line(std::move(curve), colour(i) + (fitted == &one.gumbel ? "" : " dashed"));
        }
    }
    return figure;
}

}  // namespace

std::vector<CaseExtremes> find_extremes(const Sample& sample) {
    const std::vector<Quantity> of_members = sample.quantities();
    const double averaging = headline_maximum(of_members).averaging;
    std::vector<CaseExtremes> all;
    for (std::size_t index = 0; index < sample.cases.size(); ++index) {
        std::vector<double> maxima;
        for (const std::size_t member : sample.done(index)) {
            const auto place = sample.place_of_time(member, averaging);
            if (averaging > 0 && !place) continue;
            const std::span<const double> own = averaging > 0 ? sample.along("averaged/segment_maximum", member, *place)
                                                              : sample.along("members/segment_maximum", member);
            maxima.insert(maxima.end(), own.begin(), own.end());
        }
        const Analysis& analysis = sample.cases[index].analysis;
        all.push_back({.case_index = index,
                       .averaging = averaging,
                       .segment = analysis.window / analysis.segments,
                       .maxima = maxima.size(),
                       .gumbel = fit_extremes(maxima, ExtremeKind::gumbel),
                       .gev = fit_extremes(maxima, ExtremeKind::gev),
                       .exceedance = exceedance_curve(maxima)});
    }
    return all;
}

const char* name_of(ExtremeKind kind) {
    return kind == ExtremeKind::gumbel ? "Gumbel" : "GEV";
}

Section extremes_section(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    Section section{.title = "Extremes",
                    .results = {fit_results(summary, extremes)},
                    .figures = {exceedance_figure(summary, extremes)}};
    const auto fitted =
        std::ranges::find_if(extremes, [](const CaseExtremes& of_case) { return of_case.gumbel.fit.valid(); });
    if (fitted == extremes.end()) {
        const bool few =
            std::ranges::all_of(extremes, [](const CaseExtremes& one) { return one.maxima < fewest_maxima; });
        section.before = few ? fmt::format("Too few segment maxima to fit in every case; {} would do.\n", fewest_maxima)
                             : fmt::format("No case has {} segment maxima that differ enough to fit.\n", fewest_maxima);
        section.results.front().view = Results::View::none;
        return section;
    }
    const bool equal = std::ranges::all_of(
        extremes, [&](const CaseExtremes& one) { return !one.gumbel.fit.valid() || one.segment == fitted->segment; });
    section.after = fmt::format(
        "\nMaxima {}. Maximum likelihood; 1 in N: the load that one segment in N exceeds ({}). ξ: shape, below 0 with "
        "an upper bound. p A²: Anderson-Darling; small: poor fit of the "
        "distribution.\nFor exposures longer than the one simulated, a return level is an extrapolation; floes design "
        "has loads with intervals.{}\n",
        of_what(extremes),
        equal ? fmt::format("a segment: {:g} s; 1 in 1000: once in {}", fitted->segment, hours(1000 * fitted->segment))
              : std::string{"segments differ in length"},
        chance_text(extremes));
    return section;
}

Section exceedance_section(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    Results results{.place = "exceedance", .columns = program_columns("case load empirical gumbel gev")};
    const auto beyond = [](const ExtremeFit& fit, double load) {
        return fit.valid() ? Datum(1 - extreme_cdf(fit, load)) : Datum(Undefined{});
    };
    for (const CaseExtremes& of_case : extremes)
        for (const ExceedancePoint& point : of_case.exceedance)
            results.add({summary.named(of_case.case_index), point.load, point.probability,
                         beyond(of_case.gumbel.fit, point.load), beyond(of_case.gev.fit, point.load)});
    return {.results = {std::move(results)}};
}

namespace {

/// None where no load came above any level.
std::vector<Figure> levels_figures(const Summary& summary, const std::vector<LevelRow>& rows) {
    std::vector<double> loads;
    double least = 1;
    bool any = false;
    for (const LevelRow& row : rows) {
        loads.push_back(row.level);
        if (!(row.time_above.estimate > 0)) continue;
        least = std::min(least, row.time_above.estimate);
        any = true;
    }
    if (!any) return {};
    const double floor = least / 3;
    Figure figure{.description = "Share of the time with a surge load above a level",
                  .x = axis_around("surge load", loads, true, "N"),
                  .y = {"share of the time", floor, 1, true},
                  .size = {720, 340},
                  .legend = case_legend(summary),
                  .caption =
                      "Share of the time in the window with a surge load above the levels that the members counted at "
                      "every step: mean over arrangements with its 95 % interval."};
    const std::size_t cases = summary.cases.size();
    for (std::size_t i = 0; i < cases; ++i) {
        // A small offset puts the intervals of one level side by side.
        const double aside =
            0.006 * (figure.x.high - figure.x.low) * (static_cast<double>(i) - 0.5 * static_cast<double>(cases - 1));
        Figure::Points curve;
        for (const LevelRow& row : rows) {
            if (row.case_index != i || !(row.time_above.estimate > 0)) continue;
            const double at = row.level + aside;
            curve.emplace_back(at, row.time_above.estimate);
            figure.line({{at, std::max(floor, row.time_above.low)}, {at, row.time_above.high}}, colour(i) + " thin");
            figure.dot(at, row.time_above.estimate, colour(i), 3);
        }
        figure.line(std::move(curve), colour(i));
    }
    return {std::move(figure)};
}

}  // namespace

std::vector<LevelRow> find_levels(const Sample& sample) {
    std::vector<LevelRow> rows;
    for (std::size_t index = 0; index < sample.cases.size(); ++index) {
        const CaseRow& about = sample.cases[index];
        for (std::size_t level = 0; level < sample.levels.size(); ++level) {
            const auto counted = [&](std::string_view array, double whole) {
                std::vector<double> counts = measured(sample.values(sample.done(index), array, level));
                for (double& count : counts) count /= whole;
                return counts;
            };
            const std::vector<double> shares = counted("exceedance/steps_above", about.window_steps());
            const std::vector<double> rates = counted("exceedance/upcrossings", about.analysis.window);
            if (shares.empty()) continue;
            rows.push_back({index, sample.levels[level], static_cast<int>(shares.size()),
                            clipped(mean_interval(shares), 0, 1),
                            clipped(mean_interval(rates), 0, std::numeric_limits<double>::infinity())});
        }
    }
    return rows;
}

Section levels_section(const Summary& summary, const std::vector<LevelRow>& rows) {
    Results results{.place = "load_levels",
                    .columns = {{"case", "case"},
                                {.key = "level", .words = "load", .unit = "N", .digits = 4},
                                {"runs", "runs"},
                                estimates("time_above", "time above", "share", 3),
                                estimates("", "rises per minute", "1", 2),
                                estimates("upcrossings_per_s", "")}};
    for (const LevelRow& row : rows) {
        const Estimate rises = estimate(row.upcrossings);
        results.add({summary.named(row.case_index), row.level, row.runs, estimate(row.time_above), 60 * rises, rises});
    }
    if (rows.empty()) {
        results.in_csv = false;
        return {.before =
                    "Load levels: no member counted any (analysis.exceedance_levels_N). For the exceedance curve of "
                    "the segment maxima use --format csv or json.\n",
                .results = {std::move(results)}};
    }
    return {.title = "Load levels",
            .results = {std::move(results)},
            .after =
                "\nTime above: share of the window with a surge load above the level; rises: how often the load rises "
                "through it.\nCounted in each member at every time step; mean over arrangements with its 95 % interval "
                "(t).\n",
            .figures = levels_figures(summary, rows)};
}

}  // namespace floes
