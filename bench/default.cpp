// floes_default SCENE [ARRANGEMENT]: one scene of the default (tests/support/default_scenes.hpp) step by step. Without
// arguments it lists their names.
//
// It runs to the scene's time and prints what there is. Then each line that it reads is a number of steps, which a
// child process does from there: so all rounds do the same work, and the run up to the scene is paid once. The child's
// name is "timed" while it does them, by which perf tells them from the rest. It prints lines of JSON.

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "support/default_scenes.hpp"

namespace {

using namespace floes;

constexpr int warm_up = 3;  // steps: a child has its parent's memory, but each page once it is written

double cpu_ms() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double sweeps_so_far(const Simulation& simulation) {
    return simulation.mean_sweeps() * simulation.steps();
}

int elements(const Simulation& simulation) {
    const IceField& ice = simulation.ice();
    return static_cast<int>(
        std::ranges::count_if(ice.elements(), [&](const IceElement& one) { return ice.is_there(one.floe); }));
}

/// Those that bear a force.
std::size_t contacts(const Simulation& simulation) {
    Frame frame;
    simulation.read_frame(frame);
    return frame.contacts.size();
}

void time_steps(Simulation& simulation, int steps) {
    for (int i = 0; i < warm_up; ++i) simulation.step();
    const double sweeps = sweeps_so_far(simulation);
    const std::size_t breaks = simulation.ice().breaks().size();
    ::prctl(PR_SET_NAME, "timed");
    const double start = cpu_ms();
    for (int i = 0; i < steps; ++i) simulation.step();
    const double took = cpu_ms() - start;
    ::prctl(PR_SET_NAME, "told");
    fmt::print(R"({{"steps": {}, "ms": {:.6f}, "sweeps": {:.3f}, "elements": {}, "contacts": {}, "breaks": {}, )"
               R"("surge_N": {:.9g}}})"
               "\n",
               steps, took / steps, (sweeps_so_far(simulation) - sweeps) / steps, elements(simulation),
               contacts(simulation), simulation.ice().breaks().size() - breaks, simulation.loads().surge.back());
    std::fflush(stdout);
}

int answer(const DefaultScene& scene) {
    Simulation simulation = scene.reached();
    fmt::print(R"({{"scene": "{}", "time_s": {}, "floes": {}, "elements": {}, "run_up_ms": {:.0f}}})"
               "\n",
               scene.name, scene.time, simulation.ice().floes(), elements(simulation), cpu_ms());
    std::fflush(stdout);
    for (std::string line; std::getline(std::cin, line);) {
        const int steps = std::max(1, std::atoi(line.c_str()));
        const pid_t child = ::fork();
        if (child < 0) return 1;
        if (child == 0) {
            time_steps(simulation, steps);
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        if (status != 0) return 1;
    }
    return 0;
}

}  // namespace

int main(int count, char** words) try {
    if (count == 1) {
        for (const DefaultScene& scene : default_scenes()) fmt::print("{}\n", scene.name);
        return 0;
    }
    DefaultScene scene = default_scene(words[1]);
    if (count > 2) scene.arrangement = static_cast<std::uint32_t>(std::atoi(words[2]));
    return answer(scene);
} catch (const std::exception& trouble) {
    fmt::print(stderr, "{}\n", trouble.what());
    return 1;
}
