#include "findings/moored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

Oscillator MooredRequest::model() const {
    return {hull.stiffness / (scale * scale), hull.mass / force_factor(), hull.damping_ratio};
}

double MooredRequest::model_averaging() const {
    return averaging / time_factor();
}

double MooredRequest::time_factor() const {
    return std::sqrt(scale);
}

double MooredRequest::force_factor() const {
    return scale * scale * scale;
}

void check_hull(const Oscillator& hull) {
    if (!(hull.stiffness > 0 && std::isfinite(hull.stiffness)))
        throw InputError(
            fmt::format("The stiffness of the moorings, {:g} kN/m, has to be above 0.", hull.stiffness / 1e3));
    if (!(hull.mass > 0 && std::isfinite(hull.mass)))
        throw InputError(fmt::format(
            "The mass of the moored hull, {:g} t, has to be above 0; it is that of the hull with its added mass.",
            hull.mass / 1e3));
    if (!(hull.damping_ratio > 0 && hull.damping_ratio < 1))
        throw InputError(fmt::format(
            "The damping of the moored hull, {:g} % of the critical, has to be above 0 and below 100 %: without it no "
            "swing ever fades, and with more the hull does not swing.",
            hull.damping_ratio / unit::percent));
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
    const auto met = std::ranges::find_if(surge, [](double load) { return load != 0; });
    MooredRun run{.first_load = step * static_cast<double>(met - surge.begin()), .force = {}, .load = {}};
    const std::vector<OscillatorState> states = states_in_window(surge, step, analysis, hull);
    const std::vector<double> force = force_of(states, hull.stiffness);
    const double mean = mean_of(force);
    run.mean_offset = mean / hull.stiffness;
    run.sd_offset = population_sd(force, mean) / hull.stiffness;
    double squares = 0;
    for (const OscillatorState& at : states) squares += at.velocity * at.velocity;
    run.rms_velocity = std::sqrt(squares / static_cast<double>(states.size()));
    const auto measured = [&](std::span<const double> values, double time) {
        return averaged_load(values, {.time_step = step,
                                      .segments = analysis.segments,
                                      .times = std::span(&time, 1),
                                      .peak_separation = moored_separation(analysis, hull)})
            .front();
    };
    run.force = measured(force, step);
    const double segment = step * static_cast<double>(states.size() / static_cast<std::size_t>(analysis.segments));
    run.load =
        measured(surge.last(states.size()), std::clamp(request.model_averaging(), step, std::max(step, segment)));
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
            "the natural period of {:.3g} s is longer than a third of the window of {:.4g} s: run with a "
            "longer analysis.window_s",
            to_full * period, to_full * analysis.window);
    return "";
}

std::string moored_refusal(const Analysis& analysis, double step, double first_load, const MooredRequest& request) {
    const Oscillator hull = request.model();
    const double to_full = request.time_factor();
    if (std::string words = period_refusal(analysis, step, hull.period(), to_full); !words.empty()) return words;
    const double run_up = analysis.steady_start - first_load;
    const double left = std::exp(-hull.decay_rate() * std::max(run_up, 0.0));
    if (left > most_left)
        return fmt::format(
            "{:.0f} % of the swing with which the hull enters the ice is left when the window begins, {:.4g} s after "
            "the first load: run with a later analysis.steady_start_s (by {:.3g} s) or give more damping",
            left / unit::percent, to_full * run_up, to_full * (-std::log(most_left) / hull.decay_rate() - run_up));
    return "";
}

}  // namespace floes
