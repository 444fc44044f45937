#include "solver/contact_rows.hpp"

#include <algorithm>
#include <limits>

namespace floes {

constexpr double infinity = std::numeric_limits<double>::infinity();

void ContactRows::Rows::reserve(std::size_t slots) {
    row.reserve(slots * contact_field::count);
    target.reserve(slots);
    impulse.reserve(slots);
    scale.reserve(slots);
}

void ContactRows::order(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                        const LaneArrays& arrays, std::size_t body_slots, const LaneKernels& kernels) {
    const auto moves = [&](std::uint32_t slot) { return arrays.delta[8 * static_cast<std::size_t>(slot) + 3] > 0; };
    to_order_.clear();
    for (const SolverContact& contact : contacts) {
        const std::uint32_t a = slot_of_body[contact.a];
        const std::uint32_t b = slot_of_body[contact.b];
        to_order_.push_back({a, b, a, b, moves(a), moves(b), contact.impulse > 0});
    }
    order_.lay_out(to_order_, static_cast<std::uint32_t>(body_slots), kernels.width, kernels.turns);
}

void ContactRows::prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                          std::size_t body_slots, const LaneArrays& arrays, const LaneKernels& kernels,
                          const ContactLaw& law, double time_step) {
    width_ = kernels.width;
    order(contacts, slot_of_body, arrays, body_slots, kernels);
    fill_points(points_, contacts, order_, width_);
    const std::size_t slots = order_.rows() * static_cast<std::size_t>(width_);
    normals_.reserve(slots);
    frictions_.reserve(slots);
    split_target_.reserve(slots);
    cone_ = law.friction == Friction::cone;
    if (cone_) {
        seconds_.reserve(slots);
        fill_friction_start(friction_start_, contacts, order_, width_);
    }
    const bool crushing = law.normal == NormalLaw::crushing;
    const double erp = crushing ? 0 : law.erp;  // crushed ice does not push back
    const double split_depth = law.split_impulse && !crushing ? law.split_impulse_depth : infinity;
    kernels.prepare_contacts(arrays, order_.packs(), points_.data(), normals_.arrays(), friction_arrays(),
                             split_target_.data(), {1.0 / time_step, erp, split_depth, law.friction});
    limited_ = crushing || !law.internal_edges;
    if (limited_) {
        yield_.reserve(slots);
        give_.reserve(slots);
        kernels.prepare_limits(arrays, order_.packs(), points_.data(), normals_.scale.data(), limit_arrays(), law,
                               time_step);
    }
    any_split_ = std::any_of(contacts.begin(), contacts.end(),
                             [&](const SolverContact& contact) { return contact.distance <= -split_depth; });
    if (!any_split_) return;
    split_impulse_ = AlignedArray<double>(slots);
    push_ = AlignedArray<double>(8 * (body_slots + 1));
    for (std::size_t slot = 0; slot < body_slots; ++slot) push_[8 * slot + 3] = arrays.delta[8 * slot + 3];
}

void ContactRows::solve_penetrations(const LaneKernels& kernels, int iterations) {
    for (int i = 0; any_split_ && i < iterations; ++i) {
        kernels.solve_normals(push_.data(), order_.packs(),
                              {normals_.row.data(), split_target_.data(), split_impulse_.data(), nullptr}, {});
    }
}

void ContactRows::start(const LaneKernels& kernels, double* delta) {
    kernels.start_contacts(delta, order_.packs(), normals_.arrays());
    if (!cone_) return;  // friction in one direction starts from nothing
    kernels.start_contacts(delta, order_.packs(), frictions_.arrays());
    kernels.start_contacts(delta, order_.packs(), seconds_.arrays());
}

void ContactRows::sweep(const LaneKernels& kernels, double* delta) {
    if (cone_) {
        kernels.solve_cones(delta, order_.packs(), normals_.arrays(), friction_arrays(), limit_arrays());
        return;
    }
    kernels.solve_normals(delta, order_.packs(), normals_.arrays(), limit_arrays());
    kernels.solve_frictions(delta, order_.packs(), frictions_.arrays(), normals_.impulse.data());
}

std::array<double, 3> ContactRows::row_axis(const Rows& rows, std::uint32_t slot) const {
    const double* axis = rows.row.data() + place(slot, contact_field::count, contact_field::axis, width_);
    const auto width = static_cast<std::size_t>(width_);
    return {axis[0], axis[width], axis[2 * width]};
}

void ContactRows::finish(std::span<SolverContact> contacts) const {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::uint32_t at = order_.slot(i);
        contacts[i].impulse = normals_.impulse[at] * normals_.scale[at];
        std::array<double, 3> friction = row_axis(frictions_, at);  // times s
        if (cone_) {
            const std::array<double, 3> second = row_axis(seconds_, at);
            for (std::size_t k = 0; k < 3; ++k) {
                friction[k] = friction[k] * frictions_.impulse[at] + second[k] * seconds_.impulse[at];
            }
            set_friction(contacts[i], friction);
        } else {
            const double t = frictions_.scale[at];
            contacts[i].friction_impulse = frictions_.impulse[at] * t;
            for (std::size_t k = 0; k < 3; ++k) contacts[i].slide[k] = friction[k] / t;
        }
    }
}

std::array<double, 6> ContactRows::push(std::uint32_t slot) const {
    if (!any_split_) return {};
    const double* p = push_.data() + 8 * static_cast<std::size_t>(slot);
    return {p[0], p[1], p[2], p[4], p[5], p[6]};
}

}  // namespace floes
