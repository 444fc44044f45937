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
namespace {

constexpr std::size_t no_element = ~std::size_t{0};

}  // namespace

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
        const SingleFloe single{floe.pose, floes.shape(i), floes.material(i)};
        if (cuts[floe.shape])
            add_polygon(world, scenario, single, cuts[floe.shape]);
        else
            add_floe(world, scenario, single, orders[floe.shape]);
    }
}

std::size_t IceField::free_place(const FloeGrid& grid) const {
    const auto fits = [&](const Sheet& sheet) {
        return !sheet.there && !sheet.cut && sheet.grid.elements_long == grid.elements_long &&
               sheet.grid.elements_broad == grid.elements_broad;
    };
    return static_cast<std::size_t>(std::ranges::find_if(floes_, fits) - floes_.begin());
}

void IceField::add_floe(World& world, const Scenario& scenario, const SingleFloe& floe,
                        const std::vector<GridJoint>& order) {
    const FloeShape& shape = floe.shape;
    const Material& material = floe.material;
    const FloeGrid grid = grid_of(shape);
    const Water& water = scenario.water;
    const double pressure = scenario.contact_law(material.ice).crushing_pressure;
    const std::optional<JointSpring> spring = joint_spring(shape, material);
    const std::size_t place = free_place(grid);
    const bool again = place < floes_.size();
    const auto first = again ? static_cast<std::size_t>(floes_[place].first) : elements_.size();
    const std::size_t first_joint = again ? floes_[place].first_joint : joint_ids_.size();
    if (!again) floes_.emplace_back();
    floes_[place] = {static_cast<int>(first), grid, joint_strength(shape, material, shape.element, shape.element),
                     first_joint, entered_++};
    const Turn half = turn_of(0.5 * floe.pose.yaw);
    const Quat yaw(half.cos, 0, half.sin, 0);
    const Vec3 middle(floe.pose.x, shape.floating_height(material.ice, water.density), floe.pose.z);

    const std::uint32_t whole = water.form_drag_on == FormDragOn::outline ? 0U : std::uint32_t{every_edge};
    const double crushing = pressure > 0 ? pressure : material.ice.compressive_strength;
    for (int index = 0; index < grid.elements(); ++index) {
        const std::uint32_t edges = whole != 0 ? whole : grid.outline_edges(index);
        put_element(world, first + static_cast<std::size_t>(index),
                    {BodyId(0), static_cast<int>(place), index, static_cast<int>(first), edges},
                    {.half_extents = Vec3(shape.element, shape.thickness, shape.element) / 2,
                     .mass = shape.element_mass(material.ice) * (1 + water.isotropic_mass()),
                     .pose = {middle + yaw * grid.centre(index), yaw},
                     .piece = static_cast<int>(first),
                     .crushing_pressure = pressure},
                    {shape.element, shape.thickness, material.ice.poisson_ratio, crushing});
    }
    for (std::size_t number = 0; number < order.size(); ++number) {
        const GridJoint& joint = order[number];
        const std::size_t at = first_joint + number;
        put_joint(world, at, joint,
                  {.a = elements_[first + static_cast<std::size_t>(joint.a)].body,
                   .b = elements_[first + static_cast<std::size_t>(joint.b)].body,
                   .pivot = middle + yaw * grid.pivot(joint),
                   .frame = yaw * joint_frame(joint.axis),
                   .cfm = material.joint.cfm,
                   .erp = material.joint.erp,
                   .spring = spring});
        joints_.push_back({joint_ids_[at], static_cast<int>(place), static_cast<int>(number), joint, at});
    }
}

/// At the end, or in place of an element that has left.
void IceField::put_element(World& world, std::size_t at, const IceElement& element, const BoxDefinition& box,
                           const PressedElement& pressed) {
    const bool again = at < elements_.size();
    const BodyId body = again ? elements_[at].body : world.add_element(box);
    if (again) {
        world.put_in(body, box);
        elements_[at] = element;
        elements_[at].body = body;
        if (by_stress_) stress_.put_in(at, pressed);
        return;
    }
    append(element, body);
    if (by_stress_) stress_.add_element(body, pressed);
}

void IceField::append(const IceElement& element, BodyId body) {
    element_of_body_.resize(std::max(element_of_body_.size(), body.index() + 1), no_element);
    element_of_body_[body.index()] = elements_.size();
    elements_.push_back(element);
    elements_.back().body = body;
}

void IceField::put_joint(World& world, std::size_t at, const GridJoint& joint, const JointDefinition& definition) {
    if (at < joint_ids_.size()) {
        world.put_in(joint_ids_[at], definition);
        if (by_stress_) stress_.put_in_joint(at);
        return;
    }
    joint_ids_.push_back(world.add_joint(definition));
    if (by_stress_)
        stress_.add_joint(joint_ids_.back(), *element_of(definition.a), *element_of(definition.b), joint.axis);
}

std::optional<std::size_t> IceField::element_of(BodyId body) const {
    if (body.index() >= element_of_body_.size() || element_of_body_[body.index()] == no_element) return {};
    return element_of_body_[body.index()];
}

int IceField::break_joints(World& world, double time) {
    const std::size_t before = breaks_.size();
    auto kept = joints_.begin();
    if (by_stress_) stress_.read(world);
    for (Joint& joint : joints_) {
        const std::optional<FailureMode> mode = floe_of(joint).rests ? std::nullopt : failing(world, joint);
        if (!mode) {
            *kept++ = joint;
            continue;
        }
        fail(world, joint, {time, number_of(joint.floe), joint.number, *mode});
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
        const JointPlace at = joint_place(joint, before[a]);
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
        const auto joint = std::ranges::find_if(joints_, [&](const Joint& live) {
            return number_of(live.floe) == event.floe && live.number == event.joint;
        });
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
    Sheet& sheet = floes_[static_cast<std::size_t>(joint.floe)];
    sheet.cracked = sheet.broken = true;
    expose_edges(joint);
    breaks_.push_back(event);
}

void IceField::split_broken(World& world, std::size_t first_break) {
    for (const std::size_t joint : failed_) stress_.remove_joint(joint);
    failed_.clear();
    for (std::size_t i = first_break; i < breaks_.size(); ++i) {
        if (i == first_break || breaks_[i].floe != breaks_[i - 1].floe) split_pieces(world, place_of(breaks_[i].floe));
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
