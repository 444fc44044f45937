#include "ice/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/state_archive.hpp"

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

/// A stiffness that differs by less is not worth factorising a piece anew.
constexpr double material = 0.02;

double CohesiveLaw::moment(double rotation) const {
    if (rotation <= peak_rotation) return stiffness * rotation;
    if (rotation >= open_rotation) return 0;
    return stiffness * peak_rotation * (open_rotation - rotation) / (open_rotation - peak_rotation);
}

double CohesiveLaw::work(double rotation) const {
    const double rising = 0.5 * stiffness * std::min(rotation, peak_rotation) * std::min(rotation, peak_rotation);
    if (rotation <= peak_rotation) return rising;
    const double to = std::min(rotation, open_rotation);
    return rising + 0.5 * (stiffness * peak_rotation + moment(to)) * (to - peak_rotation);
}

double CohesiveLaw::mean_moment(double from, double to) const {
    const double done = work(to) - work(from);
    constexpr double hardly = 1e-9;  // works that differ by less differ by their rounding
    return done > hardly * work(to) ? done / (to - from) : moment(from);
}

double cracking(double strength, double smooth, double stiffness, double rotation, double energy,
                double length_over_span) {
    const double given_over_own = 1 + 2 * length_over_span;
    const double released = 0.5 * given_over_own * stiffness * rotation * rotation;
    const double enough = energy > 0 ? std::sqrt(released / energy) : std::numeric_limits<double>::infinity();
    return std::min(strength, std::max(smooth, enough));
}

CohesiveLaw cohesive_law(double stiffness, double peak_rotation, double energy) {
    const double peak = stiffness * peak_rotation;
    return {stiffness, peak_rotation, peak > 0 ? 2 * energy / peak : std::numeric_limits<double>::infinity()};
}

void Crack::follow(double rotation, double rate, double time_step) {
    const double stored = 0.5 * law_.stiffness * rotation * rotation;
    if (rotation >= law_.open_rotation || law_.snaps_back()) {
        open_ = true;
        energy_ += sound_ * stored;
        sound_ = 0;
        return;
    }
    const double expected = rotation + std::max(0.0, rate * time_step);
    if (!(expected > law_.peak_rotation)) return;
    const double sound = law_.mean_moment(rotation, expected) / (law_.stiffness * expected);
    if (sound >= (1 - material) * sound_) return;
    energy_ += (sound_ - sound) * stored;
    sound_ = sound;
}

void Crack::archive(StateArchive& state) {
    auto& [law, left, taken, open] = *this;
    state(law, left, taken, open);
}

}  // namespace floes
