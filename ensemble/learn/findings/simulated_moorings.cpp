// The force of springs and lines of structures that gave way in the simulation, as tails are fitted to it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "campaign_file/read_history.hpp"
#include "core/error.hpp"
#include "findings/moored_cases.hpp"
#include "statistics/means.hpp"

namespace floes {
namespace {

/// Peaks nearer than a natural period, or than the time in which the hull's own damping lets a swing fall to 1/e, are
/// one event, as of a hull that stored loads move. Without damping of its own only the ice lets it fade.
double separation_of(const Analysis& analysis, const Moorings& moorings) {
    const double period = moorings.periods()[0];
    const double fade = moorings.damping > 0 ? period / (2 * std::numbers::pi * moorings.damping) : 0;
    return std::max({analysis.peak_separation, period, fade});
}

bool by_thrusters_alone(const Case& one) {
    return one.scenario.moorings.give_way() && one.scenario.moorings.stiffness()[0] == 0;
}

}  // namespace

std::vector<CasePeaks> simulated_mooring_peaks(const Evidence& evidence) {
    const CampaignTable& table = evidence.table;
    std::vector<CasePeaks> all(table.cases.size());
    for (std::size_t index = 0; index < all.size(); ++index) {
        const Analysis& analysis = table.cases[index].analysis;
        all[index].measured = {analysis.window, analysis.window / analysis.segments,
                               separation_of(analysis, evidence.campaign.cases[index].scenario.moorings), 0};
    }
    for_each_mooring_history(evidence.file, [&](const SurgeHistory& history) {
        const MemberRow& member = table.members[static_cast<std::size_t>(history.member)];
        const auto index = static_cast<std::size_t>(member.case_index);
        const Analysis& analysis = table.cases[index].analysis;
        const double period = evidence.campaign.cases[index].scenario.moorings.periods()[0];
        if (const std::string words = period_refusal(analysis, history.step, period, 1); !words.empty())
            throw InputError(fmt::format("Design mooring force: {}: {}.", evidence.summary.label_of(index), words));
        const auto window = static_cast<std::size_t>(std::llround(analysis.window / history.step));
        const std::span<const double> force = history.surge.last(std::min(window, history.surge.size()));
        CasePeaks& made = all[index];
        const AveragedLoad as_it_is = averaged_load(force, {.time_step = history.step,
                                                            .segments = analysis.segments,
                                                            .times = std::span(&history.step, 1),
                                                            .peak_separation = made.measured.separation})
                                          .front();
        made.rows.push_back({as_it_is.peaks, as_it_is.segment_maximum});
        made.arrangements.push_back(member.arrangement);
        made.members.push_back(history.member);
        made.measured.mean += mean_of(force);
    });
    if (std::ranges::all_of(all, [](const CasePeaks& one) { return one.rows.empty(); }))
        throw InputError(
            "The file has no histories of mooring forces: they are of structures that give way in the simulation, "
            "which moorings.mass_t makes them do, with analysis.history_steps of 1 or more. --mooring-kN-m, --mass-t "
            "and --damping-percent move a hull by the stored loads of a fixed one.");
    for (CasePeaks& one : all)
        if (!one.rows.empty()) one.measured.mean /= static_cast<double>(one.rows.size());
    return all;
}

std::string mooring_notes(const Evidence& evidence) {
    const Quantity& broken = *find_quantity("broken_lines");
    std::string text;
    for (std::size_t index = 0; index < evidence.table.cases.size(); ++index) {
        const std::string label = evidence.summary.label_of(index);
        if (by_thrusters_alone(evidence.campaign.cases[index]))
            text += fmt::format(
                "! {}: held by thrusters alone, so there is no mooring force; summarize --parts moored has their "
                "thrust "
                "and the time at its limit.\n",
                label);
        const auto members = done_members(evidence.table, index);
        const auto count =
            std::ranges::count_if(members, [&](const MemberRow* member) { return member->value(broken) > 0; });
        if (count > 0)
            text += fmt::format(
                "! {}: lines broke in {} of {} members: their force is limited by that of what was left, and no design "
                "force of lines that hold.\n",
                label, count, members.size());
    }
    return text;
}

}  // namespace floes
