// Floes of an IceField that are polygons.

#include "core/turn.hpp"
#include "ice/ice_field.hpp"
#include "ice/polygon_floe.hpp"

namespace floes {
namespace {

Vec3 flat(const Corner& point) {
    return {point.x, 0, point.z};
}

}  // namespace

void IceField::add_polygon(World& world, const Scenario& scenario, const SingleFloe& floe,
                           const std::shared_ptr<const CutFloe>& cut) {
    const FloeShape& shape = floe.shape;
    const Material& material = floe.material;
    const Water& water = scenario.water;
    const double pressure = scenario.contact_law(material.ice).crushing_pressure;
    const double per_area = material.ice.density * shape.thickness * (1 + water.isotropic_mass());
    const int place = places();
    const int first = static_cast<int>(elements_.size());
    Sheet& sheet = floes_.emplace_back(Sheet{first, {}, {}, joint_ids_.size(), entered_++});
    sheet.cut = cut;
    const Turn half = turn_of(0.5 * floe.pose.yaw);
    const Quat yaw(half.cos, 0, half.sin, 0);
    const Vec3 middle(floe.pose.x, shape.floating_height(material.ice, water.density), floe.pose.z);
    const bool on_all = water.form_drag_on == FormDragOn::every_element;
    for (const CutElement& one : cut->elements) {
        const BodyId body = world.add_prism({.corners = one.corners,
                                             .half_thickness = shape.thickness / 2,
                                             .mass = per_area * one.area,
                                             .pose = {middle + yaw * flat(one.centre), yaw * turned_to(one.axis)},
                                             .piece = first,
                                             .crushing_pressure = pressure});
        const unsigned every = (1U << static_cast<unsigned>(one.corners.size())) - 1;
        append({body, place, static_cast<int>(elements_.size()) - first, first, on_all ? every : one.rim}, body);
        if (by_stress_)
            stress_.add_prism(body, one.axis,
                              {from_axes(one.corners, {}, one.axis), shape.thickness, material.ice.poisson_ratio,
                               pressure > 0 ? pressure : material.ice.compressive_strength});
    }
    for (std::size_t k = 0; k < cut->joints.size(); ++k) {
        const CutJoint& joint = cut->joints[k];
        sheet.of_joints.push_back(joint_strength(shape, material, joint.length, joint.span));
        const JointId id = world.add_joint({.a = elements_[static_cast<std::size_t>(first + joint.a)].body,
                                            .b = elements_[static_cast<std::size_t>(first + joint.b)].body,
                                            .pivot = middle + yaw * flat(joint.pivot),
                                            .frame = yaw * turned_to(joint.normal),
                                            .cfm = material.joint.cfm,
                                            .erp = material.joint.erp,
                                            .spring = polygon_joint(joint, shape, material)});
        joints_.push_back({id, place, static_cast<int>(k), {joint.a, joint.b, JointAxis::x}, joint_ids_.size()});
        joint_ids_.push_back(id);
        if (!by_stress_) continue;
        const auto of = [&](int element, double way, unsigned edge) {
            const Corner& centre = cut->elements[static_cast<std::size_t>(element)].centre;
            return PrismJoint{way * joint.normal, joint.pivot - centre, joint.length, joint.span, edge};
        };
        stress_.add_prism_joint(id, static_cast<std::size_t>(first + joint.a), of(joint.a, 1, joint.edge_a),
                                static_cast<std::size_t>(first + joint.b), of(joint.b, -1, joint.edge_b));
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
