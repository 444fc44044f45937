// floes_contact_error: how much a number of iterations leaves unsolved, for both solvers, as CSV.
//
// From the stored packed scene some steps with n iterations beside the same steps with so many that more change
// nothing. The error is what the n iterations do to the elements' velocities and to the load on the structure, relative
// to these themselves, as root mean squares over elements and steps. So few steps do not let packed ice forget where it
// began.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <tuple>
#include <vector>

#include "scene.hpp"
#include "simulation/simulation.hpp"

namespace {

using namespace floes;

constexpr int steps = 10;

struct Course {
    std::vector<Vec3> velocities;  // of all elements after each step
    std::vector<Vec3> loads;
};

Course course(SolverKind solver, const bench::Scene& scene, int iterations) {
    Scenario scenario = bench::tow_scenario(solver);
    scenario.contact = with_preset({}, ContactPreset::physical);
    scenario.general.iterations = iterations;
    scenario.general.tolerance = 0;
    Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    Course found;
    for (int i = 0; i < steps; ++i) {
        simulation.step();
        for (const BodyState& state : simulation.element_states()) found.velocities.push_back(state.velocity);
        const LoadHistory& loads = simulation.loads();
        found.loads.emplace_back(loads.surge.back(), loads.sway.back(), loads.heave.back());
    }
    return found;
}

double relative(const std::vector<Vec3>& found, const std::vector<Vec3>& converged) {
    double error = 0;
    double size = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        error += (found[i] - converged[i]).squaredNorm();
        size += converged[i].squaredNorm();
    }
    return std::sqrt(error / size);
}

}  // namespace

int main() {
    fmt::print("solver,iterations,velocity_error,load_error\n");
    const bench::Scene scene = bench::late_scene();
    for (const auto& [name, solver, enough] :
         {std::tuple("lanes", SolverKind::lanes, 5000), std::tuple("direct", SolverKind::direct, 1000)}) {
        const Course converged = course(solver, scene, enough);
        for (const int iterations : {10, 20, 30, 40, 50, 100, 200}) {
            const Course found = course(solver, scene, iterations);
            fmt::print("{},{},{:.5f},{:.5f}\n", name, iterations, relative(found.velocities, converged.velocities),
                       relative(found.loads, converged.loads));
            std::fflush(stdout);
        }
    }
}
