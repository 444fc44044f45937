#include "ice/stress_field.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "core/contract.hpp"
#include "core/state_archive.hpp"
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

/// Bits of the edges beyond which ice goes on: where a joint holds it, and where the edge was too short for one.
unsigned held_edges(const PressedElement& element) {
    unsigned joined = 0;
    unsigned broken = 0;
    for (const ElementJoint& joint : element.joints) (joint.live ? joined : broken) |= joint.edge;
    unsigned held = joined;
    const std::size_t count = element.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t next = (k + 1) % count;
        const std::size_t last = (k + count - 1) % count;
        if ((joined >> last & joined >> next & ~(broken >> k) & 1U) == 0) continue;
        if (edge_length(element.corners, k) <= element.least_joint) held |= 1U << k;
    }
    return held;
}

FreeEdge nearest_free_edge(const PressedElement& element, const Corner& at) {
    const unsigned joined = held_edges(element);
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

double distance_to(const ElementJoint& joint, const Corner& at) {
    const Corner from = at - joint.pivot;
    const double beside = std::max(0.0, std::abs(cross(joint.outward, from)) - joint.length / 2);
    return std::hypot(dot(joint.outward, from), beside);
}

/// Whether another joint of much the same direction is nearer, in spans; of equals the first.
bool is_nearest(const PressedElement& element, std::size_t own, const Corner& at) {
    const ElementJoint& joint = element.joints[own];
    const double distance = distance_to(joint, at) / joint.span;
    for (std::size_t k = 0; k < element.joints.size(); ++k) {
        const ElementJoint& other = element.joints[k];
        if (k == own || !other.live || std::abs(dot(other.outward, joint.outward)) < std::numbers::sqrt2 / 2) continue;
        const double there = distance_to(other, at) / other.span;
        if (there < distance || (k < own && there == distance)) return false;
    }
    return true;
}

}  // namespace

std::optional<LocalStress> contact_stress(const PressedElement& element, const Press& press, std::size_t own) {
    const Corner at{press.x, press.z};
    if (!is_nearest(element, own, at)) return std::nullopt;
    const ElementJoint& joint = element.joints[own];
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * element.crushing_pressure));
    const double contact = felt_radius(crushed, joint.thickness);
    const double edge = edge_stress_per_decade(press.down, joint.thickness, element.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, joint.thickness, element.poisson_ratio);
    const FreeEdge rim = nearest_free_edge(element, at);
    const double size = std::sqrt(element.area);
    const double towards = std::max(0.0, joint.span / 2 - distance_to(joint, at));
    const double inside = element.patch.inside.radius(size, towards, joint.span);
    const double at_edge = element.patch.at_edge.radius(size, towards, joint.span);
    const double all_round = interior * decades(contact, std::min(inside, rim.distance));
    const double along_rim = edge * rim.decades_between(std::max(contact, rim.distance), at_edge);
    const double n = dot(joint.outward, rim.along);
    const double t = cross(joint.outward, rim.along);
    return LocalStress{all_round + along_rim * n * n, all_round + along_rim * t * t, along_rim * n * t};
}

double most_contact_stress(const PressedElement& element) {
    const double thinnest = std::ranges::min_element(element.joints, {}, &ElementJoint::thickness)->thickness;
    const double per_decade = std::max(edge_stress_per_decade(1, thinnest, element.poisson_ratio),
                                       interior_stress_per_decade(1, thinnest, element.poisson_ratio));
    // A tension s along a rim is s cos² φ along the normal with a shear of s cos φ sin φ, together at most:
    const double with_shear = 0.5 * (1 + std::numbers::sqrt2);
    return with_shear * per_decade *
           decades(felt_radius(0, thinnest),
                   std::max(element.patch.inside.share, element.patch.at_edge.share) * std::sqrt(element.area));
}

namespace {

/// Contacts of a step beyond which the memory grows, for each element.
constexpr std::size_t usual_contacts = 4;

/// The corner of these coordinates along a unit vector and the one that is turned from it as z is from x.
Corner by_axes(const Corner& x_axis, double x, double z) {
    return x * x_axis + z * Corner{-x_axis.z, x_axis.x};
}

}  // namespace

StressField::StressField(std::size_t steps, std::size_t elements) : steps_(steps) {
    FLOES_EXPECTS(steps >= 1);
    contacts_.reserve(usual_contacts * elements);
    for (Step& step : steps_) {
        step.touches.reserve(2 * usual_contacts * elements);
        step.touched.reserve(elements);
    }
}

void StressField::put_element(std::size_t number, BodyId body, const Corner& axis, PressedElement element) {
    FLOES_EXPECTS(number <= elements_.size() && element.joints.empty());
    const Within within{.area = element.area};
    Element made{.ice = std::move(element), .body = body, .axis = axis};
    if (number < elements_.size()) {
        elements_[number] = std::move(made);
        within_[number] = within;
        for (Step& step : steps_) step.elements[number] = {};
        return;
    }
    for (Step& step : steps_) step.elements.emplace_back();
    element_of_body_.resize(std::max(element_of_body_.size(), body.index() + 1), none);
    element_of_body_[body.index()] = number;
    elements_.push_back(std::move(made));
    within_.push_back(within);
}

void StressField::put_joint(std::size_t number, JointId id, std::size_t a, const ElementJoint& at_a, std::size_t b,
                            const ElementJoint& at_b) {
    FLOES_EXPECTS(number <= joints_.size());
    const Joint joint{id,         a,          b,          join(a, number, at_a), join(b, number, at_b), at_a.outward,
                      at_a.pivot, at_b.pivot, at_a.length};
    if (number < joints_.size()) {
        joints_[number] = joint;
        live_[number] = true;
        return;
    }
    joints_.push_back(joint);
    live_.push_back(true);
    reactions_.emplace_back();
    for (Step& step : steps_) step.reactions.emplace_back();
}

/// The joint's number among those of the element.
std::size_t StressField::join(std::size_t element, std::size_t joint, const ElementJoint& at) {
    Element& joined = elements_[element];
    joined.ice.joints.push_back(at);
    joined.joints.push_back(joint);
    ++joined.live;
    within_[element].most_stress = most_contact_stress(joined.ice);
    return joined.joints.size() - 1;
}

void StressField::remove_joint(std::size_t joint) {
    const Joint& gone = joints_[joint];
    live_[joint] = false;
    reactions_[joint] = {};
    for (Step& step : steps_) step.reactions[joint] = {};
    for (const auto& [number, on] : {std::pair(gone.a, gone.on_a), std::pair(gone.b, gone.on_b)}) {
        elements_[number].ice.joints[on].live = false;
        --elements_[number].live;
    }
}

/// On the faces of its elements: of a the forces that b exerts, of b the same the other way round.
void StressField::spread(const Joint& joint, const JointReaction& reaction) {
    Within& a = within_[joint.a];
    Within& b = within_[joint.b];
    const Corner moment = by_axes(joint.outward, reaction.bending, -reaction.torsion);
    const Corner force = by_axes(joint.outward, reaction.axial, reaction.shear_in_plane);
    a.moment.add(moment, joint.pivot_a);
    a.force.add(force, joint.pivot_a);
    b.moment.add(-1.0 * moment, joint.pivot_b);
    b.force.add(-1.0 * force, joint.pivot_b);
}

void StressField::read(const World& world) {
    last_ = (last_ + 1) % steps_.size();
    Step& step = steps_[last_];
    for (Within& element : within_) element.moment = element.force = {};
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!live_[i]) continue;
        step.reactions[i] = world.reaction(joints_[i].id);
        reactions_[i] = average(i);
        spread(joints_[i], reactions_[i]);
    }
    for (const std::size_t i : step.touched) step.elements[i] = {};
    step.touched.clear();
    step.touches.clear();
    world.read_contacts(contacts_);
    for (const ContactForce& contact : contacts_) {
        touch(step, world, contact.a, contact, true);
        touch(step, world, contact.b, contact, false);
    }
}

/// Of the last steps.
JointReaction StressField::average(std::size_t joint) const {
    const double share = 1.0 / static_cast<double>(steps_.size());
    JointReaction sum{};
    for (const Step& step : steps_) {
        const JointReaction& one = step.reactions[joint];
        sum.axial += one.axial;
        sum.shear_vertical += one.shear_vertical;
        sum.shear_in_plane += one.shear_in_plane;
        sum.torsion += one.torsion;
        sum.in_plane_bending += one.in_plane_bending;
        sum.bending += one.bending;
    }
    return {.axial = share * sum.axial,
            .shear_vertical = share * sum.shear_vertical,
            .shear_in_plane = share * sum.shear_in_plane,
            .torsion = share * sum.torsion,
            .in_plane_bending = share * sum.in_plane_bending,
            .bending = share * sum.bending};
}

void StressField::touch(Step& step, const World& world, BodyId body, const ContactForce& contact, bool on_a) const {
    if (body.index() >= element_of_body_.size()) return;
    const std::size_t number = element_of_body_[body.index()];
    if (number == none || elements_[number].live == 0) return;
    const BodyState state = world.state(body);
    const Vec3 on = contact.normal + contact.friction;
    const Vec3 at = state.rotation.transpose() * (contact.point - state.position);
    const Vec3 force = state.rotation.transpose() * (on_a ? on : -on);
    const Corner& axis = elements_[number].axis;
    const auto place = static_cast<std::uint32_t>(step.touches.size());
    step.touches.push_back({by_axes(axis, at.x(), at.z()), by_axes(axis, force.x(), force.z()), -force.y()});
    Touched& touched = step.elements[number];
    if (touched.first == no_touch) {
        touched.first = place;
        step.touched.push_back(number);
    } else {
        step.touches[touched.last].next = place;
    }
    touched.last = place;
    touched.largest_force = std::max(touched.largest_force, on.norm());
}

double StressField::across(std::size_t joint) const {
    const Joint& one = joints_[joint];
    const Within& a = within_[one.a];
    const Within& b = within_[one.b];
    const Corner t{-one.outward.z, one.outward.x};
    return one.length / 2 * (a.moment.along(t) / a.area + b.moment.along(t) / b.area);
}

double StressField::most_by_contacts(std::size_t joint) const {
    const Joint& one = joints_[joint];
    double sum = 0;
    for (const Step& step : steps_) {
        const auto most = [&](std::size_t i) { return within_[i].most_stress * step.elements[i].largest_force; };
        sum += std::max(most(one.a), most(one.b));
    }
    return sum / static_cast<double>(steps_.size());
}

JointLoad StressField::load(std::size_t joint) const {
    const Joint& one = joints_[joint];
    const Corner t{-one.outward.z, one.outward.x};
    const double share = 1.0 / static_cast<double>(steps_.size());
    JointLoad load{.reaction = reactions_[joint], .across = across(joint)};
    Tensor force_a = within_[one.a].force;
    Tensor force_b = within_[one.b].force;
    for (const Step& step : steps_) {
        LocalStress sagging;
        LocalStress hogging;
        for (const bool at_b : {false, true}) {
            const std::size_t number = at_b ? one.b : one.a;
            for (std::uint32_t i = step.elements[number].first; i != no_touch; i = step.touches[i].next) {
                const Touch& touch = step.touches[i];
                (at_b ? force_b : force_a).add(share * touch.force, touch.at);
                const std::optional<LocalStress> local = contact_stress(
                    elements_[number].ice, {touch.at.x, touch.at.z, touch.down}, at_b ? one.on_b : one.on_a);
                if (!local) continue;
                if (local->along > sagging.along) sagging = *local;
                if (local->along < hogging.along) hogging = *local;
            }
        }
        load.sagging.add(share, sagging);
        load.hogging.add(share, hogging);
    }
    load.pulled_across =
        one.length / 2 * (force_a.along(t) / within_[one.a].area + force_b.along(t) / within_[one.b].area);
    return load;
}

void StressField::archive(StateArchive& state) {
    auto& [elements, within, joints, live, reactions, element_of_body, steps, last, contacts] = *this;
    state.list(elements, Element{.ice = {}, .body = BodyId(0), .axis = {}});
    state.list(joints, Joint{JointId(0), 0, 0, 0, 0, {}, {}, {}, 0});
    state(within, live, reactions, element_of_body, steps, last);  // contacts are those of a step
}

}  // namespace floes
