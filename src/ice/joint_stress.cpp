#include "ice/joint_stress.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace floes {

double ElasticIce::flexural_rigidity() const {
    return elastic_modulus * thickness * thickness * thickness / (12 * (1 - poisson_ratio * poisson_ratio));
}

ElasticIce elastic_ice(const FloeShape& shape, const Material& material) {
    return {material.ice.elastic_modulus, material.ice.poisson_ratio, shape.thickness, material.joint.damping_ratio};
}

JointSpring beam_joint(const ElasticIce& ice, double width, double span) {
    FLOES_EXPECTS(width > 0 && span > 0);
    const double bending = ice.flexural_rigidity() * width / span;
    const double stretching = ice.elastic_modulus * ice.thickness * width / span;
    const double shear_modulus = ice.elastic_modulus / (2 * (1 + ice.poisson_ratio));
    const double square = span * span;
    const double shear_flexibility =
        12 * ice.flexural_rigidity() / (5.0 / 6.0 * shear_modulus * ice.thickness * square);
    return {.force = {stretching, 12 * bending / (square * (1 + shear_flexibility)), stretching},
            .moment = {bending, stretching * width * width / 12, bending},
            .damping_ratio = ice.damping_ratio};
}

std::optional<JointSpring> joint_spring(const FloeShape& shape, const Material& material, double length, double span) {
    if (material.joint.model == JointModel::cfm) return std::nullopt;
    return beam_joint(elastic_ice(shape, material), length, span);
}

JointStrength joint_strength(const FloeShape& shape, const Material& material, double length, double span) {
    FLOES_EXPECTS(length > 0 && span > 0);
    const Ice& ice = material.ice;
    const bool beam = material.joint.model == JointModel::beam;
    return {.thresholds = make_thresholds(length, span, shape.thickness, material),
            .section = {length, shape.thickness, ice.poisson_ratio, ice.bending_strength,
                        ice.tensile_strength > 0 ? ice.tensile_strength : ice.bending_strength},
            .stiffness = beam ? beam_joint(elastic_ice(shape, material), length, span).moment[2] : 0.0,
            .crack_energy = ice.fracture_energy * length * shape.thickness,
            .length_over_span = length / span};
}

namespace {

/// Where it pulls across the joint rather than along its normal, it is another joint's: no direction is farther than 30
/// degrees from the normal of a cell's joint.
Tension principal(double n, double t, double shear) {
    if (n < t) return {n, 1};
    const double half = 0.5 * (n - t);
    const double radius = std::sqrt(half * half + shear * shear);
    return {0.5 * (n + t) + radius, radius > 0 ? std::sqrt(0.5 * (1 + half / radius)) : 1.0};
}

}  // namespace

Tension fibre_tension(const JointLoad& load, const IceSection& section) {
    const double area = section.side * section.thickness;
    const double by_moment = 6 / (area * section.thickness);
    const double nu = section.poisson_ratio;
    const double normal = by_moment * (load.reaction.bending + nu * load.across);
    const double across = by_moment * (load.across + nu * load.reaction.bending);
    const double twist = by_moment * (1 - nu) * load.reaction.torsion;
    const auto in_fibre = [&](double sign, const LocalStress& local) {  // +1 the lower one
        // A torsion about x turns the lower fibre towards -z.
        return principal(load.reaction.axial / area + sign * (normal + local.along),
                         load.pulled_across / area + sign * (across + local.across),
                         load.reaction.shear_in_plane / area + sign * (local.shear - twist));
    };
    const Tension lower = in_fibre(1, load.sagging);
    const Tension upper = in_fibre(-1, load.hogging);
    return lower.stress < upper.stress ? upper : lower;
}

Tension tension_in_plane(const JointLoad& load, const IceSection& section) {
    const double area = section.side * section.thickness;
    const JointReaction& r = load.reaction;
    return principal((r.axial + 6 * std::abs(r.in_plane_bending) / section.side) / area, load.pulled_across / area,
                     r.shear_in_plane / area);
}

bool is_pulled_apart(const JointLoad& load, const IceSection& section) {
    return tension_in_plane(load, section).stress > section.tensile_strength;
}

JointLoad smoothed(const JointLoad& load) {
    return {.reaction = load.reaction, .across = load.across, .pulled_across = load.pulled_across};
}

bool may_fail(const JointReaction& r, double across, double by_contacts, const IceSection& section,
              const Thresholds& thresholds) {
    constexpr double rounding = 1 - 1e-9;
    const double area = section.side * section.thickness;
    const double moments =
        std::abs(r.bending + section.poisson_ratio * across) + (1 - section.poisson_ratio) * std::abs(r.torsion);
    const double pull = std::max(0.0, r.axial) + std::abs(r.shear_in_plane);
    const double fibre = (pull + 6 * moments / section.thickness) / area + by_contacts;
    const double in_plane = (pull + 6 * std::abs(r.in_plane_bending) / section.side) / area;
    const double shear = thresholds.shear * rounding;
    return !(fibre < section.flexural_strength * rounding &&
             r.shear_vertical * r.shear_vertical + r.shear_in_plane * r.shear_in_plane < shear * shear &&
             -r.axial < thresholds.compression * rounding && in_plane < section.tensile_strength * rounding &&
             std::abs(r.torsion) < thresholds.torsion * rounding &&
             std::abs(r.in_plane_bending) < thresholds.in_plane_bending * rounding);
}

Utilisation utilisation(const JointLoad& load, const IceSection& section, const Thresholds& thresholds) {
    Utilisation worst{std::max(0.0, fibre_tension(load, section).stress / section.flexural_strength),
                      FailureMode::bending};
    const auto meet = [&](double share, FailureMode mode) {
        if (share > worst.share) worst = {share, mode};
    };
    const JointReaction& r = load.reaction;
    meet(std::sqrt(r.shear_vertical * r.shear_vertical + r.shear_in_plane * r.shear_in_plane) / thresholds.shear,
         FailureMode::shear);
    meet(-r.axial / thresholds.compression, FailureMode::compression);
    meet(tension_in_plane(load, section).stress / section.tensile_strength, FailureMode::tension);
    meet(std::abs(r.torsion) / thresholds.torsion, FailureMode::torsion);
    meet(std::abs(r.in_plane_bending) / thresholds.in_plane_bending, FailureMode::in_plane_bending);
    return worst;
}

}  // namespace floes
