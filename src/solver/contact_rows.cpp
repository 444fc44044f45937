#include "solver/contact_rows.hpp"

#include <algorithm>
#include <limits>

#include "solver/lane_slot.hpp"

namespace floes {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

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
        to_order_.push_back({a, b, moves(a), moves(b), contact.impulse > 0});
    }
    order_.lay_out(to_order_, static_cast<std::uint32_t>(body_slots), kernels.width, kernels.turns);
}

void ContactRows::fill_points(std::span<const SolverContact> contacts) {
    const auto width = static_cast<std::size_t>(width_);
    points_.reserve(order_.rows() * width * point_field::count);
    // Where there is none, something that stays open and harms no sum.
    std::array<double, point_field::count> none{};
    none[point_field::normal + 2] = 1;
    none[point_field::distance] = infinity;
    double* group = points_.data();
    for (std::size_t row = 0; row < order_.rows(); ++row) {
        for (const double value : none) group = std::fill_n(group, width, value);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const SolverContact& contact = contacts[i];
        double* at = points_.data() + place(order_.slot(i), point_field::count, 0, width_);
        for (std::size_t k = 0; k < 3; ++k) {
            at[(point_field::on_a + k) * width] = contact.on_a[k];
            at[(point_field::on_b + k) * width] = contact.on_b[k];
            at[(point_field::normal + k) * width] = contact.normal[k];
        }
        at[point_field::distance * width] = contact.distance;
        at[point_field::friction * width] = contact.friction;
        at[point_field::impulse * width] = contact.impulse;
    }
}

void ContactRows::prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                          std::size_t body_slots, const LaneArrays& arrays, const LaneKernels& kernels,
                          const ContactLaw& law, double time_step) {
    width_ = kernels.width;
    order(contacts, slot_of_body, arrays, body_slots, kernels);
    fill_points(contacts);
    const std::size_t slots = order_.rows() * static_cast<std::size_t>(width_);
    normals_.reserve(slots);
    frictions_.reserve(slots);
    split_target_.reserve(slots);
    const double split_depth = law.split_impulse ? law.split_impulse_depth : infinity;
    kernels.prepare_contacts(arrays, order_.packs(), points_.data(), normals_.arrays(), frictions_.arrays(),
                             split_target_.data(), {1.0 / time_step, split_depth, law});
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
                              {normals_.row.data(), split_target_.data(), split_impulse_.data(), nullptr});
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
        const double t = frictions_.scale[at];
        contacts[i].impulse = normals_.impulse[at] * normals_.scale[at];
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
