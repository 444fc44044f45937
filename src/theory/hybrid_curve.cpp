#include "theory/hybrid_curve.hpp"

#include <fmt/format.h>

#include <numbers>

#include "core/error.hpp"
#include "core/units.hpp"
#include "theory/plate.hpp"

namespace floes {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

}  // namespace

LevelIce level_ice_of(const Scenario& scenario) {
    return {.thickness = scenario.floe.thickness,
            .bending_strength = scenario.ice.bending_strength,
            .density = scenario.ice.density,
            .water_density = scenario.water.density,
            .gravity = scenario.general.gravity};
}

IceHull hull_of(const Scenario& scenario) {
    const double diameter = 2 * scenario.structure.shape.waterline_radius();
    const double angle = scenario.structure.shape.wall_angle_above_water();
    if (!(angle > 0 && angle < right_angle))
        throw InputError(fmt::format(
            "The hybrid model needs a wall that flares from the waterline upwards; structure.profile_m has one of "
            "{:.4g}° from the horizontal there.",
            angle / unit::degree));
    return {.breadth = diameter,
            .length = diameter,
            .draught = scenario.structure.shape.draught(),
            .stem_angle = angle,
            .entrance_angle = right_angle,
            .friction = scenario.contact.ice_structure_friction};
}

HybridModel hybrid_model(const Scenario& scenario) {
    return {hull_of(scenario), level_ice_of(scenario), scenario.field.concentration, scenario.floe.length,
            scenario.structure.speed};
}

HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli) {
    const FloatingPlate plate{.thickness = scenario.floe.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity};
    HybridCurve curve{hull_of(scenario), model.coefficients(), {}, model.crossing()};
    for (const double modulus : moduli) {
        curve.points.push_back({modulus, plate.characteristic_length(modulus), model.limit_stress(modulus),
                                model.limit_momentum(), model.load(modulus)});
    }
    return curve;
}

}  // namespace floes
