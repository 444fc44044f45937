#include "peer.hpp"

#include <set>

#include "shapes/path.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

WaterModel peer_water(const Scenario& scenario) {
    const double side = scenario.floe.element;
    const double thickness = scenario.floe.thickness;
    return {scenario.water,
            scenario.general.gravity,
            {side, thickness},
            scenario.ice.density * side * side * thickness,
            scenario.structure.shape.waterline_radius(),
            scenario.structure.speed};
}

PeerScene peer_scene(const Scene& scene) {
    PeerScene peer;
    const Scenario scenario = tow_scenario(SolverKind::stock);
    peer.scenario = scenario;
    const Simulation simulation(scenario, floes_at(scenario, scene.poses), scene.state);
    peer.elements = simulation.element_states();
    for (const IceElement& element : simulation.ice().elements()) peer.exposed_edges.push_back(element.exposed_edges);

    std::set<std::pair<int, int>> broken;
    for (const BreakEvent& event : scene.state.breaks) broken.insert({event.floe, event.joint});
    const CutFloe cut = scenario.floe.cut();
    const int along = scenario.floe.elements_long();
    for (int floe = 0; floe < simulation.ice().floes(); ++floe) {
        const int first = floe * static_cast<int>(cut.elements.size());
        for (int number = 0; number < static_cast<int>(cut.joints.size()); ++number) {
            if (broken.contains({floe, number})) continue;
            const CutJoint& joint = cut.joints[static_cast<std::size_t>(number)];
            const auto from = [&](int element) {
                const Corner arm = joint.pivot - cut.elements[static_cast<std::size_t>(element)].centre;
                return Pose{{arm.x, 0, arm.z}, turned_to(joint.normal)};
            };
            peer.joints.push_back({first + joint.a, first + joint.b, from(joint.a), from(joint.b)});
        }
        for (int k = 0; k + 1 < scenario.floe.elements_broad(); ++k) {
            for (int i = 0; i + 1 < along; ++i) {
                const int at = first + i + k * along;
                for (const auto& [a, b] : {std::pair{at, at + along + 1}, std::pair{at + 1, at + along}}) {
                    const auto& elements = simulation.ice().elements();
                    if (elements[static_cast<std::size_t>(a)].piece == elements[static_cast<std::size_t>(b)].piece) {
                        peer.diagonals.emplace_back(a, b);
                    }
                }
            }
        }
    }
    peer.sheets = make_channel(scenario, floes_of(scenario)).sheets;
    peer.structure = scenario.structure.shape.solids();
    peer.structure_x = Tow{scenario.structure.start, scenario.structure.speed}.x(simulation.time());
    peer.friction = material_friction(scenario.contact);
    return peer;
}

}  // namespace floes::bench
