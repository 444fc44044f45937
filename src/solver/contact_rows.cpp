#include "solver/contact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/body_lane.hpp"

namespace floes {

namespace {

void set(double (&to)[4], const Vector& v, double scalar) {
    std::copy(v.begin(), v.end(), to);
    to[3] = scalar;
}

/// A row along `axis` at the given levers, without its target. Returns its scale s = A^-1/2.
double make_row(ContactRow& row, const Vector& axis, const Vector& lever_a, const Vector& lever_b, const BodyLane& a,
                const BodyLane& b) {
    const Vector torque_a = cross(lever_a, axis);
    const Vector torque_b = cross(lever_b, axis);
    const Vector spin_a = a.inertia_response(torque_a);
    const Vector spin_b = b.inertia_response(torque_b);
    const double s =
        1.0 / std::sqrt(a.inverse_mass() + b.inverse_mass() + (dot(torque_a, spin_a) + dot(torque_b, spin_b)));
    set(row.axis, axis * s, 0);
    set(row.torque_a, torque_a * s, 0);
    set(row.torque_b, torque_b * s, 0);
    set(row.spin_a, spin_a * s, a.inverse_mass());
    set(row.spin_b, spin_b * s, b.inverse_mass());
    return s;
}

/// Bullet's btPlaneSpace1: some direction at right angles to the unit vector n.
Vector any_tangent(const Vector& n) {
    if (std::abs(n[2]) > 0.7071067811865475244008443621048490) {
        const double k = 1.0 / std::sqrt(n[1] * n[1] + n[2] * n[2]);
        return {0, -n[2] * k, n[1] * k};
    }
    const double k = 1.0 / std::sqrt(n[0] * n[0] + n[1] * n[1]);
    return {-n[1] * k, n[0] * k, 0};
}

/// Unit vector of the sliding velocity; any tangent where nothing slides.
Vector slide_direction(const Vector& velocity, const Vector& normal) {
    const Vector sliding = velocity - normal * dot(normal, velocity);
    const double square = dot(sliding, sliding);
    return square > std::numeric_limits<double>::epsilon() ? sliding * (1.0 / std::sqrt(square)) : any_tangent(normal);
}

void add_impulse(double* delta, const ContactRow& row, const ContactBodies& bodies) {
    const double impulse = row.torque_a[3];
    double* a = delta + 8 * static_cast<std::size_t>(bodies.a);
    double* b = delta + 8 * static_cast<std::size_t>(bodies.b);
    for (int i = 0; i < 3; ++i) {
        a[i] += row.axis[i] * (row.spin_a[3] * impulse);
        a[4 + i] += row.spin_a[i] * impulse;
        b[i] -= row.axis[i] * (row.spin_b[3] * impulse);
        b[4 + i] -= row.spin_b[i] * impulse;
    }
}

}  // namespace

void ContactRows::order(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                        std::size_t body_slots, const LaneArrays& arrays, int width) {
    // A contact may move forward past contacts that share no moving body with it: nothing changes by that. So each goes
    // to the level after the last one that touched its bodies, and levels are solved one after the other.
    level_of_slot_.assign(body_slots, 0);
    level_of_contact_.resize(contacts.size());
    // A number of contacts that rises one by one must not allocate each time; assign() alone would.
    if (level_start_.capacity() <= contacts.size()) level_start_.reserve(2 * contacts.size() + 1);
    level_start_.assign(contacts.size() + 1, 0);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::uint32_t a = slot_of_body[contacts[i].a];
        const std::uint32_t b = slot_of_body[contacts[i].b];
        const bool a_moves = BodyLane(arrays, a, width).inverse_mass() > 0;
        const bool b_moves = BodyLane(arrays, b, width).inverse_mass() > 0;
        const std::uint32_t level = std::max(a_moves ? level_of_slot_[a] : 0, b_moves ? level_of_slot_[b] : 0);
        if (a_moves) level_of_slot_[a] = level + 1;
        if (b_moves) level_of_slot_[b] = level + 1;
        level_of_contact_[i] = level;
        ++level_start_[level + 1];
    }
    for (std::size_t level = 1; level < level_start_.size(); ++level) level_start_[level] += level_start_[level - 1];
    place_.resize(contacts.size());
    bodies_.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        place_[i] = level_start_[level_of_contact_[i]]++;
        bodies_[place_[i]] = {slot_of_body[contacts[i].a], slot_of_body[contacts[i].b]};
    }
}

void ContactRows::prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                          std::size_t body_slots, const LaneArrays& arrays, int width, const ContactRules& rules,
                          double time_step) {
    count_ = contacts.size();
    order(contacts, slot_of_body, body_slots, arrays, width);
    normals_.reserve(count_);
    frictions_.reserve(count_);
    normal_scale_.resize(count_);
    friction_scale_.resize(count_);
    split_rows_.clear();
    split_bodies_.clear();
    const double inverse_step = 1.0 / time_step;
    for (std::size_t i = 0; i < count_; ++i) {
        const SolverContact& contact = contacts[i];
        const std::size_t at = place_[i];
        const BodyLane a(arrays, bodies_[at].a, width);
        const BodyLane b(arrays, bodies_[at].b, width);
        const Vector lever_a = contact.on_a - a.position();
        const Vector lever_b = contact.on_b - b.position();

        ContactRow& normal = normals_[at];
        const double s = make_row(normal, contact.normal, lever_a, lever_b, a, b);
        const Vector velocity = (a.start_velocity() + cross(a.start_spin(), lever_a)) -
                                (b.start_velocity() + cross(b.start_spin(), lever_b));
        const double approach = dot(contact.normal, velocity);
        // A gap may close within the step; a penetration is opened by erp, deep ones outside the impulse.
        const bool apart = contact.distance > 0;
        const double stop = apart ? -approach - contact.distance * inverse_step : -approach;
        const double correction = apart ? 0.0 : -contact.distance * rules.erp * inverse_step;
        const bool split = rules.split_impulse && contact.distance <= -rules.split_impulse_depth;
        normal.axis[3] = (split ? stop : stop + correction) * s;
        normal.torque_a[3] = contact.impulse / s;
        normal_scale_[at] = s;
        if (split && correction != 0) {
            split_rows_.push_back(normal);
            split_rows_.back().axis[3] = correction * s;
            split_rows_.back().torque_a[3] = 0;
            split_bodies_.push_back(bodies_[at]);
        }

        // Bullet leaves the torque of this step out of the sliding velocity that the row stops.
        ContactRow& friction = frictions_[at];
        const Vector slide = slide_direction(velocity, contact.normal);
        const double t = make_row(friction, slide, lever_a, lever_b, a, b);
        friction.axis[3] = -dot(slide, (a.start_velocity() + cross(a.spin(), lever_a)) -
                                           (b.start_velocity() + cross(b.spin(), lever_b))) *
                           t;
        friction.torque_b[3] = contact.friction * s / t;
        friction_scale_[at] = t;
        add_impulse(arrays.delta, normal, bodies_[at]);
    }
    if (any_split()) push_ = AlignedArray<double>(8 * body_slots);
}

void ContactRows::solve_penetrations(const LaneKernels& kernels, int iterations) {
    for (int i = 0; any_split() && i < iterations; ++i) {
        kernels.solve_normals(push_.data(), split_rows_.data(), split_bodies_.data(), split_rows_.size());
    }
}

void ContactRows::sweep(const LaneKernels& kernels, double* delta) {
    kernels.solve_normals(delta, normals_.data(), bodies_.data(), count_);
    kernels.solve_frictions(delta, frictions_.data(), normals_.data(), bodies_.data(), count_);
}

void ContactRows::finish(std::span<SolverContact> contacts) const {
    for (std::size_t i = 0; i < count_; ++i) {
        const std::size_t at = place_[i];
        const double t = friction_scale_[at];
        contacts[i].impulse = normals_[at].torque_a[3] * normal_scale_[at];
        contacts[i].friction_impulse = frictions_[at].torque_a[3] * t;
        for (std::size_t k = 0; k < 3; ++k) contacts[i].slide[k] = frictions_[at].axis[k] / t;
    }
}

std::array<double, 6> ContactRows::push(std::uint32_t slot) const {
    if (!any_split()) return {};
    const double* p = push_.data() + 8 * static_cast<std::size_t>(slot);
    return {p[0], p[1], p[2], p[4], p[5], p[6]};
}

}  // namespace floes
