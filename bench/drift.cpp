#include "drift.hpp"

#include <cmath>
#include <numbers>

#include "scene.hpp"

namespace floes::bench {

Simulation make_drift(const Drift& drift) {
    Scenario scenario = paper_scenario();
    scenario.contact = {};  // the paper's laws, which Bullet's own solver has, too
    choose_solver(scenario, drift.solver);
    if (drift.solver == SolverKind::direct) scenario.contact = with_preset({}, ContactPreset::physical);
    scenario.floe.length = scenario.floe.breadth = drift.elements_along * scenario.floe.element;
    scenario.field.floes = drift.floes;
    scenario.field.concentration = drift.concentration;
    const double cell = scenario.floe.length / std::sqrt(drift.concentration);
    const int across = std::max(1, static_cast<int>(std::lround(std::sqrt(drift.floes))));
    scenario.field.half_width = 0.5 * cell * across;
    scenario.field.far_end = FarEnd::open;  // the last row may be a part of one

    std::vector<PlanarPose> poses;
    for (int i = 0; i < drift.floes; ++i) {
        poses.push_back({.x = scenario.field.begin + cell * (i / across + 0.5),
                         .z = cell * (i % across + 0.5) - scenario.field.half_width});
    }
    if (drift.hexagons) {
        scenario.shapes.kind = ShapeKind::polygon;
        scenario.shapes.corners = 6;
        scenario.shapes.irregularity = 0;
    }
    FloeSet floes = floes_of(scenario, {.seed = 1});
    for (std::size_t i = 0; i < poses.size(); ++i) floes.floes[i].pose = poses[i];
    SimulationState state = Simulation(scenario, floes).state();
    const std::size_t elements = state.elements.size() / floes.size();
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
        // Directions spread evenly by the golden ratio.
        const double angle = 2 * std::numbers::pi * std::fmod(static_cast<double>(i / elements) * 0.6180339887, 1.0);
        state.elements[i].velocity = {drift.speed * std::cos(angle), 0, drift.speed * std::sin(angle)};
    }
    return Simulation(scenario, floes, state);
}

}  // namespace floes::bench
