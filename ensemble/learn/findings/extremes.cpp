#include "findings/extremes.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/units.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

std::array<const FittedExtreme*, 2> fits_of(const CaseExtremes& one) {
    return {&one.gumbel, &one.gev};
}

std::string hours(double seconds) {
    return seconds < unit::hour ? fmt::format("{:.3g} min", seconds / 60)
                                : fmt::format("{:.3g} h", seconds / unit::hour);
}

/// "–" where the bootstrap says no more than that nothing is known.
std::string level_range(const ReturnLevel& level, int decimals) {
    return says_something(level.level, level.interval, fewest_for_interval)
               ? bracket(level.interval.low, level.interval.high, decimals)
               : "–";
}

std::vector<Cell> line(const CaseExtremes& one, const FittedExtreme& fitted) {
    constexpr double edge = 0.99;  // of the shapes that are looked at
    const bool degenerate = &fitted == &one.gev && std::abs(fitted.fit.shape) > edge;
    if (degenerate) {
        std::vector<Cell> cells(5 + fitted.levels.size(), "–");
        cells.front() = fmt::format("  {}: no fit", name_of(fitted.kind));
        return cells;
    }
    const int decimals = decimals_for(std::abs(fitted.fit.location));
    std::vector<Cell> cells{fmt::format("  {}", name_of(fitted.kind)), fixed(fitted.fit.location, decimals),
                            fixed(fitted.fit.scale, decimals), &fitted == &one.gev ? fixed(fitted.fit.shape, 2) : "",
                            p_text(fitted.goodness.anderson_darling_p)};
    for (const ReturnLevel& level : fitted.levels)
        cells.emplace_back(fixed(level.level, decimals), level_range(level, decimals));
    return cells;
}

/// Columns of one fit of a case; in JSON at `place` in the case's record.
template <class Row>
void add_fit(const std::string& place, const std::function<const FittedExtreme&(const Row&)>& fit_of,
             std::vector<DataColumn<Row>>& columns) {
    const auto add = [&](const std::string& csv, const std::string& json, auto value) {
        columns.push_back({Names{csv, place + json}, [=](const Row& row) { return Datum(value(fit_of(row))); }});
    };
    const auto add_limits = [&](const std::string& csv, const std::string& json, Limits FittedExtreme::*limits) {
        add(csv + "_low", json + "_interval/low", [=](const FittedExtreme& one) { return (one.*limits).low; });
        add(csv + "_high", json + "_interval/high", [=](const FittedExtreme& one) { return (one.*limits).high; });
    };
    add("location_N", "location_N", [](const FittedExtreme& one) { return one.fit.location; });
    add_limits("location", "location", &FittedExtreme::location);
    add("scale_N", "scale_N", [](const FittedExtreme& one) { return one.fit.scale; });
    add_limits("scale", "scale", &FittedExtreme::scale);
    add("shape", "shape", [](const FittedExtreme& one) { return one.fit.shape; });
    add_limits("shape", "shape", &FittedExtreme::shape);
    add("log_likelihood", "log_likelihood", [](const FittedExtreme& one) { return one.fit.log_likelihood; });
    add("anderson_darling", "anderson_darling",
        [](const FittedExtreme& one) { return one.goodness.found.anderson_darling; });
    add("anderson_darling_p", "anderson_darling_p",
        [](const FittedExtreme& one) { return one.goodness.anderson_darling_p; });
    add("kolmogorov_smirnov", "kolmogorov_smirnov",
        [](const FittedExtreme& one) { return one.goodness.found.kolmogorov_smirnov; });
    add("kolmogorov_smirnov_p", "kolmogorov_smirnov_p",
        [](const FittedExtreme& one) { return one.goodness.kolmogorov_smirnov_p; });
    for (std::size_t k = 0; k < std::size(return_periods); ++k) {
        const std::string csv = fmt::format("level_{:g}", return_periods[k]);
        const std::string json = fmt::format("return_levels/{}/", k);
        const auto add_level = [&](const std::string& column, const std::string& name, auto value) {
            add(column, json + name, [=](const FittedExtreme& one) { return Datum(value(one.levels.at(k))); });
        };
        add_level("", "segments", [](const ReturnLevel& one) { return one.segments; });
        add_level(csv + "_N", "level_N", [](const ReturnLevel& one) { return one.level; });
        add_level(csv + "_low", "interval/low", [](const ReturnLevel& one) { return one.interval.low; });
        add_level(csv + "_high", "interval/high", [](const ReturnLevel& one) { return one.interval.high; });
    }
}

/// For JSON: a record for each case.
DataRows case_records(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    std::vector<DataColumn<CaseExtremes>> columns{
        {"case", [&](const CaseExtremes& one) { return summary.name_of(one.case_index); }},
        {"segment_s", &CaseExtremes::segment},
        {"maxima", &CaseExtremes::maxima}};
    add_fit<CaseExtremes>(
        "gumbel/", [](const CaseExtremes& one) -> const FittedExtreme& { return one.gumbel; }, columns);
    add_fit<CaseExtremes>(
        "gev/", [](const CaseExtremes& one) -> const FittedExtreme& { return one.gev; }, columns);
    return json_only(make_rows<CaseExtremes>("extremes", extremes, columns));
}

/// For CSV: a line for each fit.
DataRows fit_records(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    struct Line {
        const CaseExtremes* of;
        const FittedExtreme* fitted;
    };
    std::vector<Line> lines;
    for (const CaseExtremes& one : extremes)
        for (const FittedExtreme* fitted : fits_of(one)) lines.push_back({&one, fitted});
    std::vector<DataColumn<Line>> columns{
        {"case", [&](const Line& line) { return summary.name_of(line.of->case_index); }},
        {"distribution", [](const Line& line) { return name_of(line.fitted->kind); }},
        {"segment_s", [](const Line& line) { return line.of->segment; }},
        {"maxima", [](const Line& line) { return line.of->maxima; }}};
    add_fit<Line>(
        "", [](const Line& line) -> const FittedExtreme& { return *line.fitted; }, columns);
    return csv_only(make_rows<Line>("", lines, columns));
}

/// What the number of tests does to chance.
std::string chance_text(const std::vector<CaseExtremes>& extremes) {
    std::size_t tests = 0;
    for (const CaseExtremes& one : extremes) tests += one.gumbel.fit.valid() ? fits_of(one).size() : 0;
    if (tests < 2) return "";
    return fmt::format(" p A² stands here {} times; of fits that are right one in twenty is below 0.05.", tests);
}

}  // namespace

std::vector<CaseExtremes> find_extremes(const CampaignTable& table) {
    std::vector<CaseExtremes> all;
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        std::vector<std::vector<double>> maxima;
        std::vector<double> pooled;
        for (const MemberRow& row : table.members) {
            if (row.case_index != static_cast<int>(index) || !row.done()) continue;
            maxima.push_back(row.load.segment_maximum);
            pooled.insert(pooled.end(), row.load.segment_maximum.begin(), row.load.segment_maximum.end());
        }
        const Analysis& analysis = table.cases[index].analysis;
        CaseExtremes found;
        found.case_index = index;
        found.segment = analysis.window / analysis.segments;
        found.maxima = pooled.size();
        found.gumbel = fit_extremes(maxima, ExtremeKind::gumbel, return_periods);
        found.gev = fit_extremes(maxima, ExtremeKind::gev, return_periods);
        found.exceedance = exceedance_curve(std::move(pooled));
        all.push_back(std::move(found));
    }
    return all;
}

const char* name_of(ExtremeKind kind) {
    return kind == ExtremeKind::gumbel ? "Gumbel" : "GEV";
}

Section extremes_section(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    Table table{{"segment maxima, N", "location", "scale", "ξ", "p A²"}};
    for (const double period : return_periods) table.front().emplace_back(fmt::format("1 in {:g}", period));
    std::string lengths;
    for (const CaseExtremes& one : extremes) {
        table.emplace_back(table.front().size(), "").front() =
            fmt::format("{}, {} maxima{}", summary.label_of(one.case_index), one.maxima,
                        one.gumbel.fit.valid() ? "" : fmt::format(": too few to fit ({} or more)", fewest_maxima));
        if (!one.gumbel.fit.valid()) continue;
        for (const FittedExtreme* fitted : fits_of(one)) table.push_back(line(one, *fitted));
        if (lengths.empty()) {
            lengths =
                fmt::format(" (a segment: {:g} s; 1 in 1000: once in {})", one.segment, hours(1000 * one.segment));
        }
    }
    if (lengths.empty())
        return {.title = "Extremes",
                .before = fmt::format("Too few segment maxima to fit in every case; {} would do.\n", fewest_maxima),
                .records = {case_records(summary, extremes), fit_records(summary, extremes)},
                .figures = {exceedance_figure(summary, extremes)}};
    return {.title = "Extremes",
            .table = std::move(table),
            .after = fmt::format(
                "\nMaximum likelihood; 1 in N: the load that one segment in N exceeds{}, interval by bootstrap over "
                "arrangements. ξ: shape, below 0 with an upper bound. p A²: Anderson-Darling; small: poor fit of the "
                "distribution.\nFor exposures longer than the one simulated, a return level is an extrapolation.{}\n",
                lengths, chance_text(extremes)),
            .records = {case_records(summary, extremes), fit_records(summary, extremes)},
            .figures = {exceedance_figure(summary, extremes)}};
}

Section exceedance_section(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    struct Point {
        const CaseExtremes* of;
        ExceedancePoint at;
    };
    std::vector<Point> points;
    Section section{.records = {case_records(summary, extremes)}};
    for (std::size_t k = 0; k < extremes.size(); ++k) {
        section.records.push_back(json_only(make_rows<ExceedancePoint>(
            fmt::format("extremes/{}/exceedance", k), extremes[k].exceedance,
            {{"load_N", &ExceedancePoint::load}, {"probability", &ExceedancePoint::probability}})));
        for (const ExceedancePoint& point : extremes[k].exceedance) points.push_back({&extremes[k], point});
    }
    const auto beyond = [](const ExtremeFit& fit, double load) {
        return fit.valid() ? Datum(1 - extreme_cdf(fit, load)) : Datum(Undefined{});
    };
    section.records.push_back(csv_only(
        make_rows<Point>("", points,
                         {{"case", [&](const Point& point) { return summary.name_of(point.of->case_index); }},
                          {"load_N", [](const Point& point) { return point.at.load; }},
                          {"empirical", [](const Point& point) { return point.at.probability; }},
                          {"gumbel", [&](const Point& point) { return beyond(point.of->gumbel.fit, point.at.load); }},
                          {"gev", [&](const Point& point) { return beyond(point.of->gev.fit, point.at.load); }}})));
    return section;
}

}  // namespace floes
