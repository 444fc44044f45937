#include "findings/control_section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "arrangement/arrangement.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

std::vector<double> covariates(double local_order, double coverage_ahead) {
    return {local_order, coverage_ahead};
}

Covariates drawn(const Scenario& scenario, std::uint64_t seed, int first) {
    Covariates rows;
    for (int k = 0; k < control_draws; ++k) {
        const Arrangement made = make_arrangement(scenario, seed, static_cast<std::uint32_t>(first + k));
        rows.push_back(covariates(made.local_order, made.coverage_ahead));
    }
    return rows;
}

std::vector<Cell> line(const Summary& summary, const ControlRow& row) {
    const double factor = row.quantity.factor();
    const ControlledMean& found = row.found;
    const int decimals = row.quantity.percent ? 1 : decimals_for(std::abs(found.plain.estimate));
    const auto cell = [&](const Interval& mean) {
        return Cell{fixed(factor * mean.estimate, decimals), bracket(factor * mean.low, factor * mean.high, decimals)};
    };
    return {fmt::format("{}, {}", summary.label_of(row.case_index), row.quantity.label), cell(found.plain),
            fixed(found.left_out, 2), found.used ? cell(found.corrected) : Cell{"off", ""},
            found.used ? fmt::format("{:.0f}", found.saved) : ""};
}

}  // namespace

std::vector<ControlRow> find_control(const Campaign& campaign, const CampaignTable& table) {
    std::map<std::uint64_t, Covariates> populations;
    std::vector<ControlRow> rows;
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        const Scenario& scenario = campaign.cases.at(k).scenario;
        if (scenario.arrangement.given()) continue;
        const auto [place, added] = populations.try_emplace(geometry_key(scenario));
        if (added) place->second = drawn(scenario, campaign.seed, campaign.arrangements);
        for (const Quantity& one : shown_in(quantities, Shown::in_headlines)) {
            std::vector<double> values;
            Covariates known;
            for (const MemberRow& member : table.members) {
                if (member.case_index != static_cast<int>(k) || !member.done()) continue;
                values.push_back(member.value(one));
                known.push_back(covariates(member.local_order, member.coverage_ahead));
            }
            rows.push_back({k, one, controlled_mean(values, known, place->second)});
        }
    }
    return rows;
}

Section control_section(const Summary& summary, const std::vector<ControlRow>& rows) {
    Table table{{"control variates", {"mean", ""}, "R² left out", {"corrected", ""}, "arrangements saved"}};
    for (const ControlRow& row : rows) table.push_back(line(summary, row));
    const auto of = [](Interval ControlledMean::*mean, double Interval::*value) {
        return [=](const ControlRow& row) { return row.quantity.factor() * row.found.*mean.*value; };
    };
    return {
        .table = std::move(table),
        .after = fmt::format(
            "\nMeans corrected for the local order and the coverage ahead of the arrangements that were run, against "
            "{} that were only drawn. R² left out: share of the variance that these predict of arrangements which the "
            "fit has not seen; at 0 or below, where the interval is no shorter, and with fewer than {} arrangements, "
            "the "
            "correction is off.\n",
            control_draws, fewest_controlled),
        .records = {
            make_rows<ControlRow>("control", rows,
                                  {{"case", [&](const ControlRow& row) { return summary.name_of(row.case_index); }},
                                   {"quantity", [](const ControlRow& row) { return row.quantity.name.view(); }},
                                   {"mean", of(&ControlledMean::plain, &Interval::estimate)},
                                   {"low", of(&ControlledMean::plain, &Interval::low)},
                                   {"high", of(&ControlledMean::plain, &Interval::high)},
                                   {"r_squared_left_out", [](const ControlRow& row) { return row.found.left_out; }},
                                   {"used", [](const ControlRow& row) { return row.found.used; }},
                                   {"corrected", of(&ControlledMean::corrected, &Interval::estimate)},
                                   {"corrected_low", of(&ControlledMean::corrected, &Interval::low)},
                                   {"corrected_high", of(&ControlledMean::corrected, &Interval::high)},
                                   {"arrangements_saved", [](const ControlRow& row) { return row.found.saved; }}})}};
}

}  // namespace floes
