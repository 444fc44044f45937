#include "findings/moored_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/estimates.hpp"
#include "findings/summary.hpp"

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
    for_each_history(evidence.file, [&](const StoredHistory& history) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(history.member)];
        const auto index = static_cast<std::size_t>(member.case_index);
        MooredRun run = moored_run(history.values, history.step, evidence.table.cases[index].analysis, request);
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

namespace {

/// A mean over the runs of a case.
Estimate over(const MooredCase& one, double factor, const std::function<double(const MooredRun&)>& value) {
    std::vector<double> values;
    for (const MooredRun& run : one.runs) values.push_back(factor * value(run));
    return estimate(mean_interval(values), static_cast<int>(values.size()));
}

/// A row for each case, at full scale.
Results rows_of(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request) {
    const auto first = std::ranges::find_if(found, [](const MooredCase& one) { return one.refused.empty(); });
    const double averaging = first == found.end() ? 0 : request.time_factor() * first->runs.front().load.time;
    ResultColumn amplification = estimates("amplification", "amplification");
    amplification.decimals = 2;
    Results results{.place = "moored/cases",
                    .columns = std::vector<ResultColumn>{{"case", "moored"}, {"runs", "runs"}} +
                               program_columns("stiffness mass damping_ratio scale period averaging peak_separation")};
    results.columns.push_back(estimates("mean_offset", "mean offset, m"));
    results.columns.push_back(estimates("sd_offset", "SD of offset, m"));
    results.columns.push_back(estimates("largest_force", "largest k x of a segment", "N"));
    results.columns.push_back(estimates("largest_load", fmt::format("largest load over {:.3g} s", averaging), "N"));
    results.columns.push_back(std::move(amplification));
    results.columns.push_back({.key = "velocity_ratio", .words = "rms velocity / drift", .decimals = 3});
    for (const MooredCase& one : found) {
        if (!one.refused.empty()) continue;
        const double force = request.force_factor();
        results.add({summary.named(one.case_index), one.runs.size(), request.hull.stiffness, request.hull.mass,
                     request.hull.damping_ratio, request.scale, request.hull.period(),
                     request.time_factor() * one.runs.front().load.time, request.time_factor() * one.separation,
                     over(one, request.scale, [](const MooredRun& run) { return run.mean_offset; }),
                     over(one, request.scale, [](const MooredRun& run) { return run.sd_offset; }),
                     over(one, force, [](const MooredRun& run) { return run.force.mean_maximum; }),
                     over(one, force, [](const MooredRun& run) { return run.load.mean_maximum; }),
                     over(one, 1, [](const MooredRun& run) { return run.amplification(); }), one.velocity_ratio()});
    }
    return results;
}

}  // namespace

Section moored_section(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request) {
    const Oscillator& hull = request.hull;
    std::string doubts;
    std::vector<std::string> notes;
    for (const MooredCase& one : found) {
        const std::string& name = summary.label_of(one.case_index);
        const double ratio = one.velocity_ratio();
        if (!one.refused.empty())
            notes.push_back(fmt::format("{}: not answered: {}.", name, one.refused));
        else if (std::isfinite(ratio) && ratio > much_motion)
            doubts += fmt::format(
                "! {}: the hull moves with {:.0f} % of the drift speed (rms). The load of a fixed hull is then not the "
                "load that it gets, and these figures are no more than an indication.\n",
                name, ratio / unit::percent);
    }
    return {
        .title = fmt::format("Moored hull: {:.6g} kN/m, {:.6g} t, {:g} % of the critical damping; natural period "
                             "{:.3g} s",
                             hull.stiffness / 1e3, hull.mass / 1e3, hull.damping_ratio / unit::percent, hull.period()),
        .before = std::move(doubts),
        .results = {rows_of(summary, found, request)},
        .after =
            "\nm x'' + c x' + k x = F(t) in surge, F the stored load of the fixed hull, exact between its values. "
            "Largest of a segment: mean over segments and arrangements; brackets: 95 % (t). Amplification: largest "
            "k x over largest load. Rms velocity / drift: the load of a fixed hull serves while it is small, below "
            "some 0.2. docs/moorings.md\n",
        .notes = std::move(notes)};
}

}  // namespace floes
