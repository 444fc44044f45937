#include "findings/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <ranges>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/cases.hpp"
#include "findings/summary.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr std::size_t fewest_shared = 2;
constexpr double power = 0.8;  // probability of finding a difference at the 5 % level

/// Done members of two cases that began from the same floes, beside each other.
struct SharedMembers {
    std::size_t first;
    std::size_t second;
    std::vector<std::pair<std::size_t, std::size_t>> members = {};
};

SharedMembers shared(const Sample& sample, std::size_t first, std::size_t second) {
    SharedMembers pair{first, second};
    const auto arrangement = [&](std::size_t member) { return sample.arrangement_of(member); };
    const Members& others = sample.done(second);
    for (const std::size_t member : sample.done(first)) {
        const auto partner = std::ranges::lower_bound(others, arrangement(member), {}, arrangement);
        if (partner != others.end() && arrangement(*partner) == arrangement(member))
            pair.members.emplace_back(member, *partner);
    }
    return pair;
}

std::vector<SharedMembers> find_pairs(const Sample& sample, const PairOptions& options) {
    const std::optional<std::size_t> reference = options.reference;
    std::vector<SharedMembers> pairs;
    for (std::size_t a = 0; a < sample.cases.size(); ++a) {
        for (std::size_t b = a + 1; b < sample.cases.size(); ++b) {
            if (!options.others && reference != a && reference != b) continue;
            SharedMembers pair = reference == b ? shared(sample, b, a) : shared(sample, a, b);
            if (pair.members.size() >= fewest_shared) pairs.push_back(std::move(pair));
        }
    }
    return pairs;
}

std::vector<double> values_of(const Sample& sample, std::size_t of_case, const Quantity& quantity) {
    return measured(sample.values(sample.done(of_case), quantity));
}

/// The finite values of both cases, beside each other.
struct Beside {
    std::vector<double> first = {};
    std::vector<double> second = {};
    std::vector<int> arrangements = {};
};

Beside beside(const Sample& sample, const SharedMembers& pair, const Quantity& quantity) {
    Beside found;
    for (const auto& [member, partner] : pair.members) {
        const double before = sample.value(member, quantity);
        const double after = sample.value(partner, quantity);
        if (!std::isfinite(before) || !std::isfinite(after)) continue;  // an older version did not measure it
        found.first.push_back(before);
        found.second.push_back(after);
        found.arrangements.push_back(sample.number_of(member));
    }
    return found;
}

PairRow compare(const Sample& sample, const SharedMembers& pair, const Quantity& quantity, const PairOptions& options) {
    const auto [first, second, arrangements] = beside(sample, pair, quantity);
    PairRow row{.quantity = quantity, .first = pair.first, .second = pair.second};
    row.found = compare_paired(first, second);
    for (const std::vector<std::size_t>* side : {&row.found.apart.above, &row.found.apart.below})
        for (const std::size_t k : *side) row.apart.push_back(arrangements[k]);
    std::ranges::sort(row.apart);
    row.first_mean = std::accumulate(first.begin(), first.end(), 0.0) / static_cast<double>(first.size());
    const auto needed = [&](double difference) { return arrangements_to_resolve(difference, row.found.sd, power); };
    row.to_resolve_observed = needed(row.found.difference);
    row.to_resolve_wished = needed(options.resolve * row.first_mean);
    return row;
}

std::size_t all_pairs(const Summary& summary) {
    return summary.cases.size() * (summary.cases.size() - 1) / 2;
}

/// Each pair has a row for each quantity.
std::size_t pairs_in(const std::vector<PairRow>& rows) {
    return static_cast<std::size_t>(
        std::ranges::count_if(rows, [&](const PairRow& row) { return row.quantity.key == rows.front().quantity.key; }));
}

std::string pair_label(const Summary& summary, const PairRow& row) {
    return fmt::format("{} - {}", summary.label_of(row.second), summary.label_of(row.first));
}

std::vector<ResultColumn> pair_columns(const PairOptions& options) {
    using Holds = ResultColumn::Holds;
    return program_columns("quantity first second") +
           std::vector<ResultColumn>{{.words = "pair"},
                                     {"arrangements", "n"},
                                     estimates("difference", "difference", ""),
                                     {.words = "of first", .unit = "share", .decimals = 0},
                                     {.key = "t_p_holm", .words = "p t", .p = true},
                                     {.key = "wilcoxon_p_holm", .words = "p Wilcoxon", .p = true},
                                     {.key = "variance_saved", .words = "reduction", .unit = "share", .decimals = 0},
                                     {.words = "n needed"},
                                     {.words = fmt::format("n for {:g} %", options.resolve / unit::percent)},
                                     {.key = "t_interval", .holds = Holds::brackets}} +
           program_columns(
               "first_mean apart sd t t_p rank_sum wilcoxon_p wilcoxon_exact power arrangements_for_observed resolve "
               "arrangements_for_resolve");
}

Results pair_results(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    Results results{.place = "pairs", .columns = pair_columns(options)};
    const auto needed = [](int count) { return count == 0 ? Datum(Undefined{}) : Datum(count); };
    const auto shown = [&](int count) { return count < 1'000'000 ? needed(count) : Datum(">10⁶"); };
    ShortText last;
    for (const PairRow& row : rows) {
        const PairedComparison& found = row.found;
        const auto whom = row.quantity.for_programs                   ? Results::For::programs
                          : row.quantity.shown >= Shown::in_headlines ? Results::For::everybody
                                                                      : Results::For::on_page;
        if (!(row.quantity.key == last))
            results.add_heading(std::string{row.quantity.label.view()}, whom, unit_of(row.quantity));
        last = row.quantity.key;
        results.add(row_of(row.quantity.key.view(), summary.name_of(row.first), summary.name_of(row.second),
                           "  " + pair_label(summary, row), found.arrangements, row.difference(),
                           found.difference / row.first_mean, row.t_p_holm, row.wilcoxon_p_holm, found.variance_saved,
                           shown(row.to_resolve_observed), shown(row.to_resolve_wished), Bracket{found.t_interval},
                           row.first_mean, row.apart.size(), found.sd, found.t, found.t_p, found.rank_sum,
                           found.wilcoxon_p, found.wilcoxon_exact, power, needed(row.to_resolve_observed),
                           options.resolve, needed(row.to_resolve_wished)),
                    whom);
    }
    return results;
}

/// A value with its interval on a line of its own.
struct Strip {
    std::string label;
    Estimate value;
};

/// Strips below each other, the first at the top, with a line at 0. `words` and `unit`: of the axis.
Figure strips_figure(const std::vector<Strip>& strips, const std::string& words, const std::string& unit) {
    Figure figure;
    std::vector<std::string> labels;  // from the bottom
    std::vector<double> values{0};
    for (const auto& [label, value] : strips | std::views::reverse) {
        const double at = static_cast<double>(labels.size()) + 0.5;
        figure.dot(value.value, at, "ink", 4.5);
        values.push_back(value.value);
        if (value.said && std::isfinite(value.high)) {
            figure.line({{value.low, at}, {value.high, at}}, "thick");
            values.insert(values.end(), {value.low, value.high});
        }
        labels.push_back(label);
    }
    const double count = static_cast<double>(labels.size());
    figure.size = {720, 70 + 34 * count};
    figure.x = axis_around(words, values, false, unit);
    figure.y = {"", 0, count, false, std::move(labels)};
    figure.upright(0, "dashed");
    return figure;
}

Figure differences(const Summary& summary, const std::vector<PairRow>& rows, const Quantity& quantity,
                   std::string caption) {
    std::vector<Strip> strips;
    for (const PairRow& row : rows)
        if (row.quantity.key == quantity.key) strips.push_back({pair_label(summary, row), row.difference()});
    Figure figure =
        strips_figure(strips, fmt::format("difference of {} within an arrangement, 95 % interval", quantity.label),
                      unit_of(quantity));
    figure.description = fmt::format("Paired differences of {}", quantity.label);
    figure.caption = std::move(caption);
    return figure;
}

/// How many p values there are, and what that does to chance.
std::string chance_text(const std::vector<PairRow>& rows) {
    constexpr double level = 0.05;
    const std::size_t pairs = pairs_in(rows);
    const std::size_t quantities = rows.size() / pairs;
    if (rows.size() < 2) return "";
    return fmt::format(
        "Looked at: {} in {}, with two tests each. Where nothing differs, an adjusted p of a quantity is below {:g} in "
        "5 of 100 campaigns by chance{}.\n",
        quantities == 1 ? std::string{"one quantity"} : fmt::format("{} quantities", quantities),
        counted(static_cast<int>(pairs), "pair"), level,
        quantities == 1 ? std::string{}
                        : fmt::format(", one of any quantity in up to {:.0f} (fewer, the more they go together): name "
                                      "the quantity before you look",
                                      100 * (1 - std::pow(1 - level, static_cast<double>(quantities)))));
}

/// What pairing did for the mean load, over the pairs: the reduction of variance r counts as 1 / (1 - r) times as many
/// arrangements. With equal scatter in both cases r is their correlation, whose interval is Fisher's.
std::string pairing_text(const std::vector<PairRow>& rows) {
    constexpr int fewest = 4;
    std::vector<const PairedComparison*> known;
    for (const PairRow& row : rows)
        if (row.quantity.key == quantity("mean_load").key && std::isfinite(row.found.variance_saved) &&
            row.found.arrangements >= fewest)
            known.push_back(&row.found);
    if (known.empty()) return "";
    std::ranges::sort(known, {}, [](const PairedComparison* pair) { return pair->variance_saved; });
    const PairedComparison& middle = *known[known.size() / 2];
    const double z = std::atanh(std::clamp(middle.variance_saved, -1 + 1e-12, 1 - 1e-12));
    const double half = 1.959963984540054 / std::sqrt(middle.arrangements - 3);
    const auto percent = [](double share) { return std::round(share / unit::percent) + 0.0; };  // no "-0"
    const std::string interval = fmt::format("{:.0f} % (95 %: {:.0f} % to {:.0f} %{})", percent(middle.variance_saved),
                                             percent(std::tanh(z - half)), percent(std::tanh(z + half)),
                                             known.size() > 1 ? ", of the middle pair" : "");
    return middle.variance_saved > 0
               ? fmt::format(
                     "Pairing took {} of the variance of differences of the mean load, as {:.2g} times as many "
                     "arrangements would have.\n",
                     interval, 1 / std::max(1e-3, 1 - middle.variance_saved))
               : fmt::format("Pairing bought nothing for the mean load: reduction {}.\n", interval);
}

/// Differences that lie far from the others of their pair; the first few.
std::string apart_text(const Summary& summary, const std::vector<PairRow>& rows) {
    constexpr std::size_t most = 3;
    std::vector<std::string> lines;
    std::size_t all = 0;
    for (const PairRow& row : rows)
        if (!row.apart.empty() && !row.quantity.for_programs && ++all <= most)
            lines.push_back(fmt::format("{}, {}: {} of {} (arrangement {})", row.quantity.label,
                                        pair_label(summary, row), row.apart.size(), row.found.arrangements,
                                        fmt::join(row.apart, ", ")));
    if (lines.empty()) return "";
    return fmt::format(
        "Differences far from the others: {}{}. Their intervals count such arrangements as a kind of their own, whose "
        "share is uncertain; p t does not.",
        fmt::join(lines, "; "), all > most ? fmt::format("; and {} more", all - most) : "");
}

std::string notes(const std::vector<PairRow>& rows, const PairOptions& options) {
    const std::size_t pairs = pairs_in(rows);
    return fmt::format(
        "\nBrackets: 95 % interval. p: two-sided, paired t test and Wilcoxon signed-rank test, Holm-adjusted over the "
        "{} of a quantity.\nReduction: share of the variance of the difference that pairing removes. n needed: "
        "arrangements needed to find a true difference as large as the observed one, or of {:g} % of the first case, "
        "with a probability of {:g} %.\n{}{}The other quantities of Table 3: --format csv --parts pairs.\n",
        pairs == 1 ? std::string{"one pair"} : fmt::format("{} pairs", pairs), options.resolve / unit::percent,
        power / unit::percent, chance_text(rows), pairing_text(rows));
}

}  // namespace

Estimate PairRow::difference() const {
    return within(found.difference, found.interval, found.arrangements >= fewest_for_interval);
}

Estimate ApartRow::difference() const {
    return within(found.difference, found.interval, fewest >= fewest_for_interval);
}

std::vector<PairRow> compare_pairs(const Evidence& evidence, const PairOptions& options) {
    const std::vector<SharedMembers> pairs = find_pairs(evidence.sample, options);
    std::vector<PairRow> all;
    for (const Quantity& quantity : shown_in(evidence.summary.quantities, Shown::in_pairs)) {
        const std::size_t first = all.size();
        std::vector<double> t_p;
        std::vector<double> wilcoxon_p;
        for (const SharedMembers& pair : pairs) {
            const PairRow& row = all.emplace_back(compare(evidence.sample, pair, quantity, options));
            t_p.push_back(row.found.t_p);
            wilcoxon_p.push_back(row.found.wilcoxon_p);
        }
        t_p = holm(t_p);
        wilcoxon_p = holm(wilcoxon_p);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            all[first + k].t_p_holm = t_p[k];
            all[first + k].wilcoxon_p_holm = wilcoxon_p[k];
        }
    }
    return all;
}

std::vector<PairRow> compare_with(const Evidence& evidence, std::size_t reference, const Quantity& quantity,
                                  std::size_t most) {
    std::vector<PairRow> all;
    for (const SharedMembers& pair : find_pairs(evidence.sample, {.reference = reference, .others = false})) {
        if (pair.second >= most) continue;
        PairRow& row = all.emplace_back(compare(evidence.sample, pair, quantity, {}));
        row.t_p_holm = row.found.t_p;
        row.wilcoxon_p_holm = row.found.wilcoxon_p;
    }
    return all;
}

std::vector<ApartRow> compare_apart(const Evidence& evidence, std::size_t reference, const Quantity& quantity,
                                    std::size_t most) {
    std::vector<ApartRow> all;
    if (reference >= evidence.sample.cases.size()) return all;
    const std::vector<double> first = values_of(evidence.sample, reference, quantity);
    for (std::size_t k = 0; k < std::min(most, evidence.sample.cases.size()); ++k) {
        if (k == reference || !shared(evidence.sample, reference, k).members.empty()) continue;
        const std::vector<double> second = values_of(evidence.sample, k, quantity);
        if (first.empty() || second.empty()) continue;
        all.push_back({k, difference_of_means(first, second), static_cast<int>(std::min(first.size(), second.size()))});
    }
    return all;
}

std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    const std::size_t all = options.others ? all_pairs(summary) : summary.cases.size() - 1;
    const std::size_t left_out = all - pairs_in(rows);
    if (left_out == 0) return "";
    return fmt::format(
        "{} not compared: a pair needs two arrangements that are done in both cases and begin with the same floes, and "
        "{} fewer: members are missing or set aside, or the floes differ (campaign.common_arrangements = false, or "
        "other fields).",
        left_out == all ? (all == 1 ? "The pair is" : "Pairs are") : fmt::format("{} of {} pairs are", left_out, all),
        left_out == 1 ? "it has" : "they have");
}

std::string unasked_text(const Summary& summary) {
    return fmt::format(
        "The {} pairs of the design's {} points are compared where they are asked for: floes summarize --parts pairs.",
        all_pairs(summary), summary.cases.size());
}

Section pairs_section(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    Section section{.results = {pair_results(summary, rows, options)}};
    const std::string left_out = left_out_text(summary, rows, options);
    if (rows.empty()) {
        section.before = summary.cases.size() < 2 ? "Pairs: there is only one case.\n" : left_out + "\n";
        return section;
    }
    section.title = "Pairs over the same arrangements";
    section.after = notes(rows, options);
    if (!left_out.empty()) section.notes.push_back(left_out);
    if (std::string apart = apart_text(summary, rows); !apart.empty()) section.notes.push_back(std::move(apart));
    section.figures = {
        differences(summary, rows, quantity("mean_load"), "Mean load: differences within an arrangement."),
        differences(summary, rows, headline_maximum(summary.quantities),
                    "Mean maximum load: differences within an arrangement.")};
    return section;
}

namespace {

LoadChange change_between(const Sample& sample, std::size_t base, std::size_t other, const Quantity& quantity) {
    const Beside pairs = beside(sample, shared(sample, base, other), quantity);
    if (pairs.first.size() > 1) {
        const PairedComparison found = compare_paired(pairs.first, pairs.second);
        return {within(found.difference, found.interval), found.sd / std::sqrt(static_cast<double>(pairs.first.size())),
                true};
    }
    const MeanDifference found =
        difference_of_means(values_of(sample, base, quantity), values_of(sample, other, quantity));
    return {within(found.difference, found.interval), found.standard_error, false};
}

/// Paths of the keys that differ, without a time step that follows another key: of a faster tow.
std::string input_of(const Scenario& base, const Scenario& other) {
    std::vector<std::string> keys = differing_keys(base, other);
    if (keys.size() > 1) std::erase(keys, "general.time_step_s");
    return fmt::format("{}", fmt::join(keys, ", "));
}

/// One load over all inputs: down (sign -1) or up (sign 1).
double together(const std::vector<VariationRow>& rows, std::size_t load, double sign) {
    std::map<std::string, const LoadChange*> largest;
    for (const VariationRow& row : rows) {
        const LoadChange& change = row.changes[load];
        const LoadChange*& known = largest[row.input];
        const double size = sign * change.change.value;
        if (size > 0 && (known == nullptr || size > sign * known->change.value)) known = &change;
    }
    double squares = 0;
    for (const auto& [input, change] : largest)
        if (change != nullptr)
            squares += std::pow(change->change.value, 2) -
                       (std::isfinite(change->standard_error) ? std::pow(change->standard_error, 2) : 0.0);
    return sign * std::sqrt(std::max(squares, 0.0));
}

Figure figure_of(const Summary& summary, const ModelWidth& width) {
    std::vector<Strip> strips;
    for (const VariationRow& row : width.variations)
        if (const Estimate& change = row.changes.front().change; std::isfinite(change.value))
            strips.push_back({summary.label_of(row.of_case), change});
    Figure figure = strips_figure(strips, "change of the mean load", "N");
    figure.description = "Change of the mean load by each variation";
    figure.caption = "Mean load: what each variation changes, with 95 % intervals.";
    return figure;
}

/// For programs.
Results model_results(const Summary& summary, const ModelWidth& width) {
    Results results{.place = "model",
                    .columns = program_columns("case input quantity base") + std::vector{estimates("change", "")} +
                               program_columns("paired all_down all_up sampling")};
    for (const VariationRow& row : width.variations)
        for (std::size_t k = 0; k < width.widths.size(); ++k) {
            const WidthRow& load = width.widths[k];
            results.add({summary.name_of(row.of_case), row.input, load.quantity.key.view(), load.base,
                         row.changes[k].change, row.changes[k].paired ? 1 : 0, load.down, load.up, load.sampling});
        }
    return results;
}

}  // namespace

std::optional<ModelWidth> find_model_width(const Evidence& evidence) {
    const std::optional<std::size_t> base = base_case(evidence.campaign);
    if (!base) return {};
    ModelWidth width;
    width.base = *base;
    const Sample& sample = evidence.sample;
    for (const LoadColumn& load : load_columns(evidence.summary)) {
        const std::vector<double> values = values_of(sample, *base, load.quantity);
        if (width.widths.empty() && values.size() < 2) return {};
        const Estimate mean = over(values, kind_of(load.quantity));
        width.widths.push_back({load.quantity, load.words, mean.value, mean.longer_side(), 0, 0});
    }
    const std::vector<Case>& cases = evidence.campaign.cases;
    std::set<std::string> inputs;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        if (k == *base || sample.done(k).size() < 2) continue;
        VariationRow& row =
            width.variations.emplace_back(VariationRow{k, input_of(cases[*base].scenario, cases[k].scenario), {}});
        for (const WidthRow& load : width.widths)
            row.changes.push_back(change_between(sample, *base, k, load.quantity));
        inputs.insert(row.input);
    }
    if (width.variations.empty()) return {};
    std::ranges::stable_sort(width.variations, std::ranges::greater{},
                             [](const VariationRow& row) { return std::abs(row.changes.front().change.value); });
    for (std::size_t load = 0; load < width.widths.size(); ++load) {
        width.widths[load].down = together(width.variations, load, -1);
        width.widths[load].up = together(width.variations, load, 1);
    }
    width.inputs = inputs.size();
    return width;
}

Results variations_table(const Summary& summary, const ModelWidth& width, std::size_t most) {
    Results table{.columns = {{.words = "case, then changes from it"}}};
    for (const WidthRow& load : width.widths)
        table.columns.push_back(estimates("", load.words, unit_of(load.quantity)));
    const auto add = [&](std::string words, auto&& cell_of) {
        std::vector<Datum> row{std::move(words)};
        for (std::size_t load = 0; load < width.widths.size(); ++load) row.emplace_back(cell_of(load));
        table.add(std::move(row));
    };
    const CaseSummary& base = summary.cases[width.base];
    add(fmt::format("{}, n = {}", summary.label_of(width.base), base.done),
        [&](std::size_t load) { return estimate_of(base, width.widths[load].quantity); });
    for (const VariationRow& row : width.variations | std::views::take(most))
        add(summary.label_of(row.of_case) + (row.changes.front().paired ? "" : " *"),
            [&](std::size_t load) { return row.changes[load].change; });
    add("all inputs together", [&](std::size_t load) {
        return Bracket{{width.widths[load].down, width.widths[load].up}};
    });
    return table;
}

std::string width_sentence(const std::optional<ModelWidth>& width, const Units& units) {
    if (!width) return "";
    const WidthRow& load = width->widths.front();
    const double model = std::max(-load.down, load.up);
    return fmt::format(
        "Sampling leaves the mean load open by ± {}, the {} varied here by {} to {} together: {}.",
        units.text(load.sampling, "N", 2), counted(static_cast<std::int64_t>(width->inputs), "input"),
        units.number(load.down + 0.0, "N", 2), (load.up > 0 ? "+" : "") + units.text(load.up, "N", 2),
        model > load.sampling ? "more arrangements do not narrow that" : "more arrangements would narrow the result");
}

Section model_section(Evidence& evidence) {
    const std::optional<ModelWidth> width = find_model_width(evidence);
    if (!width)
        return {.missing =
                    "What the model leaves open: unknown, because no case is named as the base of the others "
                    "(run.base_case). floes vary CONFIG.toml writes such a study.\n"};
    Section section{
        .title = fmt::format("What the model leaves open: {} of {}, one at a time",
                             counted(std::ssize(width->variations), "variation"),
                             counted(static_cast<std::int64_t>(width->inputs), "input")),
        .results = {variations_table(evidence.summary, *width, width->variations.size()),
                    model_results(evidence.summary, *width)},
        .after =
            "\nBrackets: 95 % interval over arrangements. All inputs together: root of the sum of the squared largest "
            "change of each input that way, less what sampling adds to it, as if inputs were independent.\n",
        .figures = {figure_of(evidence.summary, *width)}};
    if (std::ranges::any_of(width->variations, [](const VariationRow& row) { return !row.changes.front().paired; }))
        section.notes.push_back("* other floes, because the field is another: not in pairs.");
    section.notes.push_back(width_sentence(width, evidence.units));
    return section;
}

}  // namespace floes
