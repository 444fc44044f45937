#include "theory/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "theory/plate.hpp"

namespace floes {

HybridModel::HybridModel(const IceHull& hull, const LevelIce& ice, double concentration, double floe_length,
                         double speed)
    : hull_(hull), ice_(ice), concentration_(concentration), floe_length_(floe_length), speed_(speed) {
    limit_stress(1);  // throws for a hull without a load
}

HybridModel HybridModel::with(const KprCoefficients& coefficients) const {
    HybridModel model = *this;
    model.coefficients_ = coefficients;
    return model;
}

HybridModel HybridModel::crossing_at(double elastic_modulus) const {
    const double unit_load = with({.static_part = 1}).limit_momentum();
    return with({.static_part = limit_stress(elastic_modulus).total() / unit_load});
}

LindqvistLoad HybridModel::limit_stress(double elastic_modulus) const {
    LevelIce ice = ice_;
    ice.elastic_modulus = elastic_modulus;
    const LindqvistLoad level = lindqvist_load(hull_, ice, speed_);
    return {concentration_ * level.crushing, concentration_ * level.bending, concentration_ * level.submergence};
}

double HybridModel::limit_momentum() const {
    return kpr_load(coefficients_, hull_, ice_, floe_length_, speed_).total();
}

double HybridModel::load(double elastic_modulus) const {
    return std::min(limit_stress(elastic_modulus).total(), limit_momentum());
}

std::optional<double> HybridModel::crossing() const {
    const LindqvistLoad soft = limit_stress(1);  // bending at E is that at 1 Pa over √E
    const double excess = limit_momentum() - (soft.crushing + soft.submergence);
    if (!(excess > 0)) return std::nullopt;
    return std::pow(soft.bending / excess, 2);
}

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
