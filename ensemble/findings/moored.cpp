#include "findings/moored.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

void check_hull(const Oscillator& hull) {
    if (!(hull.stiffness > 0 && std::isfinite(hull.stiffness)))
        throw InputError(
            fmt::format("The stiffness of the moorings, {:g} kN/m, has to be above 0.", hull.stiffness / 1e3));
    if (!(hull.mass > 0 && std::isfinite(hull.mass)))
        throw InputError(fmt::format(
            "The mass of the moored hull, {:g} t, has to be above 0; it is that of the hull with its added mass.",
            hull.mass / 1e3));
    if (!(hull.damping_ratio > 0 && hull.damping_ratio < 1))
        throw InputError(
            fmt::format("The damping of the moored hull, {:g} % of the critical, has to be above 0 and below 100 %: "
                        "without it no swing ever fades, and with more the hull does not swing.",
                        hull.damping_ratio / unit::percent));
}

namespace {

/// Of values `step` s apart in the window of a case, averaged over one time.
AveragedLoad averaged_once(std::span<const double> values, double step, const Analysis& analysis, double time,
                           double separation) {
    return averaged_load(values, {.time_step = step,
                                  .segments = analysis.segments,
                                  .times = std::span(&time, 1),
                                  .peak_separation = separation})
        .front();
}

}  // namespace

AveragedLoad load_in_window(std::span<const double> surge, double step, const Analysis& analysis, double time) {
    const std::span<const double> loads = in_window({0, step, surge}, analysis);
    const double segment = step * static_cast<double>(loads.size() / static_cast<std::size_t>(analysis.segments));
    return averaged_once(loads, step, analysis, std::clamp(time, step, std::max(step, segment)),
                         analysis.peak_separation);
}

double first_load(std::span<const double> surge, double step) {
    const auto met = std::ranges::find_if(surge, [](double load) { return load != 0; });
    return step * static_cast<double>(met - surge.begin());
}

double moored_separation(const Analysis& analysis, const Oscillator& model) {
    return std::max({analysis.peak_separation, model.period(), 1 / model.decay_rate()});
}

namespace {

/// The states in the window.
std::vector<OscillatorState> states_in_window(std::span<const double> surge, double step, const Analysis& analysis,
                                              const Oscillator& hull) {
    std::vector<OscillatorState> states = motion_under(hull, surge, step);
    const auto window = static_cast<std::size_t>(std::llround(analysis.window / step));
    if (states.size() > window) states.erase(states.begin(), states.end() - static_cast<std::ptrdiff_t>(window));
    return states;
}

std::vector<double> force_of(const std::vector<OscillatorState>& states, double stiffness) {
    std::vector<double> force;
    force.reserve(states.size());
    for (const OscillatorState& at : states) force.push_back(stiffness * at.offset);
    return force;
}

}  // namespace

std::vector<double> mooring_force(std::span<const double> surge, double step, const Analysis& analysis,
                                  const MooredRequest& request) {
    const Oscillator hull = request.model();
    return force_of(states_in_window(surge, step, analysis, hull), hull.stiffness);
}

MooredRun moored_run(std::span<const double> surge, double step, const Analysis& analysis,
                     const MooredRequest& request) {
    const Oscillator hull = request.model();
    MooredRun run{.first_load = first_load(surge, step), .force = {}, .load = {}};
    const std::vector<OscillatorState> states = states_in_window(surge, step, analysis, hull);
    const std::vector<double> force = force_of(states, hull.stiffness);
    const double mean = mean_of(force);
    run.mean_offset = mean / hull.stiffness;
    run.sd_offset = population_sd(force, mean) / hull.stiffness;
    double squares = 0;
    for (const OscillatorState& at : states) squares += at.velocity * at.velocity;
    run.rms_velocity = std::sqrt(squares / static_cast<double>(states.size()));
    run.force = averaged_once(force, step, analysis, step, moored_separation(analysis, hull));
    run.load = load_in_window(surge, step, analysis, request.model_averaging());
    return run;
}

std::string period_refusal(const Analysis& analysis, double step, double period, double to_full) {
    if (period < fewest_values * step)
        return fmt::format(
            "the natural period of {:.3g} s has fewer than {:g} values of the load history, which are {:.3g} s apart: "
            "less mass, more stiffness or finer histories (analysis.history_steps) than these would be needed",
            to_full * period, fewest_values, to_full * step);
    if (period > analysis.window / fewest_periods)
        return fmt::format(
            "the natural period of {:.3g} s is longer than a third of the window of {:.4g} s: run with a longer "
            "analysis.window_s",
            to_full * period, to_full * analysis.window);
    return "";
}

std::string moored_refusal(const Analysis& analysis, double step, double last_entry, const MooredRequest& request) {
    constexpr double most_left = 0.05;  // of the entry's swing when the window begins
    const Oscillator hull = request.model();
    const double to_full = request.time_factor();
    if (std::string words = period_refusal(analysis, step, hull.period(), to_full); !words.empty()) return words;
    if (last_entry >= analysis.steady_start + analysis.window - step / 2) return "no ice ever loads the hull";
    const double run_up = analysis.steady_start - last_entry;
    const double left = std::exp(-hull.decay_rate() * std::max(run_up, 0.0));
    if (left > most_left)
        return fmt::format(
            "{:.0f} % of the swing with which the hull enters the ice is left when the window begins, {:.4g} s after "
            "the first load of the member that meets ice last: run with a later analysis.steady_start_s (by {:.3g} s) "
            "or give more damping",
            left / unit::percent, to_full * run_up, to_full * (-std::log(most_left) / hull.decay_rate() - run_up));
    return "";
}

namespace {

struct Stored {
    double step = 0;
    LastEntry entry = {};
    std::vector<MooredRun> runs = {};
};

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
        const std::size_t index = evidence.case_of(history.member);
        MooredRun run = moored_run(history.values, history.step, evidence.sample.cases[index].analysis, request);
        run.member = history.member;
        Stored& one = stored[index];
        one.step = history.step;
        one.entry.add(run.first_load, history.step * static_cast<double>(history.values.size()));
        one.runs.push_back(std::move(run));
    });
    if (stored.empty())
        throw InputError(
            "The file has no load histories, which move the moored hull: run with analysis.history_steps of 1 or "
            "more.");
    std::vector<MooredCase> found;
    for (auto& [index, one] : stored) {
        const Analysis& analysis = evidence.sample.cases[index].analysis;
        const Scenario& scenario = evidence.campaign.cases[index].scenario;
        std::string refused =
            scenario.moorings.give_way()
                ? "its hull gave way in the simulation, so its loads are no longer those of a fixed one"
                : moored_refusal(analysis, one.step, one.entry.time, request);
        found.push_back({index, moored_separation(analysis, request.model()), scenario.drift(), std::move(one.runs),
                         std::move(refused)});
    }
    if (std::ranges::none_of(found, [](const MooredCase& one) { return one.refused.empty(); }))
        throw InputError(fmt::format("Moored hull: {}: {}.", evidence.summary.label_of(found.front().case_index),
                                     found.front().refused));
    return found;
}

std::vector<CasePeaks> moored_peaks(const Sample& sample, const std::vector<MooredCase>& found) {
    std::vector<CasePeaks> all(sample.cases.size());
    for (std::size_t index = 0; index < all.size(); ++index)
        all[index].measured = measured_in(sample.cases[index].analysis, sample.cases[index].analysis.peak_separation);
    for (const MooredCase& one : found) {
        if (!one.refused.empty()) continue;
        CasePeaks& made = all[one.case_index];
        for (const MooredRun& run : one.runs) {
            const auto member = static_cast<std::size_t>(run.member);
            made.add(run.member, sample.arrangement_of(member), {run.force.peaks, run.force.segment_maximum},
                     sample.value(member, quantity("mean_load")));
        }
        made.average();
        made.measured.separation = one.separation;
    }
    return all;
}

std::vector<Section> moored_sections(Evidence& evidence) {
    std::vector<Section> sections;
    const bool scaled = evidence.moored && evidence.moored->scale != 1;  // where hulls moved is at the campaign's own
    if (std::optional<Section> simulated = moored_runs_section(evidence); simulated && !scaled)
        sections.push_back(std::move(*simulated));
    if (evidence.moored) {
        const MooredRequest& asked = *evidence.moored;
        const std::vector<MooredCase> found = find_moored(evidence, asked);
        sections.push_back(moored_section(evidence.summary, found, asked));
        sections.push_back(moored_spectrum(evidence, asked.hull.damping_ratio, asked.averaging, asked.scale));
        return sections;
    }
    // No stored load is that of a hull which does not give way.
    if (std::ranges::all_of(evidence.campaign.cases, [](const Case& one) { return one.scenario.moorings.give_way(); }))
        return sections;
    constexpr double usual_damping = 0.1;
    const std::vector<double>& times = evidence.sample.averaging_times;
    sections.push_back(moored_spectrum(evidence, usual_damping, times.empty() ? 1 : times.front(), 1));
    return sections;
}

namespace {

/// A mean over the runs of a case that have such a value.
Estimate over_runs(const MooredCase& one, double factor, const auto& value) {
    std::vector<double> values;
    for (const MooredRun& run : one.runs) values.push_back(factor * std::invoke(value, run));
    return over(values);
}

/// A row for each case, at full scale.
Results rows_of(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request) {
    const auto first = std::ranges::find_if(found, [](const MooredCase& one) { return one.refused.empty(); });
    const double averaging = first == found.end() ? 0 : request.time_factor() * first->runs.front().load.time;
    Results results{.place = "moored/cases",
                    .columns = std::vector<ResultColumn>{{"case", "moored"}, {"runs", "runs"}} +
                               program_columns("stiffness mass damping_ratio scale period averaging peak_separation") +
                               std::vector<ResultColumn>{
                                   estimates("mean_offset", "mean offset, m"),
                                   estimates("sd_offset", "SD of offset, m"),
                                   estimates("largest_force", "largest k x of a segment", "N"),
                                   estimates("largest_load", fmt::format("largest load over {:.3g} s", averaging), "N"),
                                   estimates("amplification", "amplification", "1", 2),
                                   {.key = "velocity_ratio", .words = "rms velocity / drift", .decimals = 3}}};
    for (const MooredCase& one : found) {
        if (!one.refused.empty()) continue;
        const double force = request.force_factor();
        results.add({summary.named(one.case_index), one.runs.size(), request.hull.stiffness, request.hull.mass,
                     request.hull.damping_ratio, request.scale, request.hull.period(),
                     request.time_factor() * one.runs.front().load.time, request.time_factor() * one.separation,
                     over_runs(one, request.scale, &MooredRun::mean_offset),
                     over_runs(one, request.scale, &MooredRun::sd_offset),
                     over_runs(one, force, [](const MooredRun& run) { return run.force.mean_maximum; }),
                     over_runs(one, force, [](const MooredRun& run) { return run.load.mean_maximum; }),
                     over_runs(one, 1, &MooredRun::amplification), one.velocity_ratio()});
    }
    return results;
}

}  // namespace

Section moored_section(const Summary& summary, const std::vector<MooredCase>& found, const MooredRequest& request) {
    constexpr double much_motion = 0.2;  // beside which the load of a fixed hull is no longer that of a moored one
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
    return {.title = fmt::format(
                "Moored hull: {:.6g} kN/m, {:.6g} t, {:g} % of the critical damping; natural period {:.3g} s",
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
