#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "findings/conditions.hpp"
#include "findings/paper_table3.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// The first name at the top.
std::vector<std::string> names_from_the_bottom(const Summary& summary) {
    std::vector<std::string> names;
    for (const CaseSummary& row : summary.cases) names.push_back(row.about.name);
    std::ranges::reverse(names);
    return names;
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
        values.insert(values.end(), {factor * found.prediction_low, factor * found.prediction_high});
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
        figure.line({{factor * found.prediction_low, below}, {factor * found.prediction_high, below}}, "dashed");
        figure.line({{factor * found.low, below}, {factor * found.high, below}}, "thick");
        figure.dot(factor * found.estimate, below, "ink", 4.5);
        int turn = 0;  // spreads dots over the strip's height, always in the same way
        for (const MemberRow* member : done_members(evidence.table, i))
            figure.dot(factor * quantity.of(*member), middle - 0.04 + 0.08 * (turn++ * 2 % 5), colour(i) + " faint");
    }
    return figure;
}

}  // namespace

Table averaged_table(const Summary& summary) {
    Table table{{"case", "over, s", "SD, N", "mean maximum, N", "95 % interval", "one further run", "SD maximum, N"}};
    for (const CaseSummary& row : summary.cases) {
        for (const Quantity& one : summary.quantities) {
            if (one.averaging == 0 || one.averaged != quantity("mean_maximum").averaged) continue;
            const Estimate& found = row.of(one);
            const auto estimate = [&](const Quantity& other) {
                return fixed(row.of(averaged_over(other, one.averaging)).estimate, 1);
            };
            table.push_back({row.about.name, fmt::format("{}", one.averaging), estimate(quantity("sd_load")),
                             fixed(found.estimate, 1), bracket(found.low, found.high, 1),
                             bracket(found.prediction_low, found.prediction_high, 1),
                             estimate(quantity("sd_maximum"))});
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
    return {.table = table3(evidence.campaign, evidence.summary),
            .after = fmt::format("Mean over arrangements with its 95 % confidence interval; below it the 95 % "
                                 "prediction interval of one further arrangement.{}",
                                 papers ? " The paper's figures are one run each, and the experiment's maximum is one "
                                          "value."
                                        : ""),
            .figures = {strips(evidence, quantity("mean_load"),
                               "Each dot is one arrangement. Below the dots: mean, its 95 % confidence interval "
                               "(thick), and the 95 % prediction interval of one further run (dashed)."),
                        strips(evidence, quantity("mean_maximum"), "The same for the mean of the segments' maxima."),
                        strips(evidence, quantity("failure_ratio"), "The same for the share of broken floes.")}};
}

}  // namespace floes
