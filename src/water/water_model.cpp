#include "water/water_model.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "water/floating_plate.hpp"

namespace floes {

void put_fields(const ElementState& state, double* fields, std::size_t stride) {
    const auto put = [&](const double* values, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) fields[(first + i) * stride] = values[i];
    };
    put(state.position.data(), water_field::position, 3);
    put(state.rotation.data(), water_field::rotation, 9);  // by column, as in Eigen
    put(state.velocity.data(), water_field::velocity, 3);
    put(state.angular_velocity.data(), water_field::angular_velocity, 3);
}

void put_shelter(const ElementState& state, double* fields, std::size_t stride) {
    for (std::uint32_t left = state.exposed_edges; left != 0; left &= left - 1) {
        const auto edge = static_cast<std::size_t>(std::countr_zero(left));
        const EdgeShelter shelter = state.shelter.empty() ? EdgeShelter{} : state.shelter[edge];
        fields[2 * edge * stride] = shelter.open;
        fields[(2 * edge + 1) * stride] = shelter.speed;
    }
}

Wrench wrench_at(const double* fields, std::size_t stride) {
    const auto field = [&](std::size_t f) { return fields[f * stride]; };
    return {{field(0), field(1), field(2)}, {field(3), field(4), field(5)}};
}

std::vector<double> plan_of(const CutElement& element) {
    const std::optional<Corner> half = half_sides_of(element.corners);
    if (half && half->x == half->z) return {};
    std::vector<double> plan{std::sqrt(element.xx / element.area), std::sqrt(element.zz / element.area),
                             element.area / 4};
    for (std::size_t k = 0; k < element.corners.size(); ++k) {
        const Corner middle = 0.5 * (element.corners[k] + after(element.corners, k));
        const Corner normal = outward(element.corners, k);
        plan.insert(plan.end(), {middle.x, middle.z, normal.x, normal.z, edge_length(element.corners, k)});
    }
    return plan;
}

constexpr double rounding = 1e-9;

void follow_structure(WaterFactors& factors, bool flows, const StructureInWater& structure) {
    factors.drifts = true;
    factors.structure_z = structure.z;
    factors.yaw_cos = std::cos(structure.yaw);
    factors.yaw_sin = std::sin(structure.yaw);
    if (!flows) return;
    factors.speed = structure.velocity.x() - factors.current_x;
    factors.speed_across = structure.velocity.y() - factors.current_z;
}

/// plan_side: of the square that the factors are of; side: of a square with the waterplane of the element.
WaterModel::WaterModel(const Water& water, double gravity, double plan_side, ElementShape shape, double mass,
                       double waterline_radius, double speed, const Vec2& wind_stress)
    : flows_(water.flow == WaterFlow::potential) {
    const double gauss_area = plan_side * plan_side / 4;
    const double half_area = 0.5 * water.density * gauss_area;
    const Vec2 current = water.current_velocity();
    const Vec2 through = water.flow == WaterFlow::still ? Vec2::Zero() : Vec2(Vec2(speed, 0) - current);
    const bool by_outline = water.heave_damping_from == WaterFrom::outline;
    factors_ = {.side = plan_side,
                .thickness = shape.thickness,
                .buoyancy = water.density * gravity,
                .form = -0.5 * water.density * water.form_drag,
                .skin = half_area * water.skin_drag,
                .heave = half_area * water.heave_drag,
                .waves_below = by_outline ? shape.thickness * (1 - rounding) : std::numeric_limits<double>::infinity(),
                .radius = waterline_radius,
                .speed = through.x(),
                .drifts = !current.isZero(0) || water.turning != 0 || !wind_stress.isZero(0),
                .structure_z = 0,
                .speed_across = through.y(),
                .current_x = current.x(),
                .current_z = current.y(),
                .turn_cos = std::cos(water.turning),
                .turn_sin = std::sin(water.turning),
                .wind_x = wind_stress.x() * gauss_area,
                .wind_z = wind_stress.y() * gauss_area,
                .ellipses = 0,
                .ellipse = {},
                .yaw_cos = 1,
                .yaw_sin = 0};
    if (by_outline) {
        const double draught = mass / (water.density * shape.side * shape.side);
        damping_ = water_of_piece({{Vec2::Zero()}}, shape.side, draught, {water.density, gravity}).front().damping;
    } else {
        damping_ = 2 * water.heave_damping *
                   std::sqrt(water.density * gravity * shape.side * shape.side * mass * (1 + water.isotropic_mass()));
    }
}

WaterModel::WaterModel(const Water& water, double gravity, const CutElement& element, double thickness, double mass,
                       double waterline_radius, double speed, const Vec2& wind_stress)
    : WaterModel(water, gravity, plan_of(element).empty() ? std::sqrt(element.area) : 2,  // of 4 m², see WaterFactors
                 {std::sqrt(element.area), thickness}, mass, waterline_radius, speed, wind_stress) {
    plan_ = plan_of(element);
    if (!plan_.empty()) factors_.side = 0;
}

void WaterModel::flow_round(std::span<const FlowEllipse> ellipses) {
    factors_.ellipses = 0;
    for (const FlowEllipse& one : ellipses.first(std::min<std::size_t>(ellipses.size(), most_flow_ellipses)))
        factors_.ellipse[factors_.ellipses++] = one;
}

Wrench WaterModel::wrench(const ElementState& state, double structure_x, double damping) const {
    std::array<double, water_field::count> fields;
    std::array<double, 2 * most_corners> shelter{};
    std::array<double, wrench_fields> result;
    const std::int64_t exposed_edges = state.exposed_edges;
    const double linear = damping / 4;
    put_fields(state, fields.data(), 1);
    put_shelter(state, shelter.data(), 1);
    const std::size_t edges = plan_.empty() ? 0 : (plan_.size() - plan_field::first_edge) / plan_field::of_edge;
    water_scalar({fields.data(), &exposed_edges, &linear, result.data(), 1, shelter.data(), plan_.data(), edges},
                 factors_, 1, structure_x);
    return wrench_at(result.data(), 1);
}

}  // namespace floes
