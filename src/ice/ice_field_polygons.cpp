// Floes of an IceField that are polygons.

#include <algorithm>

#include "core/turn.hpp"
#include "ice/ice_field.hpp"
#include "ice/polygon_floe.hpp"

namespace floes {
namespace {

Vec3 flat(const Corner& point) {
    return {point.x, 0, point.z};
}

}  // namespace

/// Of as many elements, in whatever outline.
std::size_t IceField::free_place(const CutFloe& cut) const {
    const auto fits = [&](const Sheet& sheet) {
        return !sheet.there && sheet.cut && sheet.cut->elements.size() == cut.elements.size();
    };
    return static_cast<std::size_t>(std::ranges::find_if(floes_, fits) - floes_.begin());
}

void IceField::put_element(World& world, std::size_t at, const IceElement& element, const PrismDefinition& prism) {
    if (at >= elements_.size()) return append(element, world.add_prism(prism));
    const BodyId body = elements_[at].body;
    world.put_in(body, prism);
    elements_[at] = element;
    elements_[at].body = body;
}

/// Under a free id or a new one; which of those ever made it is. Joints of a floe have rising ids if they are free, so
/// that they are solved in their order, as if new.
std::size_t IceField::put_joint(World& world, const JointDefinition& definition) {
    if (free_joints_.empty()) {
        joint_ids_.push_back(world.add_joint(definition));
        return joint_ids_.size() - 1;
    }
    const std::size_t at = free_joints_.back();
    free_joints_.pop_back();
    world.put_in(joint_ids_[at], definition);
    return at;
}

void IceField::add_polygon(World& world, const Scenario& scenario, const SingleFloe& floe,
                           const std::shared_ptr<const CutFloe>& cut) {
    const FloeShape& shape = floe.shape;
    const Material& material = floe.material;
    const Water& water = scenario.water;
    const double pressure = scenario.contact_law(material.ice).crushing_pressure;
    const double per_area = material.ice.density * shape.thickness * (1 + water.isotropic_mass());
    const std::size_t free = free_place(*cut);
    const bool again = free < floes_.size();
    const int place = static_cast<int>(free);
    const int first = again ? floes_[free].first : static_cast<int>(elements_.size());
    if (!again) floes_.emplace_back();
    Sheet& sheet = floes_[free] = {first, {}, {}, joint_ids_.size(), entered_++};
    sheet.cut = cut;
    const Turn half = turn_of(0.5 * floe.pose.yaw);
    const Quat yaw(half.cos, 0, half.sin, 0);
    const Vec3 middle(floe.pose.x, shape.floating_height(material.ice, water.density), floe.pose.z);
    const bool on_all = water.form_drag_on == FormDragOn::every_element;
    for (int index = 0; index < sheet.elements(); ++index) {
        const CutElement& one = cut->elements[static_cast<std::size_t>(index)];
        const unsigned every = (1U << static_cast<unsigned>(one.corners.size())) - 1;
        put_element(world, static_cast<std::size_t>(first + index),
                    {BodyId(0), place, index, first, on_all ? every : one.rim},
                    {.corners = one.corners,
                     .half_thickness = shape.thickness / 2,
                     .mass = per_area * one.area,
                     .pose = {middle + yaw * flat(one.centre), yaw * turned_to(one.axis)},
                     .piece = first,
                     .crushing_pressure = pressure});
        if (by_stress_)
            stress_.put_prism(static_cast<std::size_t>(first + index),
                              elements_[static_cast<std::size_t>(first + index)].body, one.axis,
                              {from_axes(one.corners, {}, one.axis), shape.thickness, material.ice.poisson_ratio,
                               pressure > 0 ? pressure : material.ice.compressive_strength});
    }
    for (std::size_t k = 0; k < cut->joints.size(); ++k) {
        const CutJoint& joint = cut->joints[k];
        sheet.of_joints.push_back(joint_strength(shape, material, joint.length, joint.span));
        const std::size_t at = put_joint(world, {.a = elements_[static_cast<std::size_t>(first + joint.a)].body,
                                                 .b = elements_[static_cast<std::size_t>(first + joint.b)].body,
                                                 .pivot = middle + yaw * flat(joint.pivot),
                                                 .frame = yaw * turned_to(joint.normal),
                                                 .cfm = material.joint.cfm,
                                                 .erp = material.joint.erp,
                                                 .spring = polygon_joint(joint, shape, material)});
        joints_.push_back({joint_ids_[at], place, static_cast<int>(k), {joint.a, joint.b, JointAxis::x}, at});
        sheet.joints.push_back(at);
        if (!by_stress_) continue;
        const auto of = [&](int element, double way, unsigned edge) {
            const Corner& centre = cut->elements[static_cast<std::size_t>(element)].centre;
            return PrismJoint{way * joint.normal, joint.pivot - centre, joint.length, joint.span, edge};
        };
        stress_.put_prism_joint(at, joint_ids_[at], static_cast<std::size_t>(first + joint.a),
                                of(joint.a, 1, joint.edge_a), static_cast<std::size_t>(first + joint.b),
                                of(joint.b, -1, joint.edge_b));
    }
}

Mat3 IceField::floe_axes(const Joint& joint, int element, const BodyState& state) const {
    const CutFloe* cut = floe_of(joint).cut.get();
    if (cut == nullptr) return state.rotation;
    return state.rotation *
           turned_to(cut->elements[static_cast<std::size_t>(element)].axis).toRotationMatrix().transpose();
}

IceField::JointPlace IceField::joint_place(const Joint& joint, const BodyState& a) const {
    const Sheet& sheet = floe_of(joint);
    if (!sheet.cut) {
        const Mat3 axes = a.rotation * joint_frame(joint.grid.axis).toRotationMatrix();
        return {axes, a.position + 0.5 * sheet.grid.element * axes.col(0)};
    }
    const CutJoint& cut = sheet.cut->joints[static_cast<std::size_t>(joint.number)];
    const CutElement& element = sheet.cut->elements[static_cast<std::size_t>(cut.a)];
    const Mat3 floe = floe_axes(joint, cut.a, a);
    return {floe * turned_to(cut.normal).toRotationMatrix(),
            a.position + floe * (flat(cut.pivot) - flat(element.centre))};
}

}  // namespace floes
