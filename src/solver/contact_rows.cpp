#include "solver/contact_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/body_lane.hpp"
#include "solver/lane_slot.hpp"

namespace floes {

namespace {

/// Target of a normal row that then exerts nothing.
constexpr double never = -std::numeric_limits<double>::infinity();

/// One lane of a row.
class RowLane {
  public:
    RowLane(double* rows, std::uint32_t slot, int width)
        : row_(rows + place(slot, contact_field::count, 0, width)), width_(width) {}

    void set(int field, double value) { row_[field * width_] = value; }
    void set(int field, const Vector& v) {
        for (int i = 0; i < 3; ++i) set(field + i, v[static_cast<std::size_t>(i)]);
    }

  private:
    double* row_;
    int width_;
};

/// A row along `axis` at the given levers. Returns its scale s = A^-1/2.
double make_row(RowLane row, const Vector& axis, const Vector& lever_a, const Vector& lever_b, const BodyLane& a,
                const BodyLane& b) {
    const Vector torque_a = cross(lever_a, axis);
    const Vector torque_b = cross(lever_b, axis);
    const Vector spin_a = a.inertia_response(torque_a);
    const Vector spin_b = b.inertia_response(torque_b);
    const double s =
        1.0 / std::sqrt(a.inverse_mass() + b.inverse_mass() + (dot(torque_a, spin_a) + dot(torque_b, spin_b)));
    row.set(contact_field::axis, axis * s);
    row.set(contact_field::torque_a, torque_a * s);
    row.set(contact_field::torque_b, torque_b * s);
    row.set(contact_field::spin_a, spin_a * s);
    row.set(contact_field::spin_b, spin_b * s);
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

}  // namespace

void ContactRows::Rows::clear(std::size_t slots, std::size_t contacts) {
    row.reserve(slots * contact_field::count);
    target.reserve(slots);
    impulse.reserve(slots);
    std::fill_n(row.data(), slots * contact_field::count, 0.0);
    std::fill_n(target.data(), slots, 0.0);
    std::fill_n(impulse.data(), slots, 0.0);
    scale.resize(contacts);
}

void ContactRows::prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                          std::size_t body_slots, const LaneArrays& arrays, const LaneKernels& kernels,
                          const ContactRules& rules, double time_step) {
    const int width = width_ = kernels.width;
    const auto moves = [&](std::uint32_t slot) { return BodyLane(arrays, slot, width).inverse_mass() > 0; };
    to_order_.clear();
    for (const SolverContact& contact : contacts) {
        const ContactBodies slots{slot_of_body[contact.a], slot_of_body[contact.b]};
        to_order_.push_back({slots, moves(slots.a), moves(slots.b), contact.impulse > 0});
    }
    order_.lay_out(to_order_, static_cast<std::uint32_t>(body_slots), width, kernels.turns);
    const std::size_t slots = order_.rows() * static_cast<std::size_t>(width);
    normals_.clear(slots, contacts.size());
    frictions_.clear(slots, contacts.size());
    any_split_ = false;
    const double inverse_step = 1.0 / time_step;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const SolverContact& contact = contacts[i];
        const std::uint32_t at = order_.slot(i);
        const BodyLane a(arrays, slot_of_body[contact.a], width);
        const BodyLane b(arrays, slot_of_body[contact.b], width);
        const Vector lever_a = contact.on_a - a.position();
        const Vector lever_b = contact.on_b - b.position();

        const double s = make_row({normals_.row.data(), at, width}, contact.normal, lever_a, lever_b, a, b);
        const Vector velocity = (a.start_velocity() + cross(a.start_spin(), lever_a)) -
                                (b.start_velocity() + cross(b.start_spin(), lever_b));
        const double approach = dot(contact.normal, velocity);
        // A gap may close within the step; a penetration is opened by erp, deep ones outside the impulse.
        const bool apart = contact.distance > 0;
        const double stop = apart ? -approach - contact.distance * inverse_step : -approach;
        const double correction = apart ? 0.0 : -contact.distance * rules.erp * inverse_step;
        const bool split = rules.split_impulse && contact.distance <= -rules.split_impulse_depth;
        normals_.target[at] = (split ? stop : stop + correction) * s;
        normals_.impulse[at] = contact.impulse / s;
        normals_.scale[i] = s;
        if (split && correction != 0) {
            if (!any_split_) {
                split_target_.reserve(slots);
                std::fill_n(split_target_.data(), slots, never);
            }
            any_split_ = true;
            split_target_[at] = correction * s;
        }

        // Bullet leaves the torque of this step out of the sliding velocity that the row stops.
        const Vector slide = slide_direction(velocity, contact.normal);
        RowLane friction(frictions_.row.data(), at, width);
        const double t = make_row(friction, slide, lever_a, lever_b, a, b);
        friction.set(contact_field::grip, contact.friction * s / t);
        frictions_.target[at] = -dot(slide, (a.start_velocity() + cross(a.spin(), lever_a)) -
                                                (b.start_velocity() + cross(b.spin(), lever_b))) *
                                t;
        frictions_.scale[i] = t;
    }
    if (any_split_) {
        split_impulse_ = AlignedArray<double>(slots);
        push_ = AlignedArray<double>(8 * (body_slots + 1));
        for (std::size_t slot = 0; slot < body_slots; ++slot) push_[8 * slot + 3] = arrays.delta[8 * slot + 3];
    }
}

void ContactRows::solve_penetrations(const LaneKernels& kernels, int iterations) {
    for (int i = 0; any_split_ && i < iterations; ++i) {
        kernels.solve_normals(push_.data(), order_.packs(),
                              {normals_.row.data(), split_target_.data(), split_impulse_.data()});
    }
}

void ContactRows::start(const LaneKernels& kernels, double* delta) {
    kernels.start_contacts(delta, order_.packs(), normals_.arrays());
}

void ContactRows::sweep(const LaneKernels& kernels, double* delta) {
    kernels.solve_normals(delta, order_.packs(), normals_.arrays());
    kernels.solve_frictions(delta, order_.packs(), frictions_.arrays(), normals_.impulse.data());
}

void ContactRows::finish(std::span<SolverContact> contacts) const {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::uint32_t at = order_.slot(i);
        const double t = frictions_.scale[i];
        contacts[i].impulse = normals_.impulse[at] * normals_.scale[i];
        contacts[i].friction_impulse = frictions_.impulse[at] * t;
        const double* axis = frictions_.row.data() + place(at, contact_field::count, contact_field::axis, width_);
        for (std::size_t k = 0; k < 3; ++k) contacts[i].slide[k] = axis[k * static_cast<std::size_t>(width_)] / t;
    }
}

std::array<double, 6> ContactRows::push(std::uint32_t slot) const {
    if (!any_split_) return {};
    const double* p = push_.data() + 8 * static_cast<std::size_t>(slot);
    return {p[0], p[1], p[2], p[4], p[5], p[6]};
}

}  // namespace floes
