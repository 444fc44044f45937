// floes_bench [--steps N] [Google Benchmark's own options]
//
// TowStep and Peer time one step in a fixed number of steps from the same stored state, so that every repetition does
// the same work; Member a whole shortened member; Size a step of drifting floes. See README.md.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "drift.hpp"
#include "member/run_member.hpp"
#include "peer.hpp"
#include "scene.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

namespace {

constexpr int warm_up = 5;  // steps: the contacts that a stored state lacks, memory that grows once

constexpr int whole_solve = 20000;  // iterations that leave nothing worth solving

/// What a step leaves unsolved: root of the mean square of what the velocities of elements are off by, mm/s, beside the
/// same step of the same engine solved wholly. Of the first step from the stored state, in which contacts begin without
/// impulses, whatever the engine.
double apart(const std::vector<Vec3>& found, const std::vector<Vec3>& exact) {
    double square = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) square += (found[i] - exact[i]).squaredNorm();
    return 1e3 * std::sqrt(square / static_cast<double>(exact.size()));
}

std::vector<Vec3> stepped(const Scene& scene, const Scenario& scenario) {
    Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    simulation.step();
    std::vector<Vec3> found;
    for (const BodyState& element : simulation.element_states()) found.push_back(element.velocity);
    return found;
}

void tow_step(benchmark::State& state, SolverKind solver, Scene (*make_scene)()) {
    const Scene scene = make_scene();
    const Scenario scenario = tow_scenario(solver);
    Scenario wholly = scenario;
    wholly.general.iterations = whole_solve;
    if (solver == SolverKind::direct) wholly.general.tolerance = 1e-7;
    state.counters["unsolved_mm_s"] = apart(stepped(scene, scenario), stepped(scene, wholly));
    Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    for (int i = 0; i < warm_up; ++i) simulation.step();
    for (auto _ : state) simulation.step();
    state.counters["surge_N"] = simulation.loads().surge.back();
    state.counters["broken_floes"] = simulation.ice().broken_floes();
}

void peer_step(benchmark::State& state, std::unique_ptr<Peer> (*make_peer)(const PeerScene&)) {
    const PeerScene scene = peer_scene(late_scene());
    const std::unique_ptr<Peer> exact = make_peer(scene);
    exact->set_iterations(whole_solve);
    exact->step();
    const std::unique_ptr<Peer> peer = make_peer(scene);
    peer->step();
    state.counters["unsolved_mm_s"] = apart(peer->velocities(), exact->velocities());
    for (int i = 1; i < warm_up; ++i) peer->step();
    for (auto _ : state) peer->step();
    state.counters["contacts"] = peer->contacts();
    const std::vector<Vec3> velocities = peer->velocities();
    const auto fastest = std::ranges::max_element(velocities, {}, [](const Vec3& v) { return v.norm(); });
    state.counters["fastest_m_s"] = fastest->norm();  // says that the scene still stands
}

/// A member of 20 s at four times the tow speed: 5.6 m of way from the edge of resting ice to packed ice.
void member(benchmark::State& state, SolverKind solver, double wake_radius) {
    const Scene scene = early_scene();
    Scenario scenario = tow_scenario(solver);
    scenario.arrangement.method = ArrangementMethod::file;
    scenario.arrangement.poses = scene.poses;
    scenario.field.wake_radius = wake_radius;
    scenario.structure.speed *= 4;
    scenario.analysis = {.steady_start = 5, .window = 15, .segments = 3};
    MemberResult result;
    for (auto _ : state) result = run_member(scenario, 1, 0, {});
    state.counters["steps"] = static_cast<double>(result.history.surge.size());
    state.counters["mean_surge_N"] = result.load.mean;
    state.counters["failure_ratio"] = result.failure_ratio;
}

void size_step(benchmark::State& state, int floes, bool by_default) {
    Simulation simulation = make_drift(floes, by_default);
    for (int i = 0; i < 20; ++i) simulation.step();
    const double sweeps = simulation.mean_sweeps() * simulation.steps();
    for (auto _ : state) simulation.step();
    state.counters["sweeps"] = (simulation.mean_sweeps() * simulation.steps() - sweeps) / state.iterations();
    state.counters["elements"] = static_cast<double>(simulation.element_states().size());
}

void add_all(int steps) {
    const auto add = [](const std::string& name, int times, auto function, auto... arguments) {
        benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
            ->Iterations(times)
            ->Unit(benchmark::kMillisecond);
    };
    for (const auto& [name, solver] :
         {std::pair("stock", SolverKind::stock), {"lanes", SolverKind::lanes}, {"direct", SolverKind::direct}}) {
        add(fmt::format("TowStep/{}/late", name), steps, tow_step, solver, late_scene);
        add(fmt::format("TowStep/{}/early", name), steps, tow_step, solver, early_scene);
        add(fmt::format("Member/{}", name), 1, member, solver, 0.0);
    }
    for (const double radius : {6.0, 2.0})
        add(fmt::format("Member/direct/wake:{}", radius), 1, member, SolverKind::direct, radius);
    add("Peer/bullet/late", steps, peer_step, make_bullet);
    add("Peer/ode/late", steps, peer_step, make_ode);
    for (const int floes : {50, 100, 189, 500, 1000, 2000, 5000, 10000, 20000})
        for (const bool by_default : {true, false})
            add(fmt::format("Size/{}/floes:{}", by_default ? "default" : "paper", floes), 5, size_step, floes,
                by_default);
}

/// Takes --steps N out of the arguments.
int steps_from(int& count, char** arguments) {
    int steps = 50;
    int kept = 1;
    for (int i = 1; i < count; ++i) {
        if (std::string_view(arguments[i]) == "--steps" && i + 1 < count) {
            steps = std::max(1, std::atoi(arguments[++i]));
        } else {
            arguments[kept++] = arguments[i];
        }
    }
    count = kept;
    return steps;
}

}  // namespace

}  // namespace floes::bench

int main(int count, char** arguments) {
    floes::bench::add_all(floes::bench::steps_from(count, arguments));
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
