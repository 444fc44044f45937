// floes_contact_error [SCENE …]: what the end of the sweeps leaves unsolved in steps of the default, beside the time
// that it takes, as CSV.
//
// From states of a scene (tests/support/default_scenes.hpp), some steps apart, one step with each tolerance beside the
// same step with sweeps that change nothing any more, or 20,000 of them. The error of the load is the mean of what it
// is off by over the mean load; that of velocities the root of the mean square over elements and steps.
//
// What steps leave unsolved may add up. So from each state go 25 steps with each tolerance, beside 25 with a fiftieth
// of the default's: so few that the runs stay near each other, however chaotic the ice is. Of them the mean load along
// the tow, off by how much, with its 95 % interval over the states.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>
#include <vector>

#include "support/default_scenes.hpp"

namespace {

using namespace floes;

constexpr int states = 30;
constexpr int apart = 10;  // steps
constexpr int together = 25;
constexpr int most_sweeps = 20000;

struct Step {
    std::vector<BodyState> elements;
    Vec3 load;
    double sweeps;
    double ms;
};

Simulation at(const DefaultScene& scene, const Bytes& state, double tolerance) {
    Scenario scenario = scene.scenario();
    scenario.general.tolerance = tolerance;
    scenario.general.iterations = most_sweeps;
    LaidField laid = lay_field(scenario, 1, scene.arrangement);
    Simulation simulation(scenario, laid.floes, std::move(laid.ahead));
    simulation.set(state);
    return simulation;
}

Step step_from(const DefaultScene& scene, const Bytes& state, double tolerance) {
    Simulation simulation = at(scene, state, tolerance);
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

/// Along the tow, N.
double mean_load_from(const DefaultScene& scene, const Bytes& state, double tolerance) {
    Simulation simulation = at(scene, state, tolerance);
    double sum = 0;
    for (int i = 0; i < together; ++i) {
        simulation.step();
        sum += simulation.loads().surge.back();
    }
    return sum / together;
}

struct Errors {
    double off = 0, load = 0, square = 0, elements = 0, sweeps = 0, ms = 0;
    std::vector<double> mean_off{};

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

/// Half the width of the 95 % interval of the mean; normal, since there are many.
double half_width(const std::vector<double>& values, double mean) {
    double square = 0;
    for (const double value : values) square += (value - mean) * (value - mean);
    const auto count = static_cast<double>(values.size());
    return 1.96 * std::sqrt(square / (count - 1) / count);
}

void compare(const DefaultScene& scene) {
    const std::vector<double> tolerances{2e-4, 5e-4, 1e-3, 2e-3, 4e-3, 8e-3};
    std::vector<Errors> errors(tolerances.size());
    double mean_load = 0;
    Simulation simulation = scene.reached();
    for (int i = 0; i < states; ++i) {
        for (int k = 0; k < apart; ++k) simulation.step();
        const Bytes state = simulation.saved();
        const Step exact = step_from(scene, state, 1e-7);
        const double load = mean_load_from(scene, state, 2e-5);
        mean_load += load / states;
        for (std::size_t t = 0; t < tolerances.size(); ++t) {
            errors[t].add(step_from(scene, state, tolerances[t]), exact);
            errors[t].mean_off.push_back(mean_load_from(scene, state, tolerances[t]) - load);
        }
    }
    for (std::size_t t = 0; t < tolerances.size(); ++t) {
        const Errors& all = errors[t];
        const double off = std::reduce(all.mean_off.begin(), all.mean_off.end()) / states;
        fmt::print("{},{:g},{:.1f},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f}\n", scene.name, 1e3 * tolerances[t],
                   all.sweeps / states, 100 * all.off / all.load, 1e3 * std::sqrt(all.square / all.elements),
                   all.ms / states, 100 * off / mean_load, 100 * half_width(all.mean_off, off) / mean_load);
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        fmt::print(
            "scene,tolerance_mm_s,sweeps,load_error_percent,velocity_error_mm_s,ms,mean_load_percent,half_width\n");
        const std::vector<std::string> named(argv + 1, argv + argc);
        for (const DefaultScene& scene : default_scenes())
            if (named.empty() || std::ranges::find(named, scene.name) != named.end()) compare(scene);
    } catch (const std::exception& error) {
        fmt::print(stderr, "floes_contact_error: {}\n", error.what());
        return 1;
    }
}
