#include "findings/control.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "arrangement/arrangement.hpp"
#include "findings/estimates.hpp"
#include "inference/linear_fit.hpp"

namespace floes {
namespace {

Covariates drawn(const Scenario& scenario, std::uint64_t seed, int first) {
    Covariates rows;
    for (int k = 0; k < control_draws; ++k) {
        const Arrangement made = make_arrangement(scenario, seed, static_cast<std::uint32_t>(first + k));
        rows.push_back({made.local_order, made.coverage_ahead});
    }
    return rows;
}

}  // namespace

Results find_control(const Evidence& evidence) {
    Results results{.place = "control",
                    .columns = {{"case", "control variates"},
                                {"quantity"},
                                estimates("mean", "mean", ""),
                                {.key = "r_squared_left_out", .words = "R² left out", .decimals = 2},
                                {"used"},
                                estimates("corrected", ""),
                                estimates("", "corrected", ""),
                                {.key = "arrangements_saved", .words = "arrangements saved", .decimals = 0}}};
    const Campaign& campaign = evidence.campaign;
    std::map<std::uint64_t, Covariates> populations;
    for (const Quantity& quantity : shown_in(evidence.summary.quantities, Shown::in_headlines)) {
        bool first = true;
        for (std::size_t k = 0; k < evidence.sample.cases(); ++k) {
            const Scenario& scenario = campaign.cases.at(k).scenario;
            if (scenario.arrangement.given()) continue;
            const auto [place, added] = populations.try_emplace(geometry_key(scenario));
            if (added) place->second = drawn(scenario, campaign.seed, campaign.arrangements);
            if (std::exchange(first, false))
                results.add_heading(std::string{quantity.label.view()}, Results::For::everybody, unit_of(quantity));
            const Members& members = evidence.sample.done(k);
            Covariates known;
            for (const std::size_t member : members)
                known.push_back(
                    {evidence.table.members[member].local_order, evidence.table.members[member].coverage_ahead});
            const ControlledMean found =
                controlled_mean(evidence.sample.values(members, quantity), known, place->second);
            const Estimate corrected{found.corrected.estimate, found.corrected.low, found.corrected.high};
            results.add({evidence.summary.named(k), quantity.key.view(),
                         Estimate{found.plain.estimate, found.plain.low, found.plain.high}, found.left_out, found.used,
                         corrected, found.used ? Datum(corrected) : Datum("off"), found.saved});
        }
    }
    return results;
}

Section control_section(Evidence& evidence) {
    return {.results = {find_control(evidence)},
            .after = fmt::format(
                "\nBrackets: 95 % interval. Means corrected for the local order and the coverage ahead of the "
                "arrangements that were run, against {} that were only drawn. R² left out: share of the variance that "
                "these predict of arrangements which the fit has not seen; at 0 or below, where the interval is no "
                "shorter, and with fewer than {} arrangements, the correction is off.\n",
                control_draws, fewest_controlled)};
}

}  // namespace floes
