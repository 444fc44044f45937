#include "drift.hpp"

#include <cmath>
#include <numbers>

#include "scene.hpp"

namespace floes::bench {

Simulation make_drift(int floes, bool by_default) {
    Scenario scenario = by_default ? Scenario{} : tow_scenario(SolverKind::lanes);
    scenario.field.floes = floes;
    scenario.field.concentration = 0.75;
    const double cell = scenario.floe.length / std::sqrt(scenario.field.concentration);
    const int across = std::max(1, static_cast<int>(std::lround(std::sqrt(floes))));
    scenario.field.half_width = 0.5 * cell * across;
    scenario.field.far_end = FarEnd::open;  // the last row may be a part of one

    FloeSet set = floes_of(scenario, {.seed = 1});
    for (int i = 0; i < floes; ++i)
        set.floes[static_cast<std::size_t>(i)].pose = {.x = scenario.field.begin + cell * (i / across + 0.5),
                                                       .z = cell * (i % across + 0.5) - scenario.field.half_width};
    const Simulation at_rest(scenario, set);
    SimulationState state = at_rest.state();
    for (std::size_t i = 0; i < state.elements.size(); ++i) {
        // Directions spread evenly by the golden ratio.
        const double angle = 2 * std::numbers::pi * std::fmod(at_rest.ice().elements()[i].floe * 0.6180339887, 1.0);
        state.elements[i].velocity = 0.1 * Vec3(std::cos(angle), 0, std::sin(angle));
    }
    return Simulation(scenario, set, state);
}

}  // namespace floes::bench
