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

}  // namespace

void StressField::reserve(std::size_t elements) {
    contacts_.reserve(usual_contacts * elements);
    pressed_.reserve(2 * usual_contacts * elements);
}

void StressField::add_element(BodyId body, const PressedElement& element) {
    if (elements_.empty()) first_body_ = body.index();
    elements_.push_back(element);
    joint_of_face_.push_back({none, none, none, none});
    by_contacts_.emplace_back();
}

void StressField::add_joint(JointId id, std::size_t a, std::size_t b, JointAxis axis) {
    const int face = face_of_a(axis);
    joint_of_face_[a][static_cast<std::size_t>(face)] = joints_.size();
    joint_of_face_[b][static_cast<std::size_t>(face + 1)] = joints_.size();
    elements_[a].joined |= bit_of(face);
    elements_[b].joined |= bit_of(face + 1);
    joints_.push_back({id, a, b, axis});
    live_.push_back(true);
    reactions_.emplace_back();
}

void StressField::remove_joint(std::size_t joint) {
    const Joint& gone = joints_[joint];
    const int face = face_of_a(gone.axis);
    joint_of_face_[gone.a][static_cast<std::size_t>(face)] = none;
    joint_of_face_[gone.b][static_cast<std::size_t>(face + 1)] = none;
    elements_[gone.a].joined &= static_cast<std::uint8_t>(~bit_of(face));
    elements_[gone.b].joined &= static_cast<std::uint8_t>(~bit_of(face + 1));
    live_[joint] = false;
    reactions_[joint] = {};
}

void StressField::read(const World& world) {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (live_[i]) reactions_[i] = world.reaction(joints_[i].id);
    for (const std::size_t element : pressed_) by_contacts_[element] = {};
    pressed_.clear();
    world.read_contacts(contacts_);
    for (const ContactForce& contact : contacts_) {
        const Vec3 on_a = contact.normal + contact.friction;
        press(world, contact.a, contact.point, on_a);
        press(world, contact.b, contact.point, -on_a);
    }
}

void StressField::press(const World& world, BodyId body, const Vec3& point, const Vec3& force) {
    const std::size_t element = body.index() - first_body_;
    if (element >= elements_.size() || elements_[element].joined == 0) return;
    const BodyState state = world.state(body);
    const Vec3 at = state.rotation.transpose() * (point - state.position);
    const double half = elements_[element].side / 2;
    const Press here{std::clamp(at.x(), -half, half), std::clamp(at.z(), -half, half),
                     -state.rotation.col(1).dot(force)};
    std::array<Peak, 4>& known = by_contacts_[element];
    pressed_.push_back(element);
    const std::array<SideStress, 2> found = contact_stress(elements_[element], here);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (found[axis].face == 0) continue;
        Peak& peak = known[static_cast<std::size_t>(std::countr_zero(found[axis].face))];
        const LocalStress local{found[axis].stress, found[1 - axis].stress};
        if (local.along > peak.sagging.along) peak.sagging = local;
        if (local.along < peak.hogging.along) peak.hogging = local;
    }
}

double StressField::bending(std::size_t element, int face) const {
    const std::size_t joint = joint_of_face_[element][static_cast<std::size_t>(face)];
    return joint == none ? 0.0 : reactions_[joint].bending;
}

JointLoad StressField::load(std::size_t joint) const {
    const Joint& one = joints_[joint];
    const int beside = face_of_a(one.axis == JointAxis::x ? JointAxis::z : JointAxis::x);
    JointLoad load{.reaction = reactions_[joint]};
    for (const std::size_t element : {one.a, one.b})
        load.across += (bending(element, beside) + bending(element, beside + 1)) / 4;
    const int face = face_of_a(one.axis);
    for (const auto& [element, side] : {std::pair(one.a, face), std::pair(one.b, face + 1)}) {
        const Peak& peak = by_contacts_[element][static_cast<std::size_t>(side)];
        if (peak.sagging.along > load.sagging.along) load.sagging = peak.sagging;
        if (peak.hogging.along < load.hogging.along) load.hogging = peak.hogging;
    }
    return load;
}

}  // namespace floes
