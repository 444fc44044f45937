#include "year/year_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/design_load_pairs.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"
#include "year/year_records.hpp"
#include "year/year_words.hpp"

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

LoadUnit unit_for(const Year& year, const YearRequest& request) {
    double largest = 0;
    for (const YearLevel& level : year.levels)
        if (level.load.value > largest) largest = level.load.value;
    const LoadUnit unit = load_unit(largest * request.load.force_factor());
    return {unit.name, unit.factor * request.load.force_factor()};
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

Section loads_section(const Year& year, const YearRequest& request, const LoadUnit& unit) {
    Table table{{"exceeded in a year with", {fmt::format("load, {}", unit.name), "95 %"}}};
    std::vector<std::string> notes;
    std::size_t fewest = year.sources.front().members.size();
    for (const TailSource& source : year.sources) fewest = std::min(fewest, source.members.size());
    for (const YearLevel& level : year.levels) {
        const bool said = says_something(level.load.value, level.load.interval, static_cast<int>(fewest));
        table.push_back(
            {level_name(level.per_year),
             said ? range_cell({level.load.value, level.load.interval}, unit.factor, said) : Cell{"–", "–"}});
        if (!std::isfinite(level.load.value))
            notes.push_back(fmt::format("{}: the regimes have so few hours that no load is exceeded so often.",
                                        per_year_text(level.per_year)));
        else if (!said)
            notes.push_back(fmt::format(
                "{}: the tail cannot say: its interval is from {:.3g} to {:.3g} {}, wider than four times the load. "
                "{}; "
                "run more members of what --next names, or longer windows.",
                per_year_text(level.per_year), unit.factor * level.load.interval.low,
                unit.factor * level.load.interval.high, unit.name, capital(hours_asked(year, level, request))));
    }
    return {.title = fmt::format("Loads of a year: the largest averaged over {:g} s", request.load.averaging),
            .table = std::move(table),
            .after =
                "\nBrackets: 95 %, from draws of each regime's tails (both tails, docs/design_load.md). docs/year.md\n",
            .notes = std::move(notes)};
}

Section regimes_section(const Year& year, const YearRequest& request) {
    const double time = std::sqrt(request.load.scale);
    Table table{{"regime", "h a year", "tail of"}};
    for (const YearLevel& level : year.levels) {
        table.front().emplace_back(fmt::format("share at {}", per_year_text(level.per_year)));
        table.front().emplace_back("once in, h");
    }
    for (std::size_t k = 0; k < year.regimes.size(); ++k) {
        const YearRegimeRow& row = year.regimes[k];
        const TailSource& source = year.sources[row.tail.source];
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(row.regime.name);
        line.emplace_back(fmt::format("{:g}", row.regime.time / unit::hour));
        line.emplace_back(source.of_case ? source.words()
                                         : fmt::format("{} ± {:.0f} %", source.words(), 196 * row.tail.factor_sd));
        for (const YearLevel& level : year.levels) {
            const bool known = std::isfinite(level.load.value);
            line.emplace_back(known ? percent_of(level.shares[k].value) : "–");
            line.emplace_back(known ? hours_text(time * level.shares[k].exceeded_once_in) : "–");
        }
    }
    return {.table = std::move(table),
            .after =
                "\nShare: of the expected number of peaks above the load, by regime. Once in: the hours of the "
                "regime in which it exceeds the load once on average.\n"};
}

Section sources_section(const Year& year, const YearRequest& request) {
    const double time = std::sqrt(request.load.scale);
    Table table{{"what it rests on", "members", "run, h"}};
    for (const YearLevel& level : year.levels)
        table.front().emplace_back(fmt::format("of the uncertainty at {}", per_year_text(level.per_year)));
    for (std::size_t k = 0; k < year.sources.size(); ++k) {
        const TailSource& source = year.sources[k];
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(source.words());
        line.emplace_back(fmt::format("{}", source.members.size()));
        line.emplace_back(hours_text(time * source.time_run));
        for (const YearLevel& level : year.levels)
            line.emplace_back(level.uncertainty.empty() ? "–" : percent_of(level.uncertainty[k]));
    }
    return {.table = std::move(table),
            .after = fmt::format(
                "\nOf the uncertainty: the part of the variance of the load's logarithm that would go if "
                "this tail were known. A kind of member that is none of the {} may be {} of all; its "
                "loads are not in the figures.\n",
                year.sources.front().members.size(), percent_of(unseen_share(year.sources.front().members.size())))};
}

}  // namespace

std::vector<Section> year_sections(const Evidence& evidence, const Year& year, const YearRequest& request) {
    const LoadUnit unit = unit_for(year, request);
    double hours = 0;
    for (const YearRegimeRow& row : year.regimes) hours += row.regime.time / unit::hour;
    Section loads = loads_section(year, request, unit);
    loads.records = year_records(year, request);
    Section basis = sources_section(year, request);
    basis.figures = {year_figure(year, request)};
    const std::string scale =
        request.load.scale == 1
            ? ""
            : fmt::format("Full scale by Froude, 1 : {:g}: hours, averaging time and loads are those at full scale.\n",
                          request.load.scale);
    return {{.before = fmt::format("{}Campaign {}: {} regimes with {:g} h a year.\n{}{}\n", doubt_lines(year, request),
                                   evidence.summary.title, year.regimes.size(), hours, scale,
                                   fmt::join(condition_lines(evidence.summary), "\n"))},
            std::move(loads),
            regimes_section(year, request),
            std::move(basis)};
}

}  // namespace floes
