#include "findings/model_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <set>

#include "core/wording.hpp"
#include "findings/members.hpp"
#include "inference/paired.hpp"
#include "scenario/keys.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// Values of done members by arrangement.
std::map<int, double> values_of(const CampaignTable& table, std::size_t of_case, const Quantity& quantity) {
    std::map<int, double> values;
    for (const MemberRow* member : done_members(table, of_case)) {
        const double value = member->value(quantity);
        if (std::isfinite(value)) values[member->arrangement] = value;
    }
    return values;
}

std::vector<double> plain(const std::map<int, double>& values) {
    std::vector<double> list;
    for (const auto& [arrangement, value] : values) list.push_back(value);
    return list;
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
        return {found.difference, found.interval, found.sd / std::sqrt(static_cast<double>(first.size())), true};
    }
    const MeanDifference found = difference_of_means(plain(base), plain(other));
    return {found.difference, found.interval, found.standard_error, false};
}

/// Of one load column: down (sign -1) or up (sign 1).
double together(const std::vector<VariationRow>& rows, std::size_t column, double sign) {
    std::map<std::string, const LoadChange*> largest;
    for (const VariationRow& row : rows) {
        const LoadChange& change = row.changes[column];
        const LoadChange*& known = largest[row.input];
        if (sign * change.estimate > 0 && (known == nullptr || sign * change.estimate > sign * known->estimate))
            known = &change;
    }
    double squares = 0;
    for (const auto& [input, change] : largest)
        if (change != nullptr)
            squares += std::pow(change->estimate, 2) -
                       (std::isfinite(change->standard_error) ? std::pow(change->standard_error, 2) : 0.0);
    return sign * std::sqrt(std::max(squares, 0.0));
}

std::string change_cell(const LoadColumn& load, const LoadChange& change) {
    if (!std::isfinite(change.estimate)) return "–";
    const std::string value = fmt::format("{:+.{}f}", load.factor * change.estimate, load.decimals);
    const double half = 0.5 * (change.interval.high - change.interval.low);
    return fmt::format("{} ± {}", value, std::isfinite(half) ? fixed(load.factor * half, load.decimals) : "–");
}

std::string width_text(const LoadColumn& load, const WidthRow& row) {
    return fmt::format("{:+.{}f} to {:+.{}f}", load.factor * row.down, load.decimals, load.factor * row.up,
                       load.decimals);
}

Figure figure_of(const Evidence& evidence, const ModelWidth& width) {
    const LoadColumn& load = width.loads.front();
    std::vector<std::string> labels;  // from the bottom
    std::vector<double> values{0};
    Figure figure{.description = "Change of the mean load by each variation",
                  .caption = "Mean load: what each variation changes, with 95 % intervals."};
    for (auto row = width.variations.rbegin(); row != width.variations.rend(); ++row) {
        const LoadChange& change = row->changes.front();
        if (!std::isfinite(change.estimate)) continue;
        const double at = static_cast<double>(labels.size()) + 0.5;
        figure.dot(load.factor * change.estimate, at, "ink", 4.5);
        values.push_back(load.factor * change.estimate);
        const auto& [low, high] = change.interval;
        if (std::isfinite(high)) {
            figure.line({{load.factor * low, at}, {load.factor * high, at}}, "thick");
            values.insert(values.end(), {load.factor * low, load.factor * high});
        }
        labels.push_back(evidence.summary.label_of(row->of_case));
    }
    const double count = static_cast<double>(labels.size());
    figure.size = {720, 70 + 26 * count};
    figure.x = axis_around(fmt::format("change of the mean load, {}", load.unit), values, false);
    figure.y = {"", 0, count, false, std::move(labels)};
    figure.upright(0, "dashed");
    return figure;
}

DataRows records_of(const Evidence& evidence, const ModelWidth& width) {
    struct Line {
        const VariationRow* row;
        std::size_t column;
    };
    std::vector<Line> lines;
    for (const VariationRow& row : width.variations)
        for (std::size_t column = 0; column < width.loads.size(); ++column) lines.push_back({&row, column});
    const auto number = [](double value) { return std::isfinite(value) ? Datum(value) : Datum(Undefined{}); };
    const auto change = [](const Line& line) -> const LoadChange& { return line.row->changes[line.column]; };
    return make_rows<Line>(
        "model", lines,
        {{"case", [&](const Line& line) { return Datum(evidence.summary.name_of(line.row->of_case)); }},
         {"input", [](const Line& line) { return Datum(line.row->input); }},
         {"quantity",
          [&](const Line& line) { return Datum(std::string{width.loads[line.column].quantity.name.view()}); }},
         {"base", [&](const Line& line) { return number(width.widths[line.column].base); }},
         {"change", [=](const Line& line) { return number(change(line).estimate); }},
         {"low", [=](const Line& line) { return number(change(line).interval.low); }},
         {"high", [=](const Line& line) { return number(change(line).interval.high); }},
         {"paired", [=](const Line& line) { return Datum(change(line).paired ? 1 : 0); }},
         {"all_down", [&](const Line& line) { return number(width.widths[line.column].down); }},
         {"all_up", [&](const Line& line) { return number(width.widths[line.column].up); }},
         {"sampling", [&](const Line& line) { return number(width.widths[line.column].sampling); }}});
}

}  // namespace

std::optional<ModelWidth> find_model_width(const Evidence& evidence) {
    const std::optional<std::size_t> base = base_case(evidence.campaign);
    if (!base) return {};
    ModelWidth width;
    width.base = *base;
    width.loads = load_columns(evidence.summary);
    std::vector<std::map<int, double>> of_base;
    for (const LoadColumn& load : width.loads) {
        of_base.push_back(values_of(evidence.table, *base, load.quantity));
        const Interval mean = mean_interval(plain(of_base.back()));
        width.widths.push_back({mean.estimate, mean.high - mean.estimate, 0, 0});
    }
    if (of_base.front().size() < 2) return {};
    std::set<std::string> inputs;
    for (std::size_t k = 0; k < evidence.campaign.cases.size(); ++k) {
        if (k == *base || done_members(evidence.table, k).size() < 2) continue;
        VariationRow row{k,
                         fmt::format("{}", fmt::join(differing_keys(evidence.campaign.cases[*base].scenario,
                                                                    evidence.campaign.cases[k].scenario),
                                                     ", ")),
                         {}};
        for (std::size_t column = 0; column < width.loads.size(); ++column)
            row.changes.push_back(
                change_between(of_base[column], values_of(evidence.table, k, width.loads[column].quantity)));
        inputs.insert(row.input);
        width.variations.push_back(std::move(row));
    }
    if (width.variations.empty()) return {};
    std::ranges::stable_sort(width.variations, std::ranges::greater{},
                             [](const VariationRow& row) { return std::abs(row.changes.front().estimate); });
    for (std::size_t column = 0; column < width.loads.size(); ++column) {
        width.widths[column].down = together(width.variations, column, -1);
        width.widths[column].up = together(width.variations, column, 1);
    }
    width.inputs = inputs.size();
    return width;
}

Table variations_table(const Summary& summary, const ModelWidth& width, std::size_t most) {
    Table table{{"case, then changes from it"}};
    for (const LoadColumn& load : width.loads) table.front().emplace_back(load.heading());
    const auto add = [&](std::string words, auto&& cell_of) {
        std::vector<Cell>& line = table.emplace_back(std::vector<Cell>{std::move(words)});
        for (std::size_t column = 0; column < width.loads.size(); ++column) line.emplace_back(cell_of(column));
    };
    const CaseSummary& base = summary.cases[width.base];
    add(fmt::format("{}, n = {}", summary.label_of(width.base), base.done),
        [&](std::size_t column) { return width.loads[column].cell(base); });
    for (const VariationRow& row : width.variations | std::views::take(most)) {
        const bool paired = row.changes.front().paired;
        add(summary.label_of(row.of_case) + (paired ? "" : " *"),
            [&](std::size_t column) { return change_cell(width.loads[column], row.changes[column]); });
    }
    add("all inputs together",
        [&](std::size_t column) { return width_text(width.loads[column], width.widths[column]); });
    return table;
}

std::string width_sentence(const std::optional<ModelWidth>& width) {
    if (!width) return "";
    const LoadColumn& load = width->loads.front();
    const WidthRow& row = width->widths.front();
    const double model = std::max(-row.down, row.up);
    return fmt::format(
        "Sampling leaves the mean load open by ± {} {}, the {} varied here by {} {} together: {}.",
        fixed(load.factor * row.sampling, load.decimals), load.unit,
        counted(static_cast<std::int64_t>(width->inputs), "input"), width_text(load, row), load.unit,
        model > row.sampling ? "more arrangements do not narrow that" : "more arrangements would narrow the result");
}

Section model_section(Evidence& evidence) {
    const std::optional<ModelWidth> width = find_model_width(evidence);
    if (!width)
        return {.missing =
                    "What the model leaves open: unknown, because no case is named as the base of the others "
                    "(run.base_case). floes vary CONFIG.toml writes such a study.\n"};
    Section section{.title = fmt::format("What the model leaves open: {} of {}, one at a time",
                                         counted(std::ssize(width->variations), "variation"),
                                         counted(static_cast<std::int64_t>(width->inputs), "input"))};
    section.table = variations_table(evidence.summary, *width, width->variations.size());
    section.after =
        "\n±: 95 % interval over arrangements. All inputs together: root of the sum of the squared largest change of "
        "each input that way, less what sampling adds to it, as if inputs were independent.\n";
    if (std::ranges::any_of(width->variations, [](const VariationRow& row) { return !row.changes.front().paired; }))
        section.notes.push_back("* other floes, because the field is another: not in pairs.");
    section.notes.push_back(width_sentence(width));
    section.records = {records_of(evidence, *width)};
    section.figures = {figure_of(evidence, *width)};
    return section;
}

}  // namespace floes
