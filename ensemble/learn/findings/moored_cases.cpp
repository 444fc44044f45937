#include "findings/moored_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "campaign_file/read_history.hpp"
#include "core/error.hpp"

namespace floes {
namespace {

struct Stored {
    double step = 0;
    double first_load = 0;
    std::vector<MooredRun> runs;
};

std::string why(const Evidence& evidence, const MooredCase& one) {
    return fmt::format("{}: {}.", evidence.summary.label_of(one.case_index), one.refused);
}

}  // namespace

double MooredCase::velocity_ratio() const {
    double squares = 0;
    for (const MooredRun& run : runs) squares += run.rms_velocity * run.rms_velocity;
    return std::sqrt(squares / static_cast<double>(runs.size())) / drift;
}

std::vector<MooredCase> find_moored(const Evidence& evidence, const MooredRequest& request) {
    check_hull(request.hull);
    std::map<std::size_t, Stored> stored;
    for_each_history(evidence.file, [&](const SurgeHistory& history) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(history.member)];
        const auto index = static_cast<std::size_t>(member.case_index);
        MooredRun run = moored_run(history.surge, history.step, evidence.table.cases[index].analysis, request);
        run.member = history.member;
        const auto [at, fresh] = stored.try_emplace(index, Stored{history.step, run.first_load, {}});
        at->second.first_load = std::min(at->second.first_load, run.first_load);
        at->second.runs.push_back(std::move(run));
    });
    if (stored.empty())
        throw InputError(
            "The file has no load histories, which move the moored hull: run with analysis.history_steps of 1 or "
            "more.");
    std::vector<MooredCase> found;
    for (auto& [index, one] : stored) {
        const Analysis& analysis = evidence.table.cases[index].analysis;
        const Scenario& scenario = evidence.campaign.cases[index].scenario;
        std::string refused =
            scenario.moorings.give_way()
                ? "its hull gave way in the simulation, so its loads are no longer those of a fixed one"
                : moored_refusal(analysis, one.step, one.first_load, request);
        found.push_back({index, moored_separation(analysis, request.model()),
                         evidence.campaign.cases[index].scenario.structure.speed, std::move(one.runs),
                         std::move(refused)});
    }
    if (std::ranges::none_of(found, [](const MooredCase& one) { return one.refused.empty(); }))
        throw InputError("Moored hull: " + why(evidence, found.front()));
    return found;
}

std::vector<CasePeaks> moored_peaks(const CampaignTable& table, const std::vector<MooredCase>& found) {
    std::vector<CasePeaks> all(table.cases.size());
    for (std::size_t index = 0; index < all.size(); ++index) {
        const Analysis& analysis = table.cases[index].analysis;
        all[index].measured = {analysis.window, analysis.window / analysis.segments, analysis.peak_separation, 0};
    }
    for (const MooredCase& one : found) {
        if (!one.refused.empty()) continue;
        CasePeaks& made = all[one.case_index];
        for (const MooredRun& run : one.runs) {
            made.rows.push_back({run.force.peaks, run.force.segment_maximum});
            made.arrangements.push_back(table.members[static_cast<std::size_t>(run.member)].arrangement);
            made.members.push_back(run.member);
            made.measured.mean += table.members[static_cast<std::size_t>(run.member)].load.mean;
        }
        made.measured.mean /= static_cast<double>(one.runs.size());
        made.measured.separation = one.separation;
    }
    return all;
}

namespace {

/// Whether no stored load is that of a hull which does not give way.
bool all_give_way(const Evidence& evidence) {
    return std::ranges::all_of(evidence.campaign.cases,
                               [](const Case& one) { return one.scenario.moorings.give_way(); });
}

}  // namespace

std::vector<Section> moored_sections(Evidence& evidence) {
    std::vector<Section> sections;
    if (std::optional<Section> simulated = moored_runs_section(evidence)) sections.push_back(std::move(*simulated));
    if (evidence.moored) {
        const MooredRequest& asked = *evidence.moored;
        const std::vector<MooredCase> found = find_moored(evidence, asked);
        sections.push_back(moored_section(evidence.summary, found, asked));
        sections.push_back(moored_spectrum(evidence, asked.hull.damping_ratio, asked.averaging, asked.scale));
        return sections;
    }
    if (all_give_way(evidence)) return sections;
    constexpr double usual_damping = 0.1;
    const std::vector<double>& times = evidence.table.averaging_times;
    sections.push_back(moored_spectrum(evidence, usual_damping, times.empty() ? 1 : times.front(), 1));
    return sections;
}

}  // namespace floes
