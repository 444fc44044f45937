#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "findings/conditions.hpp"
#include "findings/load_columns.hpp"
#include "findings/paper_table3.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// The first name at the top.
std::vector<std::string> names_from_the_bottom(const Summary& summary) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) names.push_back(summary.label_of(k));
    std::ranges::reverse(names);
    return names;
}

Limits mean_limits(const Estimate& found) {
    return {found.low, found.high};
}

Limits run_limits(const Estimate& found) {
    return {found.prediction_low, found.prediction_high};
}

/// Every arrangement as a dot, a strip for each case; below them the mean and its intervals.
Figure strips(const Evidence& evidence, const Quantity& quantity, std::string caption) {
    const double factor = quantity.factor();
    const auto& cases = evidence.summary.cases;
    const double count = static_cast<double>(cases.size());
    std::vector<double> values;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        for (const MemberRow* member : done_members(evidence.table, i)) values.push_back(factor * quantity.of(*member));
        const Estimate& found = cases[i].of(quantity);
        for (const Limits& limits : {mean_limits(found), run_limits(found)})
            if (says_something(quantity, found.estimate, limits, cases[i].done))
                values.insert(values.end(), {factor * limits.low, factor * limits.high});
    }
    Figure figure{.description = fmt::format("{} of every arrangement, with the mean of each case", quantity.label),
                  .x = axis_around(std::string(quantity.label.view()), values, true),
                  .y = {"", 0, count, false, names_from_the_bottom(evidence.summary)},
                  .size = {720, 70 + 34 * count},
                  .caption = std::move(caption)};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double middle = static_cast<double>(cases.size() - i) - 0.5;
        const double below = middle - 0.28;
        const Estimate& found = cases[i].of(quantity);
        for (const auto& [limits, style] : {std::pair{run_limits(found), "dashed"}, {mean_limits(found), "thick"}})
            if (says_something(quantity, found.estimate, limits, cases[i].done))
                figure.line({{factor * limits.low, below}, {factor * limits.high, below}}, style);
        figure.dot(factor * found.estimate, below, "ink", 4.5);
        int turn = 0;  // spreads dots over the strip's height, always in the same way
        for (const MemberRow* member : done_members(evidence.table, i))
            figure.dot(factor * quantity.of(*member), middle - 0.04 + 0.08 * (turn++ * 2 % 5), colour(i) + " faint");
    }
    return figure;
}

}  // namespace

Table averaged_table(const Summary& summary) {
    auto shown = std::views::filter(summary.quantities, [](const Quantity& one) {
        return one.averaging != 0 && one.averaged == quantity("mean_maximum").averaged;
    });
    double largest = 0;
    for (const CaseSummary& row : summary.cases)
        for (const Quantity& one : shown)
            if (const double found = row.of(one).estimate; found > largest) largest = found;
    const LoadUnit unit = load_unit(largest);
    const int decimals = std::max(1, few_decimals(unit.factor * largest));
    Table table{{"case", "over, s", fmt::format("SD, {}", unit.name), fmt::format("mean maximum, {}", unit.name),
                 "95 % interval", "one further run", fmt::format("SD maximum, {}", unit.name)}};
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        for (const Quantity& one : shown) {
            const Estimate& found = row.of(one);
            const auto estimate = [&](const Quantity& other) {
                return fixed(unit.factor * row.of(averaged_over(other, one.averaging)).estimate, decimals);
            };
            const auto range = [&](const Limits& limits) {
                return says_something(one, found.estimate, limits, row.done)
                           ? bracket(unit.factor * limits.low, unit.factor * limits.high, decimals)
                           : "–";
            };
            table.push_back({summary.label_of(k), fmt::format("{}", one.averaging), estimate(quantity("sd_load")),
                             fixed(unit.factor * found.estimate, decimals), range(mean_limits(found)),
                             range(run_limits(found)), estimate(quantity("sd_maximum"))});
        }
    }
    return table;
}

Section averaged_section(Evidence& evidence) {
    Section section{.table = averaged_table(evidence.summary)};
    if (section.table.size() == 1) return {};
    section.after = fmt::format(
        "Surge load averaged over the time given: mean over arrangements of the segment maxima, with its 95 % "
        "confidence and prediction intervals. The maxima below, without an averaging time, are of single steps{}.",
        has_rigid_contacts(evidence.summary)
            ? ": a rigid contact gives its impulse within one step, so they depend on the time step"
            : "");
    return section;
}

Section table3_section(Evidence& evidence) {
    const bool papers =
        std::ranges::any_of(evidence.campaign.cases, [](const Case& one) { return paper_row(one) != nullptr; });
    const bool each = in_detail(evidence.campaign);  // a design of many points has figures of its own
    return {.table = table3(evidence.campaign, evidence.summary),
            .after = fmt::format("Mean over arrangements with its 95 % confidence interval; below it the 95 % "
                                 "prediction interval of one further arrangement; –: one that would say nothing.{}",
                                 papers ? " The paper's figures are one run each, and the experiment's maximum is one "
                                          "value."
                                        : ""),
            .figures =
                !each
                    ? std::vector<Figure>{}
                    : std::vector<Figure>{
                          strips(evidence, quantity("mean_load"),
                                 "Each dot is one arrangement. Below the dots: mean, its 95 % confidence interval "
                                 "(thick), and the 95 % prediction interval of one further run (dashed)."),
                          strips(evidence, quantity("mean_maximum"), "The same for the mean of the segments' maxima."),
                          strips(evidence, quantity("failure_ratio"), "The same for the share of broken floes.")}};
}

}  // namespace floes
