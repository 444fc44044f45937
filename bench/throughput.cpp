// floes_throughput THREADS STEPS: so many threads each step the cone of the default. Prints steps per wall-clock
// second of all threads, and steps per CPU second of this process.

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <latch>
#include <thread>
#include <vector>

#include "support/default_scenes.hpp"

int main(int count, char** arguments) {
    using namespace floes;
    const int threads = count == 3 ? std::atoi(arguments[1]) : 0;
    const int steps = count == 3 ? std::atoi(arguments[2]) : 0;
    if (threads < 1 || steps < 1) {
        fmt::print(stderr, "Usage: floes_throughput THREADS STEPS\n");
        return 2;
    }
    const DefaultScene scene = default_scene("cone");
    std::latch ready(threads + 1);
    std::latch done(threads + 1);
    std::vector<std::jthread> crew;
    for (int i = 0; i < threads; ++i) {
        crew.emplace_back([&] {
            Simulation simulation = scene.reached();
            ready.arrive_and_wait();
            for (int step = 0; step < steps; ++step) simulation.step();
            done.arrive_and_wait();
        });
    }
    ready.arrive_and_wait();
    const std::clock_t cpu_start = std::clock();
    const auto start = std::chrono::steady_clock::now();
    done.arrive_and_wait();
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    fmt::print("{:.3f} {:.3f}\n", threads * steps / wall, threads * steps / cpu);
}
