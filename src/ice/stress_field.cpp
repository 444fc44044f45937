// What acts at the joints of floes that are polygons.

#include "ice/stress_field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "ice/floe_grid.hpp"
#include "theory/plate.hpp"

namespace floes {

namespace {

/// The faces of an element across one of its axes.
struct Faces {
    std::uint8_t plus, minus;
};
constexpr std::array<Faces, 2> faces_along{{{edge_plus_x, edge_minus_x}, {edge_plus_z, edge_minus_z}}};

/// m from the contact to the nearer free face across the axis; infinite where both are joined.
double to_free_face(const PressedElement& element, const Faces& faces, double at) {
    const double none = std::numeric_limits<double>::infinity();
    const double plus = (element.joined & faces.plus) != 0 ? none : element.side / 2 - at;
    const double minus = (element.joined & faces.minus) != 0 ? none : element.side / 2 + at;
    return std::max(0.0, std::min(plus, minus));
}

}  // namespace

std::array<SideStress, 2> contact_stress(const PressedElement& element, const Press& press) {
    const std::array<double, 2> at{press.x, press.z};
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * element.crushing_pressure));
    const double contact = felt_radius(crushed, element.thickness);
    const double edge = edge_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, element.thickness, element.poisson_ratio);
    std::array<SideStress, 2> found;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Faces& faces = faces_along[axis];
        const bool nearer_plus = at[axis] >= 0;
        std::uint8_t face = nearer_plus ? faces.plus : faces.minus;
        if ((element.joined & face) == 0) face = nearer_plus ? faces.minus : faces.plus;
        if ((element.joined & face) == 0) continue;
        const double towards = face == faces.plus ? at[axis] : -at[axis];
        const double beside = to_free_face(element, faces_along[1 - axis], at[1 - axis]);  // an edge along the axis
        const double ahead = to_free_face(element, faces, at[axis]);
        const double inside = std::min({felt_inside.radius(element.side, towards, element.side), beside, ahead});
        const double at_edge = std::min(felt_at_edge.radius(element.side, towards, element.side), ahead);
        found[axis] = {interior * decades(contact, inside) + edge * decades(std::max(contact, beside), at_edge), face};
    }
    return found;
}

double most_contact_stress(const PressedElement& element) {
    const double per_decade = std::max(edge_stress_per_decade(1, element.thickness, element.poisson_ratio),
                                       interior_stress_per_decade(1, element.thickness, element.poisson_ratio));
    return per_decade * decades(felt_radius(0, element.thickness), felt_inside.share * element.side);
}

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
End end_along(const PressedPrism& prism, unsigned joined, std::size_t own, const Corner& at, const Corner& way) {
    End end;
    for (std::size_t k = 0; k < prism.corners.size(); ++k) {
        const Corner normal = outward(prism.corners, k);
        const double towards = dot(normal, way);
        if (k == own || !(towards > 1e-9)) continue;
        const double there = std::max(0.0, dot(normal, prism.corners[k] - at)) / towards;
        if (!(there < end.at)) continue;
        const bool free = (joined >> k & 1U) == 0;
        end = {there, free ? std::sqrt(std::max(0.0, dot(normal, outward(prism.corners, own)))) : 1.0};
    }
    return end.goes_on < 1 ? end : End{};
}

FreeEdge nearest_free_edge(const PressedPrism& prism, const Corner& at) {
    unsigned joined = 0;
    for (const PrismJoint& joint : prism.joints) joined |= joint.live ? joint.edge : 0U;
    FreeEdge nearest;
    std::size_t own = 0;
    for (std::size_t k = 0; k < prism.corners.size(); ++k) {
        if ((joined >> k & 1U) != 0) continue;
        const Corner normal = outward(prism.corners, k);
        const double distance = std::max(0.0, dot(normal, prism.corners[k] - at));
        if (!(distance < nearest.distance)) continue;
        nearest = {distance, {-normal.z, normal.x}};
        own = k;
    }
    if (nearest.distance == nowhere) return nearest;
    for (const int way : {0, 1})
        nearest.ends[static_cast<std::size_t>(way)] =
            end_along(prism, joined, own, at, (way == 0 ? 1.0 : -1.0) * nearest.along);
    return nearest;
}

/// The live joint along each axis that is nearest to a contact, in spans, and how far it is, m.
struct Nearest {
    std::size_t joint = PrismStress::none;
    double distance = 0;
};
std::array<Nearest, 2> nearest_joints(const PressedPrism& prism, const Corner& at) {
    std::array<Nearest, 2> found;
    for (std::size_t k = 0; k < prism.joints.size(); ++k) {
        const PrismJoint& joint = prism.joints[k];
        if (!joint.live) continue;
        const Corner from = at - joint.pivot;
        const double beside = std::max(0.0, std::abs(cross(joint.outward, from)) - joint.length / 2);
        const double distance = std::hypot(dot(joint.outward, from), beside);
        Nearest& best = found[joint.axis()];
        if (best.joint == PrismStress::none || distance * prism.joints[best.joint].span < best.distance * joint.span)
            best = {k, distance};
    }
    return found;
}

}  // namespace

PrismStress contact_stress(const PressedPrism& prism, const Press& press) {
    const Corner at{press.x, press.z};
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * prism.crushing_pressure));
    const double contact = felt_radius(crushed, prism.thickness);
    const double edge = edge_stress_per_decade(press.down, prism.thickness, prism.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, prism.thickness, prism.poisson_ratio);
    const FreeEdge rim = nearest_free_edge(prism, at);
    const std::array<Nearest, 2> nearest = nearest_joints(prism, at);
    // An oblique edge meets the joints along both axes, so they are as much closer along it.
    const double crossings = std::abs(rim.along.x) + std::abs(rim.along.z);
    PrismStress found;
    std::array<double, 2> along_rim{};  // decades
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (nearest[axis].joint == PrismStress::none) continue;
        const PrismJoint& joint = prism.joints[nearest[axis].joint];
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

double most_contact_stress(const PressedPrism& prism) {
    double largest = 0;
    for (const PrismJoint& joint : prism.joints) largest = std::max(largest, size_of_grid(joint.length, joint.span));
    const double per_decade = std::max(edge_stress_per_decade(1, prism.thickness, prism.poisson_ratio),
                                       interior_stress_per_decade(1, prism.thickness, prism.poisson_ratio));
    // A tension s along a rim is s cos² φ along the normal with a shear of s cos φ sin φ, together at most:
    const double with_shear = 0.5 * (1 + std::numbers::sqrt2);
    return with_shear * per_decade * decades(felt_radius(0, prism.thickness), felt_inside.share * largest);
}

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
    return {.ice = element, .body = body, .most_stress = most_contact_stress(element)};
}

void StressField::add_element(BodyId body, const PressedElement& element) {
    add(made_of(body, element));
}

void StressField::add(const Element& element) {
    element_of_body_.resize(std::max(element_of_body_.size(), element.body.index() + 1), none);
    element_of_body_[element.body.index()] = elements_.size();
    elements_.push_back(element);
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

void StressField::put_prism(std::size_t number, BodyId body, const Corner& axis, PressedPrism prism) {
    if (number == elements_.size()) {
        add({.body = body, .prism = prisms_.size()});
        prisms_.emplace_back();
    }
    const std::size_t at = elements_[number].prism;
    elements_[number] = {.body = body, .prism = at};  // what its contacts can do follows from its joints
    const Corner size = size_of(prism.corners);
    prisms_[at] = {std::move(prism), axis, size};
}

void StressField::put_prism_joint(std::size_t number, JointId id, std::size_t a, const PrismJoint& at_a, std::size_t b,
                                  const PrismJoint& at_b) {
    const JointAxis axis = at_a.axis() == 0 ? JointAxis::x : JointAxis::z;
    const Joint joint{id, a, b, axis, join_prism(a, number, at_a), join_prism(b, number, at_b)};
    if (number < joints_.size()) {
        joints_[number] = joint;
        live_[number] = true;
        return;
    }
    joints_.push_back(joint);
    live_.push_back(true);
    reactions_.emplace_back();
}

/// The joint's number among those of the prism.
std::size_t StressField::join_prism(std::size_t element, std::size_t joint, const PrismJoint& at) {
    Prism& prism = prisms_[elements_[element].prism];
    prism.ice.joints.push_back(at);
    prism.joints.push_back(joint);
    ++prism.live;
    elements_[element].most_stress = most_contact_stress(prism.ice);
    return prism.joints.size() - 1;
}

void StressField::leave_prisms(const Joint& joint) {
    for (const auto& [element, on] : {std::pair(joint.a, joint.on_a), std::pair(joint.b, joint.on_b)}) {
        Prism& prism = prisms_[elements_[element].prism];
        prism.ice.joints[on].live = false;
        --prism.live;
    }
}

/// Half of the mean over both elements: what the joints on either side of one carry, over its extent along the normal.
/// A side that has joints on a part of it has that part of the moment, as free faces have none.
double StressField::across_in_prism(const Joint& joint, bool at_b) const {
    const Prism& prism = prisms_[elements_[at_b ? joint.b : joint.a].prism];
    const PrismJoint& own = prism.ice.joints[at_b ? joint.on_b : joint.on_a];
    double sum = 0;
    for (std::size_t k = 0; k < prism.joints.size(); ++k)
        if (prism.ice.joints[k].axis() != own.axis()) sum += reactions_[prism.joints[k]].bending;
    return own.length / (own.axis() == 0 ? prism.size.x : prism.size.z) * sum / 4;
}

std::optional<LocalStress> StressField::added_in_prism(const Joint& joint, bool at_b, const Press& press) const {
    const Prism& prism = prisms_[elements_[at_b ? joint.b : joint.a].prism];
    const PrismStress found = contact_stress(prism.ice, press);
    const std::size_t axis = joint.axis == JointAxis::x ? 0 : 1;
    if (found.joint[axis] != (at_b ? joint.on_b : joint.on_a)) return std::nullopt;
    // The joint's z is the floe's where its x is along the floe's x; turned to z, it is the other way.
    return LocalStress{found.stress[axis], found.stress[1 - axis], axis == 0 ? found.shear : -found.shear};
}

}  // namespace floes
