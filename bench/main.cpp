// floes_bench [--steps N] [Google Benchmark's own options]
//
// TowStep and Peer time one step in a fixed number of steps from the same stored state, so that every repetition does
// the same work; Member a whole shortened member; Size a step of drifting floes. See README.md.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "arrangement/arrangement.hpp"
#include "drift.hpp"
#include "member/run_member.hpp"
#include "peer.hpp"
#include "scene.hpp"
#include "shapes/hydrostatics.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

namespace {

constexpr int warm_up = 5;  // steps: the contacts that a stored state lacks, memory that grows once

void tow_step(benchmark::State& state, SolverKind solver, Scene (*make_scene)(), ContactLaw law, int iterations) {
    const Scene scene = make_scene();
    Scenario scenario = tow_scenario(solver, scene.wall);
    scenario.contact = law;
    if (iterations > 0) {
        scenario.general.iterations = iterations;
        scenario.general.tolerance = 0;
    }
    Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    for (int i = 0; i < warm_up; ++i) simulation.step();
    for (auto _ : state) simulation.step();
    state.counters["surge_N"] = simulation.loads().surge.back();
    state.counters["broken_floes"] = simulation.ice().broken_floes();
}

/// The hull on three hanging lines, which gives way in the plane or in all six motions: TowStep/direct/late_physical
/// with a hull that moves.
void moored_step(benchmark::State& state, bool six) {
    const Scene scene = late_scene();
    Scenario scenario = tow_scenario(SolverKind::direct, scene.wall);
    scenario.contact = with_preset({}, ContactPreset::physical);
    scenario.moorings = {.free = {true, true, true, six, six, six},
                         .mass = scenario.water.density * hydrostatics(scenario.structure.shape).volume,
                         .gyration = 0.4,
                         .pitch_gyration = 0.4,
                         .roll_gyration = 0.4,
                         .surge = 1000,
                         .sway = 1000,
                         .yaw = 500,
                         .damping = 0.1};
    for (const double azimuth : {0.0, 2.1, -2.1})
        scenario.moorings.hanging.push_back({.fairlead = {0.3 * std::cos(azimuth), -0.4, 0.3 * std::sin(azimuth)},
                                             .azimuth = azimuth,
                                             .distance = 5,
                                             .depth = 2,
                                             .cable = {5.45, 3, 2e5, 0.5}});
    Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    for (int i = 0; i < warm_up; ++i) simulation.step();
    for (auto _ : state) simulation.step();
    state.counters["surge_N"] = simulation.loads().surge.back();
}

void peer_step(benchmark::State& state, std::unique_ptr<Peer> (*make_peer)(const PeerScene&), Scene (*make_scene)()) {
    const std::unique_ptr<Peer> peer = make_peer(peer_scene(make_scene()));
    for (int i = 0; i < warm_up; ++i) peer->step();
    for (auto _ : state) peer->step();
    state.counters["contacts"] = peer->contacts();
    state.counters["fastest_m_s"] = peer->fastest();
}

/// A member of 20 s at four times the tow speed: 5.6 m of way from the edge of resting ice to packed ice.
void member(benchmark::State& state, SolverKind solver, double wake_radius, ContactLaw law) {
    const Scene scene = early_scene();
    Scenario scenario = tow_scenario(solver, scene.wall);
    scenario.contact = law;
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

void size_step(benchmark::State& state, const Drift& drift) {
    Simulation simulation = make_drift(drift);
    for (int i = 0; i < 20; ++i) simulation.step();
    for (auto _ : state) simulation.step();
    state.counters["floes"] = drift.floes;
    state.counters["elements"] = static_cast<double>(simulation.element_states().size());
    state.counters["joints"] = simulation.ice().live_joints();
}

void add_size(const Drift& drift, std::string_view what, int value, int steps) {
    const std::string name = fmt::format("Size/{}:{}", what, value);
    benchmark::RegisterBenchmark(name.c_str(), size_step, drift)->Iterations(steps)->Unit(benchmark::kMillisecond);
}

void add_all(int steps) {
    const auto add = [steps](const std::string& name, auto function, auto... arguments) {
        benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
            ->Iterations(steps)
            ->Unit(benchmark::kMillisecond);
    };
    add("TowStep/stock/late", tow_step, SolverKind::stock, late_scene, ContactLaw{}, 0);
    add("TowStep/stock/late_steep", tow_step, SolverKind::stock, late_steep_scene, ContactLaw{}, 0);
    add("TowStep/stock/early", tow_step, SolverKind::stock, early_scene, ContactLaw{}, 0);
    add("TowStep/lanes/early", tow_step, SolverKind::lanes, early_scene, ContactLaw{}, 0);
    const std::pair<const char*, ContactLaw> laws[] = {
        {"", {}},
        {"_cone", {.friction = Friction::cone}},
        {"_crushing", {.normal = NormalLaw::crushing, .internal_edges = false}},
        {"_cone_crushing", with_preset({}, ContactPreset::physical)}};
    for (const auto& [name, law] : laws) {
        add(fmt::format("TowStep/lanes/late{}", name), tow_step, SolverKind::lanes, late_scene, law, 0);
        add(fmt::format("TowStep/lanes/late_steep{}", name), tow_step, SolverKind::lanes, late_steep_scene, law, 0);
    }
    const ContactLaw physical = with_preset({}, ContactPreset::physical);
    for (const int iterations : {20, 50}) {
        add(fmt::format("TowStep/direct/late_cone_crushing_{}", iterations), tow_step, SolverKind::direct, late_scene,
            physical, iterations);
        add(fmt::format("TowStep/direct/late_steep_cone_crushing_{}", iterations), tow_step, SolverKind::direct,
            late_steep_scene, physical, iterations);
    }
    add("TowStep/direct/late_physical", tow_step, SolverKind::direct, late_scene, physical, 0);
    add("TowStep/direct/late_steep_physical", tow_step, SolverKind::direct, late_steep_scene, physical, 0);
    add("TowStep/direct/early_physical", tow_step, SolverKind::direct, early_scene, physical, 0);
    add("TowStep/lanes/early_physical", tow_step, SolverKind::lanes, early_scene, physical, 0);
    add("MooredStep/three", moored_step, false);
    add("MooredStep/six", moored_step, true);
    add("Peer/bullet/late", peer_step, make_bullet, late_scene);
    add("Peer/ode/late", peer_step, make_ode, late_scene);
    const auto add_member = [](const std::string& name, SolverKind solver, double wake_radius, ContactLaw law = {}) {
        benchmark::RegisterBenchmark(name.c_str(), member, solver, wake_radius, law)
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    };
    add_member("Member/stock", SolverKind::stock, 0);
    add_member("Member/lanes", SolverKind::lanes, 0);
    add_member("Member/lanes_physical", SolverKind::lanes, 0, physical);
    add_member("Member/direct_physical", SolverKind::direct, 0, physical);
    for (const double radius : {6.0, 4.0, 3.0, 2.0}) {
        add_member(fmt::format("Member/lanes/wake:{}", radius), SolverKind::lanes, radius);
    }
    for (const int floes : {50, 100, 189, 500, 1000, 2000, 5000, 10000, 20000}) {
        add_size({.floes = floes}, "floes", floes, 5);
    }
    for (const int along : {1, 2, 3, 4, 5, 6}) add_size({.elements_along = along}, "elements", along * along, 20);
    for (const int along : {3, 4, 5, 6}) {
        add_size({.elements_along = along, .solver = SolverKind::direct}, "direct/elements", along * along, 20);
    }
    for (const int floes : {50, 100, 189, 500, 1000, 2000, 5000, 10000, 20000}) {
        add_size({.floes = floes, .solver = SolverKind::direct}, "direct/floes", floes, 5);
    }
    for (const int floes : {189, 2000}) {
        const Drift direct{.floes = floes, .concentration = 0.6, .solver = SolverKind::direct};
        add_size(direct, "squares", floes, 20);
        Drift hexagons = direct;
        hexagons.hexagons = true;
        add_size(hexagons, "hexagons", floes, 20);
    }
    for (const int percent : {50, 60, 70, 75, 80, 85}) {
        add_size({.concentration = percent / 100.0}, "concentration", percent, 20);
    }
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
