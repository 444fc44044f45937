#include "ice/ice_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/components.hpp"
#include "core/error.hpp"
#include "core/turn.hpp"
#include "ice/beam_joint.hpp"
#include "ice/polygon_floe.hpp"
#include "ice/scenario_world.hpp"

namespace floes {

IceField::IceField(World& world, const Scenario& scenario, const FloeSet& floes)
    : by_stress_(scenario.joint.fails_by_stress()), time_step_(scenario.general.time_step) {
    std::vector<std::vector<GridJoint>> orders;
    std::vector<std::shared_ptr<const CutFloe>> cuts;
    for (const FloeShape& shape : floes.shapes) {
        cuts.push_back(cut_of(shape));
        orders.push_back(cuts.back() ? std::vector<GridJoint>(cuts.back()->joints.size())
                                     : joint_order(grid_of(shape)));
    }
    std::size_t elements = 0;
    std::size_t joints = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        elements += static_cast<std::size_t>(floes.shape(i).elements());
        joints += orders[floes.floes[i].shape].size();
    }
    elements_.reserve(elements);
    joints_.reserve(joints);
    if (by_stress_) stress_.reserve(elements);
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const Floe& floe = floes.floes[i];
        if (cuts[floe.shape])
            add_polygon(world, scenario, floe, floes.shape(i), floes.material(i), cuts[floe.shape]);
        else
            add_floe(world, scenario, floe.pose, floes.shape(i), floes.material(i), orders[floe.shape]);
    }
}

void IceField::add_floe(World& world, const Scenario& scenario, const PlanarPose& pose, const FloeShape& shape,
                        const Material& material, const std::vector<GridJoint>& order) {
    const FloeGrid grid = grid_of(shape);
    const Water& water = scenario.water;
    const double pressure = scenario.contact_law(material.ice).crushing_pressure;
    const std::optional<JointSpring> spring = joint_spring(shape, material);
    const int floe = floes();
    const int first = static_cast<int>(elements_.size());
    floes_.push_back({first, grid, make_thresholds(shape, material), ice_section(shape, material),
                      spring ? spring->moment[2] : 0.0,
                      material.ice.fracture_energy * shape.element * shape.thickness});
    const Turn half = turn_of(0.5 * pose.yaw);
    const Quat yaw(half.cos, 0, half.sin, 0);
    const Vec3 middle(pose.x, shape.floating_height(material.ice, water.density), pose.z);

    for (int index = 0; index < grid.elements(); ++index) {
        const BodyId body = world.add_element({.half_extents = Vec3(shape.element, shape.thickness, shape.element) / 2,
                                               .mass = shape.element_mass(material.ice) * (1 + water.isotropic_mass()),
                                               .pose = {middle + yaw * grid.centre(index), yaw},
                                               .piece = first,
                                               .crushing_pressure = pressure});
        const bool outline = water.form_drag_on == FormDragOn::outline;
        const std::uint32_t edges = outline ? grid.outline_edges(index) : std::uint32_t{every_edge};
        elements_.push_back({body, floe, index, first, edges});
        if (by_stress_) {
            const double crushing = pressure > 0 ? pressure : material.ice.compressive_strength;
            stress_.add_element(body, {shape.element, shape.thickness, material.ice.poisson_ratio, crushing});
        }
    }
    for (int number = 0; number < static_cast<int>(order.size()); ++number) {
        const GridJoint& joint = order[static_cast<std::size_t>(number)];
        const JointId id = world.add_joint({.a = elements_[static_cast<std::size_t>(first + joint.a)].body,
                                            .b = elements_[static_cast<std::size_t>(first + joint.b)].body,
                                            .pivot = middle + yaw * grid.pivot(joint),
                                            .frame = yaw * joint_frame(joint.axis),
                                            .cfm = material.joint.cfm,
                                            .erp = material.joint.erp,
                                            .spring = spring});
        if (by_stress_) {
            stress_.add_joint(id, static_cast<std::size_t>(first + joint.a), static_cast<std::size_t>(first + joint.b),
                              joint.axis);
        }
        joints_.push_back({id, floe, number, joint, joints_.size()});
    }
}

int IceField::break_joints(World& world, double time) {
    const std::size_t before = breaks_.size();
    auto kept = joints_.begin();
    if (by_stress_) stress_.read(world);
    for (Joint& joint : joints_) {
        const std::optional<FailureMode> mode = failing(world, joint);
        if (!mode) {
            *kept++ = joint;
            continue;
        }
        fail(world, joint, {time, joint.floe, joint.number, *mode});
    }
    joints_.erase(kept, joints_.end());
    split_broken(world, before);
    return static_cast<int>(breaks_.size() - before);
}

double IceField::joint_power(const World& world, std::span<const BodyState> before, std::span<const Vec3> velocity,
                             std::span<const Vec3> angular_velocity) const {
    double sum = 0;
    for (const Joint& joint : joints_) {
        const Sheet& sheet = floe_of(joint);
        const auto a = static_cast<std::size_t>(sheet.first + joint.grid.a);
        const auto b = static_cast<std::size_t>(sheet.first + joint.grid.b);
        const JointReaction reaction = world.reaction(joint.id);
        const JointPlace at = place_of(joint, before[a]);
        const Mat3& frame = at.axes;
        const Vec3 force = frame * Vec3(reaction.axial, reaction.shear_vertical, reaction.shear_in_plane);
        const Vec3 moment = frame * Vec3(reaction.torsion, reaction.in_plane_bending, reaction.bending);
        const Vec3& pivot = at.pivot;
        const Vec3 at_a = velocity[a] + angular_velocity[a].cross(pivot - before[a].position);
        const Vec3 at_b = velocity[b] + angular_velocity[b].cross(pivot - before[b].position);
        sum += force.dot(at_a - at_b) + moment.dot(angular_velocity[a] - angular_velocity[b]);
    }
    return sum;
}

void IceField::repeat_breaks(World& world, std::span<const BreakEvent> breaks) {
    const std::size_t before = breaks_.size();
    for (const BreakEvent& event : breaks) {
        const auto joint = std::ranges::find_if(
            joints_, [&](const Joint& live) { return live.floe == event.floe && live.number == event.joint; });
        if (joint == joints_.end()) {
            throw InputError(fmt::format("Joint {} of floe {} cannot break at t = {:.2f} s: there is no such joint.",
                                         event.joint, event.floe, event.time));
        }
        fail(world, *joint, event);
        joints_.erase(joint);
    }
    split_broken(world, before);
}

void IceField::fail(World& world, const Joint& joint, const BreakEvent& event) {
    world.remove_joint(joint.id);
    if (by_stress_) failed_.push_back(joint.place);
    floes_[static_cast<std::size_t>(joint.floe)].cracked = true;
    expose_edges(joint);
    breaks_.push_back(event);
}

void IceField::split_broken(World& world, std::size_t first_break) {
    for (const std::size_t joint : failed_) stress_.remove_joint(joint);
    failed_.clear();
    for (std::size_t i = first_break; i < breaks_.size(); ++i) {
        if (i == first_break || breaks_[i].floe != breaks_[i - 1].floe) split_pieces(world, breaks_[i].floe);
    }
}

void IceField::expose_edges(const Joint& joint) {
    const int first = floe_of(joint).first;
    if (const CutFloe* polygon = floe_of(joint).cut.get()) {
        const CutJoint& cut = polygon->joints[static_cast<std::size_t>(joint.number)];
        elements_[static_cast<std::size_t>(first + joint.grid.a)].exposed_edges |= cut.edge_a;
        elements_[static_cast<std::size_t>(first + joint.grid.b)].exposed_edges |= cut.edge_b;
        return;
    }
    const bool along = joint.grid.axis == JointAxis::x;
    elements_[static_cast<std::size_t>(first + joint.grid.a)].exposed_edges |= along ? edge_plus_x : edge_plus_z;
    elements_[static_cast<std::size_t>(first + joint.grid.b)].exposed_edges |= along ? edge_minus_x : edge_minus_z;
}

void IceField::split_pieces(World& world, int floe) {
    const Sheet& sheet = floes_[static_cast<std::size_t>(floe)];
    const auto first = static_cast<std::size_t>(sheet.first);
    const auto count = static_cast<std::size_t>(sheet.elements());
    Components pieces(count);
    for (const Joint& joint : joints_) {
        if (joint.floe != floe) continue;
        pieces.connect(static_cast<std::size_t>(joint.grid.a), static_cast<std::size_t>(joint.grid.b));
    }
    for (std::size_t index = 0; index < count; ++index) {
        IceElement& element = elements_[first + index];
        const auto piece = static_cast<int>(first + pieces.first(index));
        if (piece == element.piece) continue;
        element.piece = piece;
        world.set_piece(element.body, piece);
    }
}

}  // namespace floes
