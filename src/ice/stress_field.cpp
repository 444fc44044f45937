#include "ice/stress_field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/contract.hpp"
#include "theory/plate.hpp"

namespace floes {

namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Where the edge along which the ice is stressed ends, and how much of the logarithm goes on from there.
struct End {
    double at = nowhere;  ///< m from the contact, along the edge
    double goes_on = 0;
};

/// The nearest free edge to a contact.
struct FreeEdge {
    double distance = nowhere;
    Corner along{};
    std::array<End, 2> ends{};  ///< one way and the other

    /// Decades of the stress along it, from one radius to a larger one.
    double decades_between(double from, double to) const {
        const auto until = [&](const End& end) {
            const double beyond = end.goes_on > 0 ? end.goes_on * decades(std::max(from, end.at), to) : 0.0;
            return decades(from, std::min(to, end.at)) + beyond;
        };
        return std::min(until(ends[0]), until(ends[1]));
    }
};

/// What lies along the edge `own` from the contact, `way` 1 or -1: nothing where a joint holds the ice there.
End end_along(const PressedElement& element, unsigned joined, std::size_t own, const Corner& at, const Corner& way) {
    End end;
    for (std::size_t k = 0; k < element.corners.size(); ++k) {
        const Corner normal = outward(element.corners, k);
        const double towards = dot(normal, way);
        if (k == own || !(towards > 1e-9)) continue;
        const double there = std::max(0.0, dot(normal, element.corners[k] - at)) / towards;
        if (!(there < end.at)) continue;
        const bool free = (joined >> k & 1U) == 0;
        end = {there, free ? std::sqrt(std::max(0.0, dot(normal, outward(element.corners, own)))) : 1.0};
    }
    return end.goes_on < 1 ? end : End{};
}

FreeEdge nearest_free_edge(const PressedElement& element, const Corner& at) {
    unsigned joined = 0;
    for (const ElementJoint& joint : element.joints) joined |= joint.live ? joint.edge : 0U;
    FreeEdge nearest;
    std::size_t own = 0;
    for (std::size_t k = 0; k < element.corners.size(); ++k) {
        if ((joined >> k & 1U) != 0) continue;
        const Corner normal = outward(element.corners, k);
        const double distance = std::max(0.0, dot(normal, element.corners[k] - at));
        if (!(distance < nearest.distance)) continue;
        nearest = {distance, {-normal.z, normal.x}};
        own = k;
    }
    if (nearest.distance == nowhere) return nearest;
    for (const int way : {0, 1})
        nearest.ends[static_cast<std::size_t>(way)] =
            end_along(element, joined, own, at, (way == 0 ? 1.0 : -1.0) * nearest.along);
    return nearest;
}

/// The live joint along each axis that is nearest to a contact, in spans, and how far it is, m.
struct Nearest {
    std::size_t joint = ContactStress::none;
    double distance = 0;
};
std::array<Nearest, 2> nearest_joints(const PressedElement& element, const Corner& at) {
    std::array<Nearest, 2> found;
    for (std::size_t k = 0; k < element.joints.size(); ++k) {
        const ElementJoint& joint = element.joints[k];
        if (!joint.live) continue;
        const Corner from = at - joint.pivot;
        const double beside = std::max(0.0, std::abs(cross(joint.outward, from)) - joint.length / 2);
        const double distance = std::hypot(dot(joint.outward, from), beside);
        Nearest& best = found[joint.axis()];
        if (best.joint == ContactStress::none ||
            distance * element.joints[best.joint].span < best.distance * joint.span)
            best = {k, distance};
    }
    return found;
}

}  // namespace

ContactStress contact_stress(const PressedElement& element, const Press& press) {
    const Corner at{press.x, press.z};
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * element.crushing_pressure));
    const double contact = felt_radius(crushed, element.thickness);
    const double edge = edge_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    const FreeEdge rim = nearest_free_edge(element, at);
    const std::array<Nearest, 2> nearest = nearest_joints(element, at);
    // An oblique edge meets the joints along both axes, so they are as much closer along it.
    const double crossings = std::abs(rim.along.x) + std::abs(rim.along.z);
    ContactStress found;
    std::array<double, 2> along_rim{};  // decades
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (nearest[axis].joint == ContactStress::none) continue;
        const ElementJoint& joint = element.joints[nearest[axis].joint];
        const double size = size_of_grid(joint.length, joint.span);
        const double towards = std::max(0.0, joint.span / 2 - nearest[axis].distance);
        const double inside = std::min(felt_inside.radius(size, towards, joint.span), rim.distance);
        const double at_edge = felt_at_edge.radius(size, towards, joint.span) / crossings;
        along_rim[axis] = rim.decades_between(std::max(contact, rim.distance), at_edge);
        const double share = axis == 0 ? rim.along.x * rim.along.x : rim.along.z * rim.along.z;
        found.stress[axis] = interior * decades(contact, inside) + edge * share * along_rim[axis];
        found.joint[axis] = nearest[axis].joint;
    }
    found.shear = edge * rim.along.x * rim.along.z * std::sqrt(along_rim[0] * along_rim[1]);
    return found;
}

double most_contact_stress(const PressedElement& element) {
    double largest = 0;
    for (const ElementJoint& joint : element.joints)
        largest = std::max(largest, size_of_grid(joint.length, joint.span));
    const double per_decade = std::max(edge_stress_per_decade(1, element.thickness, element.poisson_ratio),
                                       interior_stress_per_decade(1, element.thickness, element.poisson_ratio));
    // A tension s along a rim is s cos² φ along the normal with a shear of s cos φ sin φ, together at most:
    const double with_shear = 0.5 * (1 + std::numbers::sqrt2);
    return with_shear * per_decade * decades(felt_radius(0, element.thickness), felt_inside.share * largest);
}

namespace {

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

void StressField::put_element(std::size_t number, BodyId body, const Corner& axis, PressedElement element) {
    FLOES_EXPECTS(number <= elements_.size() && element.joints.empty());
    const Corner size = size_of(element.corners);
    Element made{.ice = std::move(element), .body = body, .axis = axis, .size = size};
    if (number < elements_.size()) {
        elements_[number] = std::move(made);
        return;
    }
    element_of_body_.resize(std::max(element_of_body_.size(), body.index() + 1), none);
    element_of_body_[body.index()] = number;
    elements_.push_back(std::move(made));
}

void StressField::put_joint(std::size_t number, JointId id, std::size_t a, const ElementJoint& at_a, std::size_t b,
                            const ElementJoint& at_b) {
    FLOES_EXPECTS(number <= joints_.size());
    const Joint joint{id, a, b, join(a, number, at_a), join(b, number, at_b)};
    if (number < joints_.size()) {
        joints_[number] = joint;
        live_[number] = true;
        return;
    }
    joints_.push_back(joint);
    live_.push_back(true);
    reactions_.emplace_back();
}

/// The joint's number among those of the element.
std::size_t StressField::join(std::size_t element, std::size_t joint, const ElementJoint& at) {
    Element& joined = elements_[element];
    joined.ice.joints.push_back(at);
    joined.joints.push_back(joint);
    ++joined.live;
    joined.most_stress = most_contact_stress(joined.ice);
    return joined.joints.size() - 1;
}

void StressField::remove_joint(std::size_t joint) {
    const Joint& gone = joints_[joint];
    live_[joint] = false;
    reactions_[joint] = {};
    for (const auto& [number, on] : {std::pair(gone.a, gone.on_a), std::pair(gone.b, gone.on_b)}) {
        elements_[number].ice.joints[on].live = false;
        --elements_[number].live;
    }
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
    if (number == none || elements_[number].live == 0) return;
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
    const Corner there = in_floe_axes(element.axis, at);
    return {there.x, there.z, down};
}

/// Half of the mean over both elements: what the joints on either side of one carry, over its extent along the normal.
/// A side that has joints on a part of it has that part of the moment, as free faces have none.
double StressField::across(const Joint& joint, bool at_b) const {
    const Element& element = elements_[at_b ? joint.b : joint.a];
    const ElementJoint& own = element.ice.joints[at_b ? joint.on_b : joint.on_a];
    double sum = 0;
    for (std::size_t k = 0; k < element.joints.size(); ++k)
        if (element.ice.joints[k].axis() != own.axis()) sum += reactions_[element.joints[k]].bending;
    return own.length / (own.axis() == 0 ? element.size.x : element.size.z) * sum / 4;
}

double StressField::across(std::size_t joint) const {
    return across(joints_[joint], false) + across(joints_[joint], true);
}

double StressField::most_by_contacts(std::size_t joint) const {
    const Element& a = elements_[joints_[joint].a];
    const Element& b = elements_[joints_[joint].b];
    return std::max(a.most_stress * a.largest_force, b.most_stress * b.largest_force);
}

std::optional<LocalStress> StressField::added(const Joint& joint, bool at_b, const Press& press) const {
    const Element& element = elements_[at_b ? joint.b : joint.a];
    const std::size_t on = at_b ? joint.on_b : joint.on_a;
    const ContactStress found = contact_stress(element.ice, press);
    const std::size_t axis = element.ice.joints[on].axis();
    if (found.joint[axis] != on) return std::nullopt;
    // The joint's z is the floe's where its x is along the floe's x; turned to z, it is the other way.
    return LocalStress{found.stress[axis], found.stress[1 - axis], axis == 0 ? found.shear : -found.shear};
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
