#include "match/year_section.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/design_load.hpp"
#include "findings/estimates.hpp"
#include "findings/summary.hpp"
#include "match/year.hpp"

namespace floes {

namespace {

/// ISO 19906's names of the levels.
std::string level_name(double per_year) {
    if (std::abs(per_year / 1e-2 - 1) < 1e-9) return per_year_text(per_year) + " (extreme level)";
    if (std::abs(per_year / 1e-4 - 1) < 1e-9) return per_year_text(per_year) + " (abnormal level)";
    return per_year_text(per_year);
}

std::string hours_text(double seconds) {
    const double hours = seconds / unit::hour;
    return hours < 1e4 ? fmt::format("{:.3g}", hours) : fmt::format("{:.1e}", hours);
}

std::string capital(std::string sentence) {
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    return sentence;
}

/// "it asks for 3e+04 h of thin ice, and 2.1 h were run"
std::string hours_asked(const Year& year, const YearLevel& level, const YearRequest& request) {
    const double time = std::sqrt(request.load.scale);
    const auto most = std::ranges::max_element(level.shares, {}, &YearShare::value) - level.shares.begin();
    const YearRegimeRow& row = year.regimes[static_cast<std::size_t>(most)];
    return fmt::format("it asks for {} h of {}, and {} h were run",
                       hours_text(time * level.shares[static_cast<std::size_t>(most)].exceeded_once_in),
                       row.regime.name, hours_text(time * year.sources[row.tail.source].time_run));
}

/// Members that stand out, and loads asked for farther than anybody tried.
std::string doubt_lines(const Year& year, const YearRequest& request) {
    std::string lines;
    for (const TailSource& source : year.sources) {
        if (source.unlike.out.empty()) continue;
        std::vector<int> numbers;
        for (const std::size_t row : source.unlike.out) numbers.push_back(source.members[row]);
        lines += fmt::format(
            "! {}: {} of {} members stand out: replay {}. They are a kind of member whose share is "
            "uncertain.\n",
            source.words(), numbers.size(), source.members.size(), fmt::join(numbers, ", "));
    }
    for (const YearLevel& level : year.levels)
        if (level.beyond_run > tried_beyond)
            lines += fmt::format(
                "! The load of {} a year is farther from what was run than these intervals were ever "
                "tried: {}.\n",
                per_year_text(level.per_year), hours_asked(year, level, request));
    return lines;
}

/// Whether the interval says something of the load, of sources that all have enough arrangements.
bool is_said(const YearFigure& load, const Year& year) {
    std::size_t fewest = year.sources.front().members.size();
    for (const TailSource& source : year.sources) fewest = std::min(fewest, source.members.size());
    return says_something(load.value, load.interval, static_cast<int>(fewest));
}

/// With its limits alone where they say nothing of it.
Estimate at_scale(const YearFigure& load, const Year& year, const YearRequest& request) {
    const double factor = request.load.factor();
    return {is_said(load, year) ? factor * load.value : std::nan(""), factor * load.interval.low,
            factor * load.interval.high};
}

/// The exceedance curve, for programs.
Results curve_rows(const Year& year, const YearRequest& request) {
    Results results{
        .place = "year/curve", .columns = {{"exceeded_a_year"}, estimates("load", "")}, .view = Results::View::none};
    for (const YearCurvePoint& point : year.curve) results.add({point.per_year, at_scale(point.all, year, request)});
    return results;
}

Section loads_section(const Year& year, const YearRequest& request) {
    ResultColumn load = estimates("", "load", "N");
    load.digits = 3;
    Results results{.place = "year/loads",
                    .columns = std::vector<ResultColumn>{{.words = "exceeded in a year with"}, std::move(load)} +
                               program_columns("exceeded_a_year averaging scale")};
    results.columns.push_back(estimates("load", ""));
    results.columns.push_back({"hours_for_one_over_hours_run"});
    std::vector<std::string> notes;
    const Units units = year_units(year, request);
    for (const YearLevel& level : year.levels) {
        const bool said = is_said(level.load, year);
        const Estimate told = at_scale(level.load, year, request);
        results.add({level_name(level.per_year), if_known(said, told), level.per_year, request.load.averaging,
                     request.load.scale, told, level.beyond_run});
        if (!std::isfinite(level.load.value))
            notes.push_back(fmt::format("{}: the regimes have so few hours that no load is exceeded so often.",
                                        per_year_text(level.per_year)));
        else if (!said)
            notes.push_back(fmt::format(
                "{}: the tail cannot say: its interval is from {} to {}, wider than four times the load. {}; run more "
                "members of what --next names, or longer windows.",
                per_year_text(level.per_year), units.number(told.low, "N"), units.text(told.high, "N"),
                capital(hours_asked(year, level, request))));
    }
    return {.title = fmt::format("Loads of a year: the largest averaged over {:g} s", request.load.averaging),
            .results = {std::move(results), curve_rows(year, request)},
            .after =
                "\nBrackets: 95 %, from draws of each regime's tails (both tails, docs/design_load.md). docs/year.md\n",
            .notes = std::move(notes)};
}

/// A line for each regime, and for programs one for each regime and level.
Section regimes_section(const Year& year, const YearRequest& request) {
    const double hours = std::sqrt(request.load.scale) / unit::hour;
    Results shown{.columns = {{.words = "regime"}, {.words = "h a year", .digits = 6}, {.words = "tail of"}}};
    for (const YearLevel& level : year.levels) {
        shown.columns.push_back(
            {.words = fmt::format("share at {}", per_year_text(level.per_year)), .unit = "share", .decimals = 0});
        shown.columns.push_back({.words = "once in, h"});
    }
    ResultColumn share = estimates("share", "");
    Results all{.place = "year/regimes",
                .columns = program_columns("regime hours_a_year source factor factor_sd exceeded_a_year"),
                .view = Results::View::none};
    all.columns.push_back(std::move(share));
    all.columns.push_back({"hours_for_one"});
    for (std::size_t k = 0; k < year.regimes.size(); ++k) {
        const YearRegimeRow& row = year.regimes[k];
        const TailSource& source = year.sources[row.tail.source];
        const std::string tail =
            source.of_case ? source.words() : fmt::format("{} ± {:.0f} %", source.words(), 196 * row.tail.factor_sd);
        std::vector<Datum> line{row.regime.name, row.regime.time / unit::hour, tail};
        for (const YearLevel& level : year.levels) {
            const bool known = std::isfinite(level.load.value);
            const double once = hours * unit::hour * level.shares[k].exceeded_once_in;
            line.push_back(if_known(known, level.shares[k].value));
            line.push_back(if_known(known, hours_text(once)));
        }
        shown.add(std::move(line));
    }
    for (const YearLevel& level : year.levels)
        for (std::size_t k = 0; k < level.shares.size(); ++k) {
            const YearRegimeRow& row = year.regimes[k];
            const YearShare& of = level.shares[k];
            all.add({row.regime.name, row.regime.time / unit::hour, year.sources[row.tail.source].words(),
                     row.tail.factor, row.tail.factor_sd, level.per_year,
                     Estimate{of.value, of.interval.low, of.interval.high}, hours * of.exceeded_once_in});
        }
    return {.results = {std::move(shown), std::move(all)},
            .after =
                "\nShare: of the expected number of peaks above the load, by regime. Once in: the hours of the "
                "regime in which it exceeds the load once on average.\n"};
}

Section sources_section(const Year& year, const YearRequest& request) {
    const double hours = std::sqrt(request.load.scale) / unit::hour;
    Results shown{.columns = {{.words = "what it rests on"}, {.words = "members"}, {.words = "run, h"}}};
    for (const YearLevel& level : year.levels)
        shown.columns.push_back({.words = fmt::format("of the uncertainty at {}", per_year_text(level.per_year)),
                                 .unit = "share",
                                 .decimals = 0});
    for (std::size_t k = 0; k < year.sources.size(); ++k) {
        const TailSource& source = year.sources[k];
        std::vector<Datum> line{source.words(), source.members.size(),
                                hours_text(hours * unit::hour * source.time_run)};
        for (const YearLevel& level : year.levels)
            line.push_back(level.uncertainty.empty() ? Datum(Undefined{}) : Datum(level.uncertainty[k]));
        shown.add(std::move(line));
    }
    Results all{.place = "year/sources",
                .columns = program_columns("source members hours_run stand_out exceeded_a_year share_of_uncertainty"),
                .view = Results::View::none};
    for (const YearLevel& level : year.levels)
        for (std::size_t k = 0; k < level.uncertainty.size(); ++k) {
            const TailSource& source = year.sources[k];
            all.add({source.words(), source.members.size(), hours * source.time_run, source.unlike.out.size(),
                     level.per_year, level.uncertainty[k]});
        }
    return {.results = {std::move(shown), std::move(all)},
            .after = fmt::format(
                "\nOf the uncertainty: the part of the variance of the load's logarithm that would go if "
                "this tail were known. A kind of member that is none of the {} may be {} of all; its "
                "loads are not in the figures.\n",
                year.sources.front().members.size(), percent_of(unseen_share(year.sources.front().members.size())))};
}

}  // namespace

Units year_units(const Year& year, const YearRequest& request) {
    double largest = 0;
    for (const YearLevel& level : year.levels)
        if (level.load.value > largest) largest = level.load.value;
    return Units(largest * request.load.factor());
}

std::vector<Section> year_sections(const Evidence& evidence, const Year& year, const YearRequest& request) {
    double hours = 0;
    for (const YearRegimeRow& row : year.regimes) hours += row.regime.time / unit::hour;
    Section basis = sources_section(year, request);
    if (std::optional<Figure> figure = year_figure(year, request)) basis.figures = {std::move(*figure)};
    const std::string scale =
        request.load.scale == 1
            ? ""
            : fmt::format("Full scale by Froude, 1 : {:g}: hours, averaging time and loads are those at full scale.\n",
                          request.load.scale);
    return {{.before = fmt::format("{}Campaign {}: {} regimes with {:g} h a year.\n{}{}\n", doubt_lines(year, request),
                                   evidence.summary.title, year.regimes.size(), hours, scale,
                                   fmt::join(condition_lines(evidence.summary), "\n"))},
            loads_section(year, request),
            regimes_section(year, request),
            std::move(basis)};
}

bool says_some_load(const Year& year) {
    return std::ranges::any_of(year.levels, [&](const YearLevel& level) { return is_said(level.load, year); });
}

std::optional<Figure> year_figure(const Year& year, const YearRequest& request) {
    constexpr std::size_t most_told_apart = 6;
    const double factor = request.load.factor();
    std::vector<double> values;
    Figure::Points low, high, middle;
    for (const YearCurvePoint& point : year.curve) {
        if (!is_said(point.all, year)) continue;
        low.emplace_back(factor * point.all.interval.low, point.per_year);
        high.emplace_back(factor * point.all.interval.high, point.per_year);
        middle.emplace_back(factor * point.all.value, point.per_year);
        values.push_back(middle.back().first);
        values.push_back(std::min(high.back().first, 3 * middle.back().first));
    }
    if (middle.empty()) return {};
    const double rarest = year.curve.back().per_year;
    Figure figure{.description = "Probability that the largest load of a year exceeds a load",
                  .x = axis_around(fmt::format("largest load of a year, averaged over {:g} s", request.load.averaging),
                                   values, true, "N"),
                  .y = {"probability of exceedance in a year", rarest * 0.7, 1, true},
                  .size = {720, 380}};
    // The band lies between curves along the loads, so it is an outline, cut off where the axis ends.
    Figure::Points outline = low;
    outline.insert(outline.end(), high.rbegin(), high.rend());
    for (auto& [load, probability] : outline) load = std::clamp(load, figure.x.low, figure.x.high);
    figure.area(std::move(outline), "ink veil");
    const bool colours = year.regimes.size() <= most_told_apart;
    for (std::size_t regime = 0; regime < year.regimes.size(); ++regime) {
        Figure::Points line;
        for (const YearCurvePoint& point : year.curve)
            if (is_said(point.all, year) && std::isfinite(point.alone[regime]) &&
                factor * point.alone[regime] <= figure.x.high)
                line.emplace_back(factor * point.alone[regime], point.per_year);
        figure.line(std::move(line), colours ? colour(regime) : "thin");
        if (colours) figure.legend.emplace_back(colour(regime), year.regimes[regime].regime.name);
    }
    const std::size_t middle_count = middle.size();
    figure.line(std::move(middle), "thick");
    figure.legend.emplace_back("ink", "all regimes");
    for (const YearLevel& level : year.levels) figure.level(level.per_year, "dashed");
    figure.caption = fmt::format(
        "Probability that the largest load of a year exceeds a load: of all regimes (thick, with its 95 % interval), "
        "and of each as if there were no other{}. Dashed: the probabilities asked for.{}",
        colours ? "" : " (thin)",
        middle_count < year.curve.size() ? " Loads whose interval says nothing of them are left out." : "");
    return figure;
}

Section year_next(const Evidence& evidence, const Year& year, const std::string& program) {
    const YearLevel& rarest = *std::ranges::min_element(year.levels, {}, &YearLevel::per_year);
    if (rarest.uncertainty.empty())
        return {.before = "Next: nothing, because no regime has the load so often; check hours_per_year.\n"};
    const auto widest =
        static_cast<std::size_t>(std::ranges::max_element(rarest.uncertainty) - rarest.uncertainty.begin());
    const TailSource& source = year.sources[widest];
    const std::string& name = evidence.campaign.name;
    const int arrangements = 2 * std::max(evidence.campaign.arrangements, static_cast<int>(source.arrangements));
    return {
        .before = fmt::format(
            "Next: {} wants more members: it has {} of the uncertainty of the load of {} a year.\n  {} run {}.toml -o "
            "{} --set campaign.arrangements={} --resume\nThis doubles the arrangements of all cases; what is done is "
            "not computed again. Give every --set of the first run as well.\n",
            source.words(), percent_of(rarest.uncertainty[widest]), per_year_text(rarest.per_year), program, name,
            evidence.file.string(), arrangements)};
}

}  // namespace floes
