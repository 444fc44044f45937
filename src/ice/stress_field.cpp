#include "ice/stress_field.hpp"

#include <algorithm>
#include <bit>

namespace floes {
namespace {

std::uint8_t bit_of(int face) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(face));
}
static_assert(edge_plus_x == 1 && edge_minus_x == 2 && edge_plus_z == 4 && edge_minus_z == 8);

/// Number of the face of a that a joint along this axis is on; that of b is the next one.
int face_of_a(JointAxis axis) {
    return axis == JointAxis::x ? 0 : 2;
}

/// Contacts of a step beyond which the memory grows, for each element.
constexpr std::size_t usual_contacts = 4;

Corner in_floe_axes(const Corner& own_x, const Vec3& at) {
    return at.x() * own_x + at.z() * Corner{-own_x.z, own_x.x};
}

}  // namespace

void StressField::reserve(std::size_t elements) {
    contacts_.reserve(usual_contacts * elements);
    touches_.reserve(2 * usual_contacts * elements);
    touched_.reserve(elements);
}

StressField::Element StressField::made_of(BodyId body, const PressedElement& element) {
    return {.ice = element,
            .body = body,
            .most_stress = most_contact_stress(element),
            .joint_of = {none, none, none, none}};
}

void StressField::add_element(BodyId body, const PressedElement& element) {
    element_of_body_.resize(std::max(element_of_body_.size(), body.index() + 1), none);
    element_of_body_[body.index()] = elements_.size();
    elements_.push_back(made_of(body, element));
}

void StressField::add_joint(JointId id, std::size_t a, std::size_t b, JointAxis axis) {
    joints_.push_back({id, a, b, axis});
    live_.push_back(true);
    reactions_.emplace_back();
    join(joints_.size() - 1);
}

void StressField::join(std::size_t joint) {
    const Joint& made = joints_[joint];
    const int face = face_of_a(made.axis);
    elements_[made.a].joint_of[static_cast<std::size_t>(face)] = joint;
    elements_[made.b].joint_of[static_cast<std::size_t>(face + 1)] = joint;
    elements_[made.a].ice.joined |= bit_of(face);
    elements_[made.b].ice.joined |= bit_of(face + 1);
}

/// What touched the one before is not what touches this one.
void StressField::put_in(std::size_t number, const PressedElement& element) {
    elements_[number] = made_of(elements_[number].body, element);
}

void StressField::put_in_joint(std::size_t number) {
    live_[number] = true;
    join(number);
}

void StressField::remove_joint(std::size_t joint) {
    const Joint& gone = joints_[joint];
    live_[joint] = false;
    reactions_[joint] = {};
    if (is_prism(gone.a)) return leave_prisms(gone);
    const int face = face_of_a(gone.axis);
    elements_[gone.a].joint_of[static_cast<std::size_t>(face)] = none;
    elements_[gone.b].joint_of[static_cast<std::size_t>(face + 1)] = none;
    elements_[gone.a].ice.joined &= static_cast<std::uint8_t>(~bit_of(face));
    elements_[gone.b].ice.joined &= static_cast<std::uint8_t>(~bit_of(face + 1));
}

void StressField::read(const World& world) {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (live_[i]) reactions_[i] = world.reaction(joints_[i].id);
    for (const std::size_t i : touched_) {
        elements_[i].first = elements_[i].last = no_touch;
        elements_[i].largest_force = 0;
    }
    touched_.clear();
    touches_.clear();
    world.read_contacts(contacts_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        touch(contacts_[i].a, i, true);
        touch(contacts_[i].b, i, false);
    }
}

void StressField::touch(BodyId body, std::size_t contact, bool on_a) {
    if (body.index() >= element_of_body_.size()) return;
    const std::size_t number = element_of_body_[body.index()];
    if (number == none || !elements_[number].is_joined(prisms_)) return;
    Element& element = elements_[number];
    const auto place = static_cast<std::uint32_t>(touches_.size());
    touches_.push_back({contact, on_a});
    if (element.first == no_touch) {
        element.first = place;
        touched_.push_back(number);
    } else {
        touches_[element.last].next = place;
    }
    element.last = place;
    const double force = (contacts_[contact].normal + contacts_[contact].friction).norm();
    element.largest_force = std::max(element.largest_force, force);
}

Press StressField::press(const World& world, const Element& element, const Touch& touch) const {
    const ContactForce& contact = contacts_[touch.contact];
    const Vec3 on_a = contact.normal + contact.friction;
    const Vec3 force = touch.on_a ? on_a : -on_a;
    const BodyState state = world.state(element.body);
    const Vec3 at = state.rotation.transpose() * (contact.point - state.position);
    const double down = -state.rotation.col(1).dot(force);
    if (element.prism != none) {
        const Corner there = in_floe_axes(prisms_[element.prism].axis, at);
        return {there.x, there.z, down};
    }
    const double half = element.ice.side / 2;
    return {std::clamp(at.x(), -half, half), std::clamp(at.z(), -half, half), down};
}

double StressField::bending(const Element& element, int face) const {
    const std::size_t joint = element.joint_of[static_cast<std::size_t>(face)];
    return joint == none ? 0.0 : reactions_[joint].bending;
}

double StressField::across(std::size_t joint) const {
    const Joint& one = joints_[joint];
    if (is_prism(one.a)) return across_in_prism(one, false) + across_in_prism(one, true);
    const int beside = face_of_a(one.axis == JointAxis::x ? JointAxis::z : JointAxis::x);
    double sum = 0;
    for (const std::size_t i : {one.a, one.b})
        sum += (bending(elements_[i], beside) + bending(elements_[i], beside + 1)) / 4;
    return sum;
}

double StressField::most_by_contacts(std::size_t joint) const {
    const Element& a = elements_[joints_[joint].a];
    const Element& b = elements_[joints_[joint].b];
    return std::max(a.most_stress * a.largest_force, b.most_stress * b.largest_force);
}

std::optional<LocalStress> StressField::added(const Joint& joint, bool at_b, const Press& press) const {
    const Element& element = elements_[at_b ? joint.b : joint.a];
    if (element.prism != none) return added_in_prism(joint, at_b, press);
    const std::array<SideStress, 2> found = contact_stress(element.ice, press);
    const auto axis = static_cast<std::size_t>(joint.axis == JointAxis::x ? 0 : 1);
    if (found[axis].face != bit_of(face_of_a(joint.axis) + (at_b ? 1 : 0))) return std::nullopt;
    return LocalStress{found[axis].stress, found[1 - axis].stress};
}

JointLoad StressField::load(const World& world, std::size_t joint) const {
    const Joint& one = joints_[joint];
    JointLoad load{.reaction = reactions_[joint], .across = across(joint)};
    for (const bool at_b : {false, true}) {
        const Element& element = elements_[at_b ? one.b : one.a];
        for (std::uint32_t i = element.first; i != no_touch; i = touches_[i].next) {
            const std::optional<LocalStress> local = added(one, at_b, press(world, element, touches_[i]));
            if (!local) continue;
            if (local->along > load.sagging.along) load.sagging = *local;
            if (local->along < load.hogging.along) load.hogging = *local;
        }
    }
    return load;
}

}  // namespace floes
