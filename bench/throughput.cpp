// floes_throughput THREADS STEPS: so many threads each step a late scene of their own. Prints steps per wall-clock
// second of all threads, and steps per CPU second of this process.

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <latch>
#include <thread>
#include <vector>

#include "scene.hpp"
#include "simulation/simulation.hpp"

int main(int count, char** arguments) {
    using namespace floes;
    const int threads = count == 3 ? std::atoi(arguments[1]) : 0;
    const int steps = count == 3 ? std::atoi(arguments[2]) : 0;
    if (threads < 1 || steps < 1) {
        fmt::print(stderr, "Usage: floes_throughput THREADS STEPS\n");
        return 2;
    }
    const bench::Scene scene = bench::late_scene();
    std::deque<Simulation> simulations;
    for (int i = 0; i < threads; ++i) {
        const Scenario scenario = bench::tow_scenario(SolverKind::lanes, scene.wall);
        simulations.emplace_back(scenario, floes_at(scenario, scene.poses), scene.state);
        for (int warm_up = 0; warm_up < 5; ++warm_up) simulations.back().step();
    }
    std::latch ready(threads + 1);
    std::vector<std::jthread> crew;
    for (Simulation& simulation : simulations) {
        crew.emplace_back([&] {
            ready.arrive_and_wait();
            for (int i = 0; i < steps; ++i) simulation.step();
        });
    }
    ready.arrive_and_wait();
    const std::clock_t cpu_start = std::clock();
    const auto start = std::chrono::steady_clock::now();
    crew.clear();
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    fmt::print("{:.3f} {:.3f}\n", threads * steps / wall, threads * steps / cpu);
}
