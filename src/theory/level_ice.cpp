#include "theory/level_ice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "theory/plate.hpp"

namespace floes {

KprLoad kpr_load(const KprCoefficients& coefficients, const IceHull& hull, const LevelIce& ice, double floe_length,
                 double speed) {
    constexpr double fullness = std::numbers::pi / 4;
    constexpr double entrance_tangent = 1;  // 45 degrees
    const double half_breadth = hull.breadth / 2;
    const double weight = ice.density * ice.gravity * floe_length * ice.thickness;  // per m of breadth, N/m
    const double froude = speed / std::sqrt(ice.gravity * hull.length);
    return {coefficients.static_part * ice.density * ice.gravity * std::sqrt(floe_length * ice.thickness) *
                half_breadth * half_breadth * (1 + 2 * hull.friction * fullness * hull.length / hull.breadth),
            coefficients.dissipative * weight * hull.breadth * (hull.friction + fullness * entrance_tangent) * froude,
            coefficients.impact * weight * hull.length * entrance_tangent * entrance_tangent * froude * froude};
}

namespace {

double crushing(const IceHull& hull, const LevelIce& ice) {
    const double phi = hull.stem_angle;
    const double cos_psi = std::cos(hull.normal_angle());
    const double push = std::tan(phi) + hull.friction * std::cos(phi) / cos_psi;
    const double slide = 1 - hull.friction * std::sin(phi) / cos_psi;
    return 0.5 * ice.bending_strength * ice.thickness * ice.thickness * push / slide;
}

double bending(const IceHull& hull, const LevelIce& ice) {
    const double psi = hull.normal_angle();
    const double nu = ice.poisson_ratio;
    const double stiffness =
        ice.elastic_modulus / (12 * (1 - nu * nu) * ice.gravity * ice.water_density);  // lc⁴ / h³, m
    const double push =
        std::tan(psi) + hull.friction * std::cos(hull.stem_angle) / (std::sin(hull.entrance_angle) * std::cos(psi));
    return 27.0 / 64.0 * ice.bending_strength * hull.breadth * std::pow(ice.thickness, 1.5) / std::sqrt(stiffness) *
           push * (1 + 1 / std::cos(psi));
}

double submergence(const IceHull& hull, const LevelIce& ice) {
    const double b = hull.breadth;
    const double t = hull.draught;
    const double sin_phi = std::sin(hull.stem_angle);
    const double cot_alpha = std::cos(hull.entrance_angle) / std::sin(hull.entrance_angle);
    const double covered = 0.7 * hull.length - t / std::tan(hull.stem_angle) - b * cot_alpha / 4 +
                           t * std::cos(hull.stem_angle) * std::cos(hull.normal_angle()) *
                               std::sqrt(1 / (sin_phi * sin_phi) + cot_alpha * cot_alpha);
    return (ice.water_density - ice.density) * ice.gravity * ice.thickness * b *
           (t * (b + t) / (b + 2 * t) + hull.friction * covered);
}

}  // namespace

double IceHull::normal_angle() const {
    return std::atan(std::tan(stem_angle) / std::sin(entrance_angle));
}

LindqvistLoad lindqvist_load(const IceHull& hull, const LevelIce& ice, double speed) {
    FLOES_EXPECTS(ice.thickness > 0 && speed >= 0);
    if (!(hull.friction * std::sin(hull.stem_angle) < std::cos(hull.normal_angle())))
        throw InputError(
            fmt::format("Lindqvist's formula has no load for a wall of {:.4g}° from the horizontal and friction {:g}: "
                        "ice jams on it and does not bend; it needs a smaller angle or less friction.",
                        hull.stem_angle * 180 / std::numbers::pi, hull.friction));
    const double breaking = 1 + 1.4 * speed / std::sqrt(ice.gravity * ice.thickness);
    const double sliding = 1 + 9.4 * speed / std::sqrt(ice.gravity * hull.length);
    return {crushing(hull, ice) * breaking, bending(hull, ice) * breaking, submergence(hull, ice) * sliding};
}

namespace {

/// The quantities that several parts share.
struct Slope {
    double width;         ///< w, m
    double sine, cosine;  ///< of α
    double friction;      ///< μ
    double push;          ///< ξ
    double pile;          ///< r
    double weight;        ///< q, N/m³
    double cotangents;    ///< cot θ - cot α
};

Slope slope_of(const IceHull& hull, const LevelIce& ice, const Rubble& rubble) {
    const double sine = std::sin(hull.stem_angle);
    const double cosine = std::cos(hull.stem_angle);
    const double mu = hull.friction;
    if (!(cosine > mu * sine && sine > mu * cosine))
        throw InputError(fmt::format(
            "ISO's formula has no load for a wall of {:.4g}° from the horizontal and friction {:g}: ice does "
            "not slide on it; it needs another angle or less friction.",
            hull.stem_angle / unit::degree, mu));
    return {.width = hull.breadth,
            .sine = sine,
            .cosine = cosine,
            .friction = mu,
            .push = (sine + mu * cosine) / (cosine - mu * sine),
            .pile = 1 - std::tan(rubble.angle) / std::tan(hull.stem_angle),
            .weight = ice.density * ice.gravity * (1 - rubble.porosity),
            .cotangents = 1 / std::tan(rubble.angle) - cosine / sine};
}

double ride_up(const Slope& slope, const LevelIce& ice, const Rubble& rubble) {
    const double below =
        0.5 * (rubble.ice_friction + slope.friction) * slope.weight * rubble.height * rubble.height * slope.pile *
        (rubble.ice_friction * slope.sine * slope.cotangents + slope.cosine * slope.cosine / slope.sine);
    const double blocks = rubble.height * ice.thickness * ice.density * ice.gravity *
                          (slope.sine + slope.friction * slope.cosine) / slope.sine;
    return slope.width * (below + blocks) / (slope.cosine - slope.friction * slope.sine);
}

}  // namespace

void check_rubble(const Rubble& rubble, double wall_angle) {
    const auto refuse = [](const std::string& what) { throw InputError("Rubble on the wall: " + what); };
    if (!(rubble.height >= 0)) refuse(fmt::format("its height of {:g} m has to be 0 or more.", rubble.height));
    if (!(rubble.porosity >= 0 && rubble.porosity < 1))
        refuse(fmt::format("its porosity of {:g} has to be 0 or more, and below 1.", rubble.porosity));
    if (!(rubble.angle > 0 && rubble.angle <= wall_angle))
        refuse(fmt::format("its angle of {:.4g}° has to be above 0 and not above the wall's, {:.4g}°.",
                           rubble.angle / unit::degree, wall_angle / unit::degree));
    if (!(rubble.friction_angle >= 0 && rubble.friction_angle < std::numbers::pi / 2))
        refuse(fmt::format("its friction angle of {:.4g}° has to be 0 or more, and below 90°.",
                           rubble.friction_angle / unit::degree));
    if (!(rubble.cohesion >= 0)) refuse(fmt::format("its cohesion of {:g} Pa has to be 0 or more.", rubble.cohesion));
    if (!(rubble.ice_friction >= 0))
        refuse(fmt::format("the friction of ice on ice, {:g}, has to be 0 or more.", rubble.ice_friction));
}

SlopingLoad sloping_load(const IceHull& hull, const LevelIce& ice, const Rubble& rubble) {
    check_rubble(rubble, hull.stem_angle);
    const Slope slope = slope_of(hull, ice, rubble);
    const double h = ice.thickness;
    const double liquid = ice.water_density * ice.gravity;
    const double length =
        std::pow(ice.elastic_modulus * h * h * h / (12 * liquid * (1 - ice.poisson_ratio * ice.poisson_ratio)), 0.25);
    const double crack = hull.breadth + std::numbers::pi * std::numbers::pi * length / 4;
    const double height = rubble.height;
    SlopingLoad load;
    load.breaking = 0.68 * slope.push * ice.bending_strength *
                    std::pow(liquid * std::pow(h, 5) / ice.elastic_modulus, 0.25) * crack;
    load.pushing = hull.breadth * height * height * rubble.ice_friction * slope.weight * slope.pile * slope.pile /
                   (2 * std::tan(rubble.angle));
    load.lifting = hull.breadth * height * slope.push * slope.pile *
                   (0.5 * height * slope.weight * (slope.cotangents + slope.pile * std::tan(rubble.friction_angle)) +
                    rubble.cohesion);
    load.ride_up = ride_up(slope, ice, rubble);
    load.turning = 1.5 * hull.breadth * h * h * ice.density * ice.gravity * slope.cosine /
                   (slope.sine - slope.friction * slope.cosine);
    const double left = 1 - load.breaking / (ice.bending_strength * crack * h);
    if (!(left > 0))
        throw InputError(fmt::format(
            "ISO's formula has no load for ice of {:g} m and {:.4g} MPa on a wall of {:.4g}°: the sheet would "
            "buckle or crush before it breaks by bending; it needs stiffer ice or a smaller angle.",
            h, ice.elastic_modulus / unit::megapascal, hull.stem_angle / unit::degree));
    load.thrust = 1 / left;
    return load;
}

double crushing_load(double breadth, double thickness, double strength) {
    FLOES_EXPECTS(breadth >= 0 && thickness >= 0 && strength >= 0);
    constexpr double metre = 1;
    const double n = std::min(-0.3, -0.5 + thickness / (5 * metre));
    return strength * std::pow(thickness / metre, n) * std::pow(breadth / thickness, -0.16) * breadth * thickness;
}

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

constexpr double right_angle = std::numbers::pi / 2;

LevelIce level_ice_of(const Scenario& scenario) {
    return {.thickness = scenario.floe.thickness,
            .bending_strength = scenario.mean_ice().bending_strength,
            .density = scenario.ice.density,
            .water_density = scenario.water.density,
            .poisson_ratio = scenario.ice.poisson_ratio,
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
            scenario.drift()};
}

HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli) {
    const FloatingPlate plate{.thickness = scenario.floe.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity,
                              .poisson_ratio = scenario.ice.poisson_ratio};
    HybridCurve curve{hull_of(scenario), model.coefficients(), {}, model.crossing()};
    for (const double modulus : moduli) {
        curve.points.push_back({modulus, plate.characteristic_length(modulus), model.limit_stress(modulus),
                                model.limit_momentum(), model.load(modulus)});
    }
    return curve;
}

}  // namespace floes
