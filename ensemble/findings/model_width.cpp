#include "findings/model_width.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <set>

#include "core/text.hpp"
#include "findings/cases.hpp"
#include "findings/estimates.hpp"
#include "findings/pairs.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

/// Finite values of done members by arrangement.
std::map<int, double> values_of(const Sample& sample, std::size_t of_case, const Quantity& quantity) {
    std::map<int, double> values;
    for (const std::size_t member : sample.done(of_case))
        if (const double value = sample.value(member, quantity); std::isfinite(value))
            values[sample.arrangement_of(member)] = value;
    return values;
}

std::vector<double> plain(const std::map<int, double>& values) {
    const auto all = std::views::values(values);
    return {all.begin(), all.end()};
}

LoadChange change_between(const std::map<int, double>& base, const std::map<int, double>& other) {
    std::vector<double> first;
    std::vector<double> second;
    for (const auto& [arrangement, value] : other) {
        const auto partner = base.find(arrangement);
        if (partner == base.end()) continue;
        first.push_back(partner->second);
        second.push_back(value);
    }
    if (first.size() > 1) {
        const PairedComparison found = compare_paired(first, second);
        return {{found.difference, found.interval.low, found.interval.high},
                found.sd / std::sqrt(static_cast<double>(first.size())),
                true};
    }
    const MeanDifference found = difference_of_means(plain(base), plain(other));
    return {{found.difference, found.interval.low, found.interval.high}, found.standard_error, false};
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
    std::vector<std::map<int, double>> of_base;
    for (const LoadColumn& load : load_columns(evidence.summary)) {
        of_base.push_back(values_of(evidence.sample, *base, load.quantity));
        const Interval mean = mean_interval(plain(of_base.back()));
        width.widths.push_back({load.quantity, load.words, mean.estimate, mean.high - mean.estimate, 0, 0});
    }
    if (of_base.front().size() < 2) return {};
    const std::vector<Case>& cases = evidence.campaign.cases;
    std::set<std::string> inputs;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        if (k == *base || evidence.sample.done(k).size() < 2) continue;
        VariationRow& row =
            width.variations.emplace_back(VariationRow{k, input_of(cases[*base].scenario, cases[k].scenario), {}});
        for (std::size_t load = 0; load < of_base.size(); ++load)
            row.changes.push_back(
                change_between(of_base[load], values_of(evidence.sample, k, width.widths[load].quantity)));
        inputs.insert(row.input);
    }
    if (width.variations.empty()) return {};
    std::ranges::stable_sort(width.variations, std::ranges::greater{},
                             [](const VariationRow& row) { return std::abs(row.changes.front().change.value); });
    for (std::size_t load = 0; load < of_base.size(); ++load) {
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
    add(fmt::format("{}, n = {}", summary.label_of(width.base), base.done), [&](std::size_t load) {
        const Quantity& quantity = width.widths[load].quantity;
        return estimate(base.of(quantity), base.done, kind_of(quantity));
    });
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
    Section section{.title = fmt::format("What the model leaves open: {} of {}, one at a time",
                                         counted(std::ssize(width->variations), "variation"),
                                         counted(static_cast<std::int64_t>(width->inputs), "input")),
                    .results = {variations_table(evidence.summary, *width, width->variations.size()),
                                model_results(evidence.summary, *width)},
                    .after =
                        "\nBrackets: 95 % interval over arrangements. All inputs together: root of the sum of the "
                        "squared largest change of each input that way, less what sampling adds to it, as if inputs "
                        "were independent.\n",
                    .figures = {figure_of(evidence.summary, *width)}};
    if (std::ranges::any_of(width->variations, [](const VariationRow& row) { return !row.changes.front().paired; }))
        section.notes.push_back("* other floes, because the field is another: not in pairs.");
    section.notes.push_back(width_sentence(width, evidence.units));
    return section;
}

}  // namespace floes
