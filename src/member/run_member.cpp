#include "member/run_member.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "arrangement/arrangement.hpp"
#include "member/design_of.hpp"
#include "member/moored_response.hpp"
#include "member/quantity.hpp"
#include "member/stepped_member.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

double cpu_seconds_of_this_thread() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> properties_of(const FloeSet& floes) {
    std::vector<double> rows;
    for (std::size_t i = 0; i < floes.size(); ++i)
        for (const FloeProperty& one : floe_properties) rows.push_back(one.of(floes.shape(i), floes.material(i)));
    return rows;
}

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Takes over what was recorded, whether or not the run reached its end.
void take_record(MemberResult& result, const Arrangement& floes, const Simulation& simulation) {
    result.local_order = floes.local_order;
    result.coverage_ahead = floes.coverage_ahead;
    result.history = simulation.loads();
    result.bed = simulation.bed_loads();
    result.motion = simulation.motions();
    if (const auto& moored = simulation.structure().moored()) {
        result.line_tension = moored->largest_tensions();
        result.line_broken_at = moored->state().broken_at;
    }
    result.breaks = simulation.ice().breaks();
    for (std::size_t mode = 0; mode < result.failures.size(); ++mode)
        result.failures[mode] =
            static_cast<double>(std::ranges::count(result.breaks, static_cast<FailureMode>(mode), &BreakEvent::mode));
    result.peaks = simulation.ice().peaks();
}

void take_statistics(MemberResult& result, const Scenario& scenario, const Simulation& simulation) {
    const std::span<const double> surge = in_window(scenario, result.history.surge);
    const auto window_mean = [&](const std::vector<double>& history) { return mean_of(in_window(scenario, history)); };
    result.load = load_statistics(surge, scenario.general.time_step, scenario.analysis.segments);
    const std::vector<double> times = scenario.averaging_times();
    const Averaging how{.time_step = scenario.general.time_step,
                        .segments = scenario.analysis.segments,
                        .times = times,
                        .peak_separation = scenario.analysis.peak_separation};
    result.averaged = averaged_load(surge, how);
    const HullLoads& hull = simulation.hull_loads();
    result.parts = hull.parts(how);
    result.yaw = hull.yaw();
    result.roll = hull.roll();
    result.pitch = hull.pitch();
    result.levels = count_levels(surge, scenario.analysis.exceedance_levels);
    result.load_map = simulation.load_map();
    result.load_map.along_tow = part_means(surge, LoadMap::parts);
    result.mean_sway = window_mean(result.history.sway);
    result.mean_heave = window_mean(result.history.heave);
    result.work = simulation.work();
    if (scenario.field.level_pushed)  // the structure is at rest, and no tow works
        for (const auto share : all_work_shares) result.work.*share = MemberResult::not_measured;
    const IceField& ice = simulation.ice();
    const double entered = simulation.floes_entered();
    result.floes_entered = entered;
    result.floes_met = simulation.floes_met();
    result.met_failure_ratio = simulation.floes_met_broken() / result.floes_met;  // NaN where none was met
    result.mean_concentration = window_mean(result.history.concentration);
    result.pile_height = window_mean(result.history.pile_height);
    result.pile_draught = window_mean(result.history.pile_draught);
    const auto mean_on_bed = [&](const std::vector<double>& history) {
        return scenario.water.has_bed() ? window_mean(history) : MemberResult::not_measured;
    };
    result.mean_bed_surge = mean_on_bed(result.bed.surge);
    result.mean_bed_weight = mean_on_bed(result.bed.weight);
    result.mean_grounded = mean_on_bed(result.bed.grounded);
    const IceAmount astern = simulation.fallen_astern();
    const bool one_way = !scenario.path.any();
    result.ice_flux = one_way ? astern.area / scenario.analysis.window : MemberResult::not_measured;
    result.floes_astern = one_way ? astern.floes : MemberResult::not_measured;
    result.failure_ratio = ice.broken_floes() / entered;
    result.split_ratio = ice.split_floes() / entered;
    result.cracked_ratio = ice.cracked_floes() / entered;
    result.pieces = ice.pieces() - (ice.is_sheet() ? 0 : simulation.floes_resting());
    result.piece_areas = ice.piece_areas();
    result.fracture_work = ice.fracture_work();
    result.mean_sweeps = simulation.mean_sweeps();
}

/// The response of a structure on moorings that give way.
void take_response(MemberResult& result, const Scenario& scenario) {
    result.responses = responses_of(scenario, result.motion);
    result.moored = moored_response(scenario, result.motion);
    if (result.line_tension.empty()) return;
    result.moored.line_tension = std::ranges::max(result.line_tension);
    result.moored.broken_lines = static_cast<double>(
        std::ranges::count_if(result.line_broken_at, [](double time) { return !std::isnan(time); }));
}

/// Thins a history of every step as the campaign requests. `all`: its list.
template <class Owner>
Owner kept(Owner history, const auto& all, const Analysis& analysis) {
    if (!analysis.keep_history) return {};
    if (analysis.history_stride == 1) return history;
    const auto stride = static_cast<std::size_t>(analysis.history_stride);
    for (const auto& one : all) history.*one.values = batch_means(history.*one.values, stride);
    return history;
}

void set_aside(MemberResult& result, const Scenario& scenario, const std::string& reason) {
    static_cast<MemberOutputs&>(result) = unmeasured(scenario.analysis.segments);
    result.status = MemberStatus::failed;
    result.reason = reason;
}

void go_on_from(std::span<const std::byte> saved, Simulation& simulation) {
    try {
        simulation.set(saved);
    } catch (const RunError& error) {
        throw SavedOtherwise(error.what());
    }
}

}  // namespace

MemberResult run_member(const Scenario& scenario, std::uint64_t seed, std::uint32_t arrangement, std::stop_token stop,
                        const Watcher& watch, std::span<const std::byte> saved) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu_start = cpu_seconds_of_this_thread();  // one thread computes a member from start to end
    SteppedMember member(scenario, seed, arrangement);
    const Arrangement& floes = member.floes();
    Simulation& simulation = member.simulation();
    MemberResult result;
    result.arrangement = floes.poses();
    if (floes_may_differ(scenario)) result.floe_properties = properties_of(floes);
    result.psi4 = floes.psi4;
    if (!saved.empty()) go_on_from(saved, simulation);
    try {
        if (!simulation.run(stop, watch)) {
            throw Interrupted(
                fmt::format("Arrangement {} was stopped on request at t = {:.2f} s.", arrangement, simulation.time()));
        }
        take_record(result, floes, simulation);
        take_statistics(result, scenario, simulation);
        if (scenario.moorings.give_way()) take_response(result, scenario);
    } catch (const MemberFailure& failure) {
        set_aside(result, scenario, failure.what());
        take_record(result, floes, simulation);
    }
    result.history = kept(std::move(result.history), load_histories, scenario.analysis);
    result.bed = kept(std::move(result.bed), bed_histories, scenario.analysis);
    result.motion = kept(std::move(result.motion), motion_histories, scenario.analysis);
    result.wall_time = seconds_since(start);
    result.cpu_time = cpu_seconds_of_this_thread() - cpu_start;
    return result;
}

}  // namespace floes
