#include "water/water_model.hpp"

#include <array>
#include <cmath>

#include "water/flow.hpp"

namespace floes {
namespace {

struct EdgeFace {
    int axis;  ///< column of the rotation that is the face's normal
    double sign;
};
constexpr std::array<EdgeFace, 4> edge_faces{{{0, 1.0}, {0, -1.0}, {2, 1.0}, {2, -1.0}}};

void add_force(Wrench& wrench, const Vec3& force, const Vec3& arm) {
    wrench.force += force;
    wrench.moment += arm.cross(force);
}

}  // namespace

struct WaterModel::Columns {
    std::array<SubmergedColumn, 4> at;
};

WaterModel::WaterModel(const Water& water, double gravity, ElementShape shape, double mass, double waterline_radius,
                       double speed)
    : water_(water),
      gravity_(gravity),
      shape_(shape),
      mass_(mass),
      waterline_radius_(waterline_radius),
      speed_(speed),
      gauss_offset_(shape.side / std::sqrt(12.0)),
      gauss_area_(shape.side * shape.side / 4),
      linear_damping_(2 * water.heave_damping *
                      std::sqrt(water.density * gravity * shape.side * shape.side * mass * (1 + water.added_mass)) /
                      4) {}

WaterModel::Columns WaterModel::gauss_columns(const ElementState& state) const {
    const double g = gauss_offset_;
    const double thickness = shape_.thickness;
    return {{submerged_column(state, -g, -g, thickness), submerged_column(state, -g, g, thickness),
             submerged_column(state, g, -g, thickness), submerged_column(state, g, g, thickness)}};
}

Wrench WaterModel::wrench(const ElementState& state, double structure_x) const {
    const Columns columns = gauss_columns(state);
    Wrench total = buoyancy(columns);
    total += drag(state, columns, structure_x);
    return total;
}

Wrench WaterModel::buoyancy(const ElementState& state) const {
    return buoyancy(gauss_columns(state));
}

Wrench WaterModel::drag(const ElementState& state, double structure_x) const {
    return drag(state, gauss_columns(state), structure_x);
}

Wrench WaterModel::buoyancy(const Columns& columns) const {
    Wrench total;
    for (const SubmergedColumn& column : columns.at) {
        add_force(total, {0, water_.density * gravity_ * gauss_area_ * column.length, 0}, column.arm);
    }
    return total;
}

Wrench WaterModel::drag(const ElementState& state, const Columns& columns, double structure_x) const {
    Wrench total = form_drag(state, structure_x);
    const Vec3 normal = state.normal();
    const Vec3 to_lower_face = normal * (normal.y() >= 0 ? -0.5 : 0.5) * shape_.thickness;
    for (const SubmergedColumn& column : columns.at) {
        if (column.length == 0) continue;
        const Vec3 foot = column.arm - normal * normal.dot(column.arm);
        const Vec3 arm = foot + to_lower_face;
        const Vec3 relative = relative_velocity(state, arm, structure_x);
        const double through = relative.dot(normal);
        const Vec3 along = relative - through * normal;
        const double half_area = 0.5 * water_.density * gauss_area_;
        const Vec3 skin = half_area * water_.skin_drag * along.norm() * along;
        const double heave = (half_area * water_.heave_drag * std::abs(through) + linear_damping_) * through;
        add_force(total, skin + heave * normal, arm);
    }
    return total;
}

Wrench WaterModel::form_drag(const ElementState& state, double structure_x) const {
    Wrench total;
    for (std::size_t face = 0; face < edge_faces.size(); ++face) {
        if ((state.exposed_edges >> face & 1u) == 0) continue;
        const auto [axis, sign] = edge_faces[face];
        const double offset = sign * 0.5 * shape_.side;
        const SubmergedColumn column =
            submerged_column(state, axis == 0 ? offset : 0.0, axis == 2 ? offset : 0.0, shape_.thickness);
        if (column.length == 0) continue;
        const Vec3 outward = sign * state.rotation.col(axis);
        const double approach = relative_velocity(state, column.arm, structure_x).dot(outward);
        if (approach >= 0) continue;
        const double area = shape_.side * column.length;
        add_force(total, -0.5 * water_.density * water_.form_drag * area * approach * approach * outward, column.arm);
    }
    return total;
}

Vec3 WaterModel::relative_velocity(const ElementState& state, const Vec3& arm, double structure_x) const {
    const Vec3 place = state.position + arm;
    const Vec2 water = flow_velocity({place.x(), place.z()}, structure_x);
    return Vec3(water.x(), 0, water.y()) - state.velocity_at(arm);
}

Vec2 WaterModel::flow_velocity(const Vec2& place, double structure_x) const {
    if (water_.flow == WaterFlow::still) return Vec2::Zero();
    return potential_flow({place.x() - structure_x, place.y()}, waterline_radius_, speed_);
}

double WaterModel::floating_draught() const {
    return mass_ / (water_.density * shape_.side * shape_.side);
}

WaterFactors WaterModel::factors() const {
    const double half_area = 0.5 * water_.density * gauss_area_;
    return {.half_side = 0.5 * shape_.side,
            .side = shape_.side,
            .thickness = shape_.thickness,
            .gauss_offset = gauss_offset_,
            .buoyancy = water_.density * gravity_ * gauss_area_,
            .form = -0.5 * water_.density * water_.form_drag,
            .skin = half_area * water_.skin_drag,
            .heave = half_area * water_.heave_drag,
            .linear = linear_damping_,
            .radius = waterline_radius_,
            .speed = water_.flow == WaterFlow::still ? 0.0 : speed_};
}

}  // namespace floes
