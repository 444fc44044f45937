#pragma once
// A strip of level ice, held at its far end, that is lifted and broken on a plane slope wider than it.

#include <cmath>
#include <numbers>
#include <vector>

#include "scenario/scenario.hpp"
#include "theory/plate.hpp"

namespace floes::test {

/// A wall that leans away from the ice by `angle` (rad from the horizontal) and lifts it; its axis is where it leaves
/// the water. Corners by height, `reach` m below and above the water.
inline Shape slope(double angle, double breadth, double reach) {
    const double run = reach / std::tan(angle);
    std::vector<std::vector<double>> rows;
    for (const double z : {-breadth / 2, breadth / 2})
        for (const auto& [x, height] : {std::pair(run, -reach), {-run, reach}, {-run - 1, reach}, {-run - 1, -reach}})
            rows.push_back({0, 0, x, height, z});
    Shape shape;
    shape.part_list() = "wall";
    shape.set_pieces(rows);
    shape.set_kind(HullKind::file);
    return shape;
}

/// The paper's ice, L_c = 0.38 m, as a strip of `length` L_c and eight elements' breadth. The wall touches it at once.
inline Scenario level_strip(double angle, double element_over_length, double length = 8) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::level;
    scenario.field.floes = 1;
    scenario.field.concentration = 1;
    scenario.field.begin = 0;
    scenario.field.sides = FieldSides::open;
    const FloatingPlate plate{scenario.floe.thickness};
    const double characteristic = plate.characteristic_length(scenario.ice.elastic_modulus);
    scenario.floe.element = element_over_length * characteristic;
    scenario.floe.length = length * characteristic;
    scenario.floe.breadth = 8 * scenario.floe.element;
    scenario.field.half_width = scenario.floe.breadth / 2 + 0.5;
    scenario.structure.shape = slope(angle, scenario.floe.breadth + 0.5, 0.3);
    const double draught = scenario.floe.thickness * scenario.ice.density / scenario.water.density;
    scenario.structure.start = -draught / std::tan(angle) - 0.001;
    scenario.structure.speed = 0.005;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 9.96;
    return scenario;
}

}  // namespace floes::test
