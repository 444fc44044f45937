#include "findings/pairs_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

std::string needed_text(int arrangements) {
    return arrangements == 0 ? "–" : arrangements >= 1'000'000 ? ">10⁶" : fmt::format("{}", arrangements);
}

std::string percent(double part) {
    // Adding 0.0 avoids "-0".
    return std::isfinite(part) ? fmt::format("{:.0f} %", std::round(part / unit::percent) + 0.0) : "–";
}

std::vector<Cell> line(const Summary& summary, const PairRow& row) {
    const double factor = row.quantity.factor();
    const int decimals = row.quantity.percent ? 1 : decimals_for(std::abs(row.first_mean));
    const PairedComparison& found = row.found;
    return {fmt::format("  {} - {}", summary.label_of(row.second), summary.label_of(row.first)),
            fmt::format("{}", found.arrangements),
            fixed(found.difference * factor, decimals),
            found.arrangements < fewest_for_interval
                ? "–"
                : bracket(factor * found.interval.low, factor * found.interval.high, decimals),
            percent(found.difference / row.first_mean),
            p_text(row.t_p_holm),
            p_text(row.wilcoxon_p_holm),
            percent(found.variance_saved),
            needed_text(row.to_resolve_observed),
            needed_text(row.to_resolve_wished)};
}

std::size_t all_pairs(const Summary& summary) {
    return summary.cases.size() * (summary.cases.size() - 1) / 2;
}

/// Each pair has a row for each quantity.
std::size_t pairs_in(const std::vector<PairRow>& rows) {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [&](const PairRow& row) { return row.quantity.key == rows.front().quantity.key; }));
}

constexpr std::size_t columns_of_table = 10;

/// The rows of the three most informative quantities or, unless `headlines`, those of the others.
Table rows_of(const Summary& summary, const std::vector<PairRow>& rows, bool headlines) {
    Table table;
    ShortText last;
    for (const PairRow& row : rows) {
        if ((row.quantity.shown >= Shown::in_headlines) != headlines) continue;
        if (!(row.quantity.key == last)) {
            table.emplace_back(columns_of_table, "").front() = std::string{row.quantity.label.view()};
            last = row.quantity.key;
        }
        table.push_back(line(summary, row));
    }
    return table;
}

Figure differences(const Summary& summary, const std::vector<PairRow>& rows, const Quantity& quantity,
                   std::string caption) {
    const double factor = quantity.factor();
    std::vector<std::string> labels;  // from the bottom, so that the first pair is at the top
    std::vector<double> values{0};
    Figure figure{.description = fmt::format("Paired differences of {}", quantity.label),
                  .caption = std::move(caption)};
    for (const PairRow& row : rows | std::views::reverse) {
        if (!(row.quantity.key == quantity.key)) continue;
        const Limits& limits = row.found.interval;
        const double at = static_cast<double>(labels.size()) + 0.5;
        figure.dot(factor * row.found.difference, at, "ink", 4.5);
        values.push_back(factor * row.found.difference);
        if (row.found.arrangements >= fewest_for_interval) {
            figure.line({{factor * limits.low, at}, {factor * limits.high, at}}, "thick");
            values.insert(values.end(), {factor * limits.low, factor * limits.high});
        }
        labels.push_back(summary.label_of(row.second) + " − " + summary.label_of(row.first));
    }
    const double count = static_cast<double>(labels.size());
    figure.size = {720, 70 + 34 * count};
    figure.x = axis_around(fmt::format("difference of {} within an arrangement, 95 % interval", quantity.label), values,
                           false);
    figure.y = {"", 0, count, false, std::move(labels)};
    figure.upright(0, "dashed");
    return figure;
}

std::size_t quantities_in(const std::vector<PairRow>& rows) {
    std::size_t count = 0;
    ShortText last;
    for (const PairRow& row : rows) {
        if (row.quantity.key == last) continue;
        last = row.quantity.key;
        ++count;
    }
    return count;
}

/// How many p values there are, and what that does to chance.
std::string chance_text(const std::vector<PairRow>& rows) {
    constexpr double level = 0.05;
    const std::size_t quantities = quantities_in(rows);
    const std::size_t pairs = pairs_in(rows);
    if (quantities * pairs < 2) return "";
    return fmt::format(
        "Looked at: {} in {}, with two tests each. Where nothing differs, an adjusted p of a quantity is below {:g} "
        "in 5 of 100 campaigns by chance{}.\n",
        quantities == 1 ? std::string{"one quantity"} : fmt::format("{} quantities", quantities),
        counted(static_cast<int>(pairs), "pair"), level,
        quantities == 1
            ? std::string{}
            : fmt::format(", one of any quantity in up to {:.0f} (fewer, the more they go together): name the "
                          "quantity before you look",
                          100 * (1 - std::pow(1 - level, static_cast<double>(quantities)))));
}

/// What pairing did for the mean load, over the pairs: the reduction of variance r counts as 1 / (1 - r) times as many
/// arrangements. With equal scatter in both cases r is their correlation, whose interval is Fisher's.
std::string pairing_text(const std::vector<PairRow>& rows) {
    constexpr int fewest = 4;
    std::vector<const PairRow*> known;
    for (const PairRow& row : rows)
        if (row.quantity.key == quantity("mean_load").key && std::isfinite(row.found.variance_saved) &&
            row.found.arrangements >= fewest)
            known.push_back(&row);
    if (known.empty()) return "";
    std::ranges::sort(known, {}, [](const PairRow* row) { return row->found.variance_saved; });
    const PairRow* middle = known[known.size() / 2];
    const double saved = middle->found.variance_saved;
    const double z = std::atanh(std::clamp(saved, -1 + 1e-12, 1 - 1e-12));
    const double half = 1.959963984540054 / std::sqrt(middle->found.arrangements - 3);
    const std::string interval =
        fmt::format("{} (95 %: {} to {}{})", percent(saved), percent(std::tanh(z - half)), percent(std::tanh(z + half)),
                    known.size() > 1 ? ", of the middle pair" : "");
    return saved > 0 ? fmt::format(
                           "Pairing took {} of the variance of differences of the mean load, as {:.2g} times as "
                           "many arrangements would have.\n",
                           interval, 1 / std::max(1e-3, 1 - saved))
                     : fmt::format("Pairing bought nothing for the mean load: reduction {}.\n", interval);
}

/// Differences that lie far from the others of their pair; the first few.
std::string apart_text(const Summary& summary, const std::vector<PairRow>& rows) {
    constexpr std::size_t most = 3;
    std::vector<std::string> lines;
    std::size_t all = 0;
    for (const PairRow& row : rows)
        if (!row.apart.empty() && ++all <= most)
            lines.push_back(fmt::format("{}, {} - {}: {} of {} (arrangement {})", row.quantity.label,
                                        summary.label_of(row.second), summary.label_of(row.first), row.apart.size(),
                                        row.found.arrangements, fmt::join(row.apart, ", ")));
    if (lines.empty()) return "";
    return fmt::format(
        "Differences far from the others: {}{}. Their intervals count such arrangements as a kind of their own, whose "
        "share is uncertain; p t does not.",
        fmt::join(lines, "; "), all > most ? fmt::format("; and {} more", all - most) : "");
}

std::string notes(const std::vector<PairRow>& rows, const PairOptions& options) {
    const std::size_t pairs = pairs_in(rows);
    return fmt::format(
        "\np: two-sided, paired t test and Wilcoxon signed-rank test, Holm-adjusted over the {} of a quantity.\n"
        "Reduction: share of the variance of the difference that pairing removes. n needed: arrangements needed to "
        "find a true difference as large as the observed one, or of {:g} % of the first case, with a probability of "
        "{:g} %.\n{}{}The other quantities of Table 3: --format csv --parts pairs.\n",
        pairs == 1 ? std::string{"one pair"} : fmt::format("{} pairs", pairs), options.resolve / unit::percent,
        options.power / unit::percent, chance_text(rows), pairing_text(rows));
}

std::vector<DataColumn<PairRow>> columns_of(const Summary& summary, const PairOptions& options) {
    using Row = const PairRow&;
    const auto needed = [](int count) { return count == 0 ? Datum(Undefined{}) : Datum(count); };
    return {
        {"quantity", [](Row row) { return row.quantity.name.view(); }},
        {"first", [&](Row row) { return summary.name_of(row.first); }},
        {"second", [&](Row row) { return summary.name_of(row.second); }},
        {"arrangements", [](Row row) { return row.found.arrangements; }},
        {Names{"", "first_mean"}, &PairRow::first_mean},
        {"difference", [](Row row) { return row.found.difference; }},
        {Names{"", "sd"}, [](Row row) { return row.found.sd; }},
        {Names{"low", "interval/low"}, [](Row row) { return row.found.interval.low; }},
        {Names{"high", "interval/high"}, [](Row row) { return row.found.interval.high; }},
        {Names{"", "t_interval/low"}, [](Row row) { return row.found.t_interval.low; }},
        {Names{"", "t_interval/high"}, [](Row row) { return row.found.t_interval.high; }},
        {Names{"", "apart"}, [](Row row) { return row.apart.size(); }},
        {Names{"bca_low", "bca/low"}, [](Row row) { return row.found.bca.low; }},
        {Names{"bca_high", "bca/high"}, [](Row row) { return row.found.bca.high; }},
        {Names{"sd", ""}, [](Row row) { return row.found.sd; }},
        {"t", [](Row row) { return row.found.t; }},
        {"t_p", [](Row row) { return row.found.t_p; }},
        {"t_p_holm", &PairRow::t_p_holm},
        {"rank_sum", [](Row row) { return row.found.rank_sum; }},
        {"wilcoxon_p", [](Row row) { return row.found.wilcoxon_p; }},
        {"wilcoxon_p_holm", &PairRow::wilcoxon_p_holm},
        {"wilcoxon_exact", [](Row row) { return row.found.wilcoxon_exact; }},
        {"variance_saved", [](Row row) { return row.found.variance_saved; }},
        {Names{"", "power"}, [&](Row) { return options.power; }},
        {Names{"", "arrangements_for_observed"}, [=](Row row) { return needed(row.to_resolve_observed); }},
        {Names{"", "resolve"}, [&](Row) { return options.resolve; }},
        {Names{"", "arrangements_for_resolve"}, [=](Row row) { return needed(row.to_resolve_wished); }},
        {Names{"to_resolve_observed", ""}, &PairRow::to_resolve_observed},
        {Names{"to_resolve_wished", ""}, &PairRow::to_resolve_wished},
    };
}

}  // namespace

std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    const std::size_t all = options.others ? all_pairs(summary) : summary.cases.size() - 1;
    const std::size_t left_out = all - pairs_in(rows);
    if (left_out == 0) return "";
    return fmt::format(
        "{} not compared: a pair needs two arrangements that are done in both cases and begin with the same floes, "
        "and {} fewer (campaign.common_arrangements = false, or different field geometries).",
        left_out == all ? (all == 1 ? "The pair is" : "Pairs are") : fmt::format("{} of {} pairs are", left_out, all),
        left_out == 1 ? "it has" : "they have");
}

std::string unasked_text(const Summary& summary) {
    return fmt::format(
        "The {} pairs of the design's {} points are compared where they are asked for: floes summarize --parts pairs.",
        all_pairs(summary), summary.cases.size());
}

Section pairs_section(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    Section section{.records = {make_rows<PairRow>("pairs", rows, columns_of(summary, options))}};
    const std::string left_out = left_out_text(summary, rows, options);
    if (rows.empty()) {
        section.before = summary.cases.size() < 2 ? "Pairs: there is only one case.\n" : left_out + "\n";
        return section;
    }
    section.title = "Pairs over the same arrangements";
    section.table = rows_of(summary, rows, true);
    section.table.insert(section.table.begin(),
                         {"pair", "n", "difference", "95 %", "of first", "p t", "p Wilcoxon", "reduction", "n needed",
                          fmt::format("n for {:g} %", options.resolve / unit::percent)});
    section.on_page = rows_of(summary, rows, false);
    section.after = notes(rows, options);
    if (!left_out.empty()) section.notes.push_back(left_out);
    if (std::string apart = apart_text(summary, rows); !apart.empty()) section.notes.push_back(std::move(apart));
    section.figures = {
        differences(summary, rows, quantity("mean_load"), "Mean load: differences within an arrangement."),
        differences(summary, rows, quantity("mean_maximum"), "Mean maximum load: differences within an arrangement.")};
    return section;
}

}  // namespace floes
