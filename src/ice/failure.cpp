#include "ice/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace floes {

namespace {

double compression(const JointReaction& r) {
    return std::max(0.0, -r.axial);
}

double tension(const JointReaction& r) {
    return std::max(0.0, r.axial);
}

double shear(const JointReaction& r) {
    return std::sqrt(r.shear_vertical * r.shear_vertical + r.shear_in_plane * r.shear_in_plane);
}

/// λ/ε, in the order of FailureMode.
std::array<double, 6> ratios_of(const JointReaction& r, const Thresholds& thresholds) {
    return {std::abs(r.bending + thresholds.bending_arm * r.shear_vertical) / thresholds.bending,
            shear(r) / thresholds.shear,
            compression(r) / thresholds.compression,
            tension(r) / thresholds.tension,
            std::abs(r.torsion) / thresholds.torsion,
            std::abs(r.in_plane_bending) / thresholds.in_plane_bending};
}

}  // namespace

Thresholds make_thresholds(const FloeShape& shape, const Material& material) {
    return make_thresholds(shape.element, shape.element, shape.thickness, material);
}

Thresholds make_thresholds(double side, double span, double thick, const Material& material) {
    const Ice& ice = material.ice;
    const double printed = material.joint.threshold_form == ThresholdForm::as_printed ? thick : 1.0;
    const auto optional = [](double section, double strength) {
        return strength > 0 ? section * strength : std::numeric_limits<double>::infinity();
    };
    return {.bending = side * thick * thick / 6 * ice.bending_strength,
            .shear = side * thick * printed * ice.shear_strength,
            .compression = side * thick * printed * ice.compressive_strength,
            .tension = optional(side * thick, ice.tensile_strength),
            .torsion = optional(side * thick * thick / 3, ice.torsion_strength),
            .in_plane_bending = optional(thick * side * side / 6, ice.in_plane_bending_strength),
            .bending_arm = material.joint.moment_about == MomentAbout::element_centre ? span / 2 : 0};
}

double utilisation(const JointReaction& reaction, const Thresholds& thresholds) {
    return std::ranges::max(ratios_of(reaction, thresholds));
}

std::optional<FailureMode> failure(const JointReaction& reaction, const Thresholds& thresholds) {
    const std::array<double, 6> ratios = ratios_of(reaction, thresholds);
    const auto largest = std::max_element(ratios.begin(), ratios.end());
    if (!(*largest > 1)) return std::nullopt;
    return static_cast<FailureMode>(largest - ratios.begin());
}

JointReaction without_bending(const JointReaction& reaction) {
    return {.axial = reaction.axial,
            .shear_vertical = reaction.shear_vertical,
            .shear_in_plane = reaction.shear_in_plane,
            .torsion = reaction.torsion,
            .in_plane_bending = reaction.in_plane_bending};
}

PeakReactions raised(const PeakReactions& peaks, const JointReaction& r) {
    return {.compression = std::max(peaks.compression, compression(r)),
            .tension = std::max(peaks.tension, tension(r)),
            .shear = std::max(peaks.shear, shear(r)),
            .bending = std::max(peaks.bending, std::abs(r.bending)),
            .torsion = std::max(peaks.torsion, std::abs(r.torsion)),
            .in_plane_bending = std::max(peaks.in_plane_bending, std::abs(r.in_plane_bending))};
}

}  // namespace floes
