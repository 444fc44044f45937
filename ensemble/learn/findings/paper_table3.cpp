#include "findings/paper_table3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "findings/load_columns.hpp"
#include "findings/printable.hpp"
#include "scenario/keys.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

/// The source of a key says whether its default is a value that the paper states.
bool stated(const Key& key) {
    const auto begins = [&](const char* words) { return key.source.starts_with(words); };
    return begins("Table 1") || begins("Table 3") || begins("the paper, ");
}

bool of_the_case(const Key& key) {
    return key.path == "ice.elastic_modulus_MPa" || key.path == "joint.cfm";
}

/// Loads in the unit that suits the largest of them, shares in percent.
Cell estimate_cell(const CaseSummary& row, const Quantity& quantity, int decimals, const LoadUnit& unit) {
    const Estimate& found = row.of(quantity);
    const double factor = quantity.percent ? quantity.factor() : unit.factor;
    constexpr double few = 10;  // below it a whole number says too little
    if (!quantity.percent && factor * found.estimate < few)
        decimals = std::max(decimals, few_decimals(factor * found.estimate));
    const auto range = [&](double low, double high) {
        if (!says_something(quantity, found.estimate, {low, high}, row.done)) return std::string{"–"};
        return bracket(factor * low, factor * high, decimals);
    };
    return {fixed(factor * found.estimate, decimals), range(found.low, found.high),
            range(found.prediction_low, found.prediction_high)};
}

std::vector<Cell> paper_line(const PaperRow& paper) {
    return {fmt::format("the paper at {:g} MPa", paper.elastic_modulus_mpa),
            "1",
            fixed(paper.mean, 1),
            fixed(paper.sd, 1),
            fixed(paper.mean_maximum, 0),
            fixed(paper.sd_maximum, 0),
            fixed(paper.failure_ratio / unit::percent, 1)};
}

std::vector<Cell> experiment_line() {
    const Experiment found;
    return {fmt::format("experiment at {:g} MPa", found.elastic_modulus_mpa),
            "",
            fixed(found.mean, 1),
            "",
            fmt::format("{:.1f} (largest)", found.maximum),
            "",
            fixed(found.failure_ratio / unit::percent, 0)};
}

}  // namespace

bool is_the_papers(const Scenario& scenario) {
    Scenario own = scenario;
    Scenario papers;
    const Keys keys = describe(own);
    const Keys defaults = describe(papers);
    return std::ranges::all_of(keys, [&](const Key& key) {
        return !stated(key) || of_the_case(key) || exact_text(key) == exact_text(*find_key(defaults, key.path));
    });
}

const PaperRow* paper_row(const Case& one) {
    if (!is_the_papers(one.scenario)) return nullptr;
    const double modulus = one.scenario.ice.elastic_modulus / unit::megapascal;
    const auto found = std::ranges::find_if(
        paper_table3, [&](const PaperRow& row) { return std::abs(row.elastic_modulus_mpa - modulus) < 0.5; });
    return found == paper_table3.end() ? nullptr : &*found;
}

Table table3(const Campaign& campaign, const Summary& summary) {
    double largest = 0;
    for (const CaseSummary& row : summary.cases)
        if (const double found = row.of(quantity("mean_maximum")).estimate; found > largest) largest = found;
    const LoadUnit unit = load_unit(largest);
    Table table{{"case", "n"}};
    for (const char* name : {"mean", "SD", "mean maximum", "SD maximum"})
        table.front().emplace_back(fmt::format("{}, {}", name, unit.name));
    table.front().emplace_back("broken floes, %");
    bool experiment = false;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) {
        const CaseSummary& row = summary.cases[k];
        table.push_back(
            {summary.label_of(k), fmt::format("{}", row.done), estimate_cell(row, quantity("mean_load"), 1, unit),
             estimate_cell(row, quantity("sd_load"), 1, unit), estimate_cell(row, quantity("mean_maximum"), 0, unit),
             estimate_cell(row, quantity("sd_maximum"), 0, unit),
             estimate_cell(row, quantity("failure_ratio"), 1, unit)});
        const PaperRow* paper = paper_row(campaign.cases.at(k));
        if (paper == nullptr) continue;
        const bool again =
            k + 1 < campaign.cases.size() && paper_row(campaign.cases[k + 1]) == paper;  // in a design, show it once
        if (!again) table.push_back(paper_line(*paper));
        experiment = experiment || paper->elastic_modulus_mpa == Experiment{}.elastic_modulus_mpa;
    }
    if (experiment) table.push_back(experiment_line());
    return table;
}

}  // namespace floes
