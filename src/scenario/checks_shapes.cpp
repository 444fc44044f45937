// Contradictions between floes that are polygons and the rest.

#include <fmt/format.h>

#include <string>

#include "core/error.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {

void check_shapes(const Scenario& scenario, Contradictions& found) {
    if (!scenario.shapes.any()) return;
    const std::size_t before = found.size();
    const auto refuse = [&](const std::string& with, const std::string& reason, const std::string& instead) {
        found.push_back({{with, "shapes.kind"},
                         fmt::format("{} is not possible with {}: {}; take {}", given(scenario, "shapes.kind"),
                                     given(scenario, with), reason, instead)});
    };
    const bool voronoi = scenario.shapes.kind == ShapeKind::voronoi;
    if (scenario.joint.model != JointModel::beam)
        refuse("joint.model", "Σ and Γ are fitted to square elements", "joint.model = \"beam\"");
    const ArrangementMethod method = scenario.arrangement.method;  // check_traced() has looked at traced
    if (method == ArrangementMethod::lattice || method == ArrangementMethod::file)
        refuse("arrangement.method",
               voronoi ? "cells of a Voronoi diagram lie where they grew" : "polygons fit on no lattice of rectangles",
               "arrangement.method = \"scattered\" or \"monte_carlo\"");
    if (!scenario.structure.shape.is_of_revolution() && scenario.water.flow == WaterFlow::potential)
        refuse("hull.shape", "the flow round a hull that is none of revolution is computed for square elements only",
               "water.flow = \"still\"");
    if (voronoi && scenario.sizes.law != SizeLaw::one)
        refuse("sizes.law", "the diagram decides the areas",
               "sizes.law = \"one\", shapes.kind = \"polygon\", or another number of shapes.relaxations");
    if (found.size() > before) return;
    try {
        static_cast<void>(floes_of(scenario));
    } catch (const InputError& error) {
        found.push_back({{"shapes.kind", "shapes.relaxations", "field.concentration_percent"}, error.what()});
    }
}

}  // namespace floes
