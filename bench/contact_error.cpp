// floes_contact_error [SCENE …]: what the end of the sweeps leaves unsolved in single steps of the default, beside the
// time that it takes, as CSV.
//
// From states of a scene (tests/support/default_scenes.hpp), some steps apart, one step with each tolerance beside the
// same step with sweeps that change nothing any more, or 20,000 of them. The error of the load is the mean of what it
// is off by over the mean load; that of velocities the root of the mean square over elements and steps.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "support/default_scenes.hpp"

namespace {

using namespace floes;

constexpr int states = 30;
constexpr int apart = 10;  // steps

struct Step {
    std::vector<BodyState> elements;
    Vec3 load;
    double sweeps;
    double ms;
};

Step step_from(const DefaultScene& scene, const Bytes& state, double tolerance, int iterations) {
    Scenario scenario = scene.scenario();
    scenario.general.tolerance = tolerance;
    scenario.general.iterations = iterations;
    LaidField laid = lay_field(scenario, 1, scene.arrangement);
    Simulation simulation(scenario, laid.floes, std::move(laid.ahead));
    simulation.set(state);
    const double before = simulation.mean_sweeps() * simulation.steps();
    const auto start = std::chrono::steady_clock::now();
    simulation.step();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    const LoadHistory& loads = simulation.loads();
    return {{simulation.element_states().begin(), simulation.element_states().end()},
            {loads.surge.back(), loads.sway.back(), loads.heave.back()},
            simulation.mean_sweeps() * simulation.steps() - before,
            took.count()};
}

struct Errors {
    double off = 0, load = 0, square = 0, elements = 0, sweeps = 0, ms = 0;

    void add(const Step& found, const Step& exact) {
        off += (found.load - exact.load).norm();
        load += exact.load.norm();
        for (std::size_t i = 0; i < exact.elements.size(); ++i)
            square += (found.elements[i].velocity - exact.elements[i].velocity).squaredNorm();
        elements += static_cast<double>(exact.elements.size());
        sweeps += found.sweeps;
        ms += found.ms;
    }
};

void compare(const DefaultScene& scene) {
    const std::vector<double> tolerances{2e-4, 5e-4, 1e-3, 2e-3, 4e-3, 8e-3};
    std::vector<Errors> errors(tolerances.size());
    Simulation simulation = scene.reached();
    for (int i = 0; i < states; ++i) {
        for (int k = 0; k < apart; ++k) simulation.step();
        const Bytes state = simulation.saved();
        const Step exact = step_from(scene, state, 1e-7, 20000);
        for (std::size_t t = 0; t < tolerances.size(); ++t)
            errors[t].add(step_from(scene, state, tolerances[t], 20000), exact);
    }
    for (std::size_t t = 0; t < tolerances.size(); ++t) {
        const Errors& all = errors[t];
        fmt::print("{},{:g},{:.1f},{:.2f},{:.2f},{:.2f}\n", scene.name, 1e3 * tolerances[t], all.sweeps / states,
                   100 * all.off / all.load, 1e3 * std::sqrt(all.square / all.elements), all.ms / states);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        fmt::print("scene,tolerance_mm_s,sweeps,load_error_percent,velocity_error_mm_s,ms\n");
        const std::vector<std::string> named(argv + 1, argv + argc);
        for (const DefaultScene& scene : default_scenes())
            if (named.empty() || std::ranges::find(named, scene.name) != named.end()) compare(scene);
    } catch (const std::exception& error) {
        fmt::print(stderr, "floes_contact_error: {}\n", error.what());
        return 1;
    }
}
