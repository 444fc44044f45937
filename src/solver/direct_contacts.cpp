#include "solver/direct_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

/// Sum of squares of a sweep's changes, over the least of the step so far, from which on sweeps run away. Momentum
/// alone lets changes grow for some sweeps. 27 steps of a jam on a vertical wall took 148, 124, 111 and 122 sweeps on
/// average at 2, 4, 8 and 16; from 8 on some end at other thrusts, by 1 to 4 %. Compared with the sweep before in place
/// of the least, some steps never end. Without momentum steps of that jam take over 800 sweeps.
constexpr double runs_away = 4;

double Acceleration::after(const SweepChange& sweep) {
    if (sweep.onwards < 0 || sweep.square > runs_away * least_square_) momentum_ = 1;
    least_square_ = std::min(least_square_, sweep.square);
    const double next = 0.5 * (1 + std::sqrt(1 + 4 * momentum_ * momentum_));
    const double ahead = (momentum_ - 1) / next;
    momentum_ = next;
    return ahead;
}

DirectRowArrays DirectContacts::rows() {
    return {row_.data(),
            {target_[0].data(), target_[1].data(), target_[2].data()},
            {impulse_[0].data(), impulse_[1].data(), impulse_[2].data()},
            {ended_[0].data(), ended_[1].data(), ended_[2].data()},
            {scale_[0].data(), scale_[1].data()}};
}

void DirectContacts::prepare(std::span<const SolverContact> contacts, const LaneArrays& all, DirectFloes& floes,
                             const LaneKernels& kernels, const ContactLaw& law, double time_step) {
    width_ = kernels.width;
    to_order_.clear();
    for (const SolverContact& contact : contacts) {
        to_order_.push_back({contact.a, contact.b, floes.piece(contact.a), floes.piece(contact.b),
                             floes.moves(contact.a), floes.moves(contact.b), contact.impulse > 0});
    }
    order_.lay_out(to_order_, floes.spare(), width_, 1, ContactOrder::Order::any);
    fill_points(points_, contacts, order_, width_);
    fill_friction_start(friction_start_, contacts, order_, width_);
    const std::size_t slots = order_.rows() * static_cast<std::size_t>(width_);
    row_.reserve(slots * direct_field::count);
    for (AlignedArray<double>& target : target_) target.reserve(slots);
    for (AlignedArray<double>& impulse : impulse_) impulse.reserve(slots);
    for (AlignedArray<double>& ended : ended_) ended.reserve(slots);
    for (AlignedArray<double>& scale : scale_) scale.reserve(slots);
    const bool crushing = law.normal == NormalLaw::crushing;
    kernels.direct.prepare_contacts(all, floes.arrays(), floes.columns(), order_.packs(), points_.data(),
                                    friction_start_.data(), rows(),
                                    {1.0 / time_step, crushing ? 0 : law.erp});  // crushed ice does not push back
    limited_ = crushing || !law.internal_edges;
    if (!limited_) return;
    yield_.reserve(slots);
    give_.reserve(slots);
    kernels.prepare_limits(all, order_.packs(), points_.data(), scale_[0].data(), {yield_.data(), give_.data()}, law,
                           time_step);
}

/// As if a sweep had ended where the first one begins.
void DirectContacts::begin_sweeps(const MovedAhead& moved) {
    for (std::size_t k = 0; k < ended_.size(); ++k) std::copy_n(impulse_[k].data(), moved.places, ended_[k].data());
    for (std::size_t i = 0; i < moved.count; ++i)
        std::copy_n(moved.delta + 8 * static_cast<std::size_t>(moved.slots[i]), 8, moved.ended + 8 * i);
}

int DirectContacts::solve(const LaneArrays& all, DirectFloes& floes, const LaneKernels& kernels, const Sweeps& sweeps) {
    if (order_.rows() == 0) return 0;
    const auto* columns = floes.columns();
    kernels.direct.start_contacts(all.delta, columns, order_.packs(), rows());
    const LimitArrays limits = limited_ ? LimitArrays{yield_.data(), give_.data()} : LimitArrays{};
    const std::span<const std::uint32_t> bodies = floes.touched_bodies();
    ended_delta_.reserve(8 * bodies.size());
    const MovedAhead moved{all.delta, ended_delta_.data(), bodies.data(), bodies.size(),
                           order_.rows() * static_cast<std::size_t>(width_)};
    begin_sweeps(moved);
    Acceleration acceleration;
    int used = 1;
    for (;; ++used) {
        const SweepChange change = kernels.direct.solve_contacts(all.delta, columns, order_.packs(), rows(), limits);
        if (change.largest < sweeps.tolerance || used >= sweeps.most) break;
        kernels.direct.move_ahead(moved, rows(), acceleration.after(change));
    }
    kernels.direct.sum_contacts(floes.arrays().impulse, columns, order_.packs(), rows());
    return used;
}

void DirectContacts::finish(std::span<SolverContact> contacts) const {
    const auto width = static_cast<std::size_t>(width_);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::uint32_t at = order_.slot(i);
        contacts[i].impulse = impulse_[0][at] * scale_[0][at];
        const double* plane = row_.data() + place(at, direct_field::count, direct_field::first, width_);
        std::array<double, 3> friction{};
        for (std::size_t k = 0; k < 3; ++k) {
            friction[k] =
                (plane[k * width] * impulse_[1][at] + plane[(3 + k) * width] * impulse_[2][at]) * scale_[1][at];
        }
        set_friction(contacts[i], friction);
    }
}

}  // namespace floes
