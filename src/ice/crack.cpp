#include "ice/crack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floes {
namespace {

/// A stiffness that differs by less is not worth factorising a piece anew.
constexpr double material = 0.02;

}  // namespace

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
    return to > from ? (work(to) - work(from)) / (to - from) : moment(from);
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

}  // namespace floes
