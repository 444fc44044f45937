#pragma once
// One lane of the body arrays, for scalar code: what contacts need of a body.

#include <array>
#include <cstddef>
#include <cstdint>

#include "solver/lane_layout.hpp"

namespace floes {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(const Vector& a, double s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// One lane of the body arrays.
class BodyLane {
  public:
    BodyLane(const LaneArrays& arrays, std::uint32_t slot, int width)
        : body_(arrays.body + group(slot, width) * static_cast<std::size_t>(body_field::count * width) +
                lane(slot, width)),
          sweep_(arrays.sweep + group(slot, width) * static_cast<std::size_t>(sweep_field::count * width) +
                 lane(slot, width)),
          width_(width) {}

    double inverse_mass() const { return sweep_[sweep_field::inverse_mass * width_]; }
    Vector position() const { return vector(body_, body_field::position); }
    Vector spin() const { return vector(body_, body_field::spin); }
    Vector start_velocity() const { return vector(body_, body_field::start_velocity); }
    Vector start_spin() const { return vector(body_, body_field::start_spin); }

    Vector inertia_response(const Vector& torque) const {
        const Vector top = vector(sweep_, sweep_field::inverse_inertia);
        const Vector rest = vector(sweep_, sweep_field::inverse_inertia + 3);
        return {dot(top, torque), top[1] * torque[0] + rest[0] * torque[1] + rest[1] * torque[2],
                top[2] * torque[0] + rest[1] * torque[1] + rest[2] * torque[2]};
    }

  private:
    static std::size_t group(std::uint32_t slot, int width) { return slot / static_cast<std::uint32_t>(width); }
    static std::size_t lane(std::uint32_t slot, int width) { return slot % static_cast<std::uint32_t>(width); }
    Vector vector(const double* p, int field) const {
        return {p[field * width_], p[(field + 1) * width_], p[(field + 2) * width_]};
    }

    const double* body_;
    const double* sweep_;
    int width_;
};

}  // namespace floes
