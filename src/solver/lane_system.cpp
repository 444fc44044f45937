#include "solver/lane_system.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "solver/lane_width.hpp"

namespace floes {

/// Bodies and joints of a floe, in the order of their indices.
struct LaneSystem::Floe {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> joints;
    std::vector<std::int32_t> pairs;  ///< bodies a, b of each joint, counted within the floe
};

namespace {

std::size_t place(std::uint32_t slot, int fields, int field, int width) {
    const auto w = static_cast<std::uint32_t>(width);
    return (slot / w) * static_cast<std::size_t>(fields * width) + static_cast<std::size_t>(field * width) + slot % w;
}

/// Neighbouring fields of one lane, `lane` pointing at its first field of all.
template <std::size_t count>
void put(double* lane, int width, int field, const std::array<double, count>& values) {
    for (std::size_t i = 0; i < count; ++i) lane[(field + static_cast<int>(i)) * width] = values[i];
}

template <std::size_t count>
void get(const double* lane, int width, int field, std::array<double, count>& values) {
    for (std::size_t i = 0; i < count; ++i) values[i] = lane[(field + static_cast<int>(i)) * width];
}

/// Root of i, shortening the way for the next who asks.
std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// No more lanes than it takes to hold the largest set of equal floes.
int useful_width(std::size_t most_floes, int width) {
    int useful = 1;
    while (useful < width && static_cast<std::size_t>(useful) < most_floes) useful *= 2;
    return useful;
}

}  // namespace

LaneSystem::LaneSystem(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, int width)
    : slot_of_body_(bodies.size()), slot_of_joint_(joints.size()), block_of_body_(bodies.size()) {
    std::map<std::pair<std::size_t, std::vector<std::int32_t>>, std::size_t> kind_of;
    std::vector<std::vector<Floe>> kinds;  // floes with the same bodies and joints, in order of appearance
    std::size_t most_floes = 1;
    for (Floe& floe : find_floes(bodies, joints)) {
        const auto [found, added] = kind_of.try_emplace({floe.bodies.size(), floe.pairs}, kinds.size());
        if (added) kinds.emplace_back();
        std::vector<Floe>& kind = kinds[found->second];
        kind.push_back(std::move(floe));
        if (!kind.back().joints.empty()) most_floes = std::max(most_floes, kind.size());
    }
    kernels_ = &lane_kernels(useful_width(most_floes, width));
    lay_out(bodies, joints, kinds);
}

std::vector<LaneSystem::Floe> LaneSystem::find_floes(std::span<const SolverBody> bodies,
                                                     std::span<const SolverJoint> joints) const {
    std::vector<std::uint32_t> parent(bodies.size());
    std::iota(parent.begin(), parent.end(), 0U);
    for (const SolverJoint& joint : joints) {
        const std::uint32_t a = root(parent, joint.a);
        const std::uint32_t b = root(parent, joint.b);
        parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<Floe> floes;
    std::vector<std::size_t> floe_of(bodies.size());
    std::vector<std::int32_t> within(bodies.size());
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        const std::uint32_t first = root(parent, body);
        if (first == body) {
            floe_of[body] = floes.size();
            floes.emplace_back();
        }
        Floe& floe = floes[floe_of[body] = floe_of[first]];
        within[body] = static_cast<std::int32_t>(floe.bodies.size());
        floe.bodies.push_back(body);
    }
    for (std::uint32_t joint = 0; joint < joints.size(); ++joint) {
        Floe& floe = floes[floe_of[joints[joint].a]];
        floe.joints.push_back(joint);
        floe.pairs.push_back(within[joints[joint].a]);
        floe.pairs.push_back(within[joints[joint].b]);
    }
    return floes;
}

void LaneSystem::lay_out(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints,
                         const std::vector<std::vector<Floe>>& kinds) {
    const auto lanes = static_cast<std::size_t>(width());
    std::size_t joint_groups = 0;
    std::vector<std::size_t> pairs_at;
    for (const std::vector<Floe>& kind : kinds) {
        const std::size_t pairs = pairs_.size();
        pairs_.insert(pairs_.end(), kind.front().pairs.begin(), kind.front().pairs.end());
        for (std::size_t first = 0; first < kind.size(); first += lanes) {
            const LaneBlock block{nullptr, static_cast<std::int32_t>(kind.front().joints.size()),
                                  static_cast<std::int32_t>(kind.front().bodies.size()), body_groups_, joint_groups};
            for (std::size_t lane = 0; lane < lanes && first + lane < kind.size(); ++lane) {
                const Floe& floe = kind[first + lane];
                for (std::size_t i = 0; i < floe.bodies.size(); ++i) {
                    slot_of_body_[floe.bodies[i]] = static_cast<std::uint32_t>((body_groups_ + i) * lanes + lane);
                    block_of_body_[floe.bodies[i]] = static_cast<std::uint32_t>(blocks_.size());
                }
                for (std::size_t i = 0; i < floe.joints.size(); ++i) {
                    slot_of_joint_[floe.joints[i]] = static_cast<std::uint32_t>((joint_groups + i) * lanes + lane);
                }
            }
            blocks_.push_back(block);
            pairs_at.push_back(pairs);
            body_groups_ += kind.front().bodies.size();
            joint_groups += kind.front().joints.size();
        }
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i) blocks_[i].pairs = pairs_.data() + pairs_at[i];
    touched_.resize(blocks_.size());

    body_ = AlignedArray<double>(body_groups_ * lanes * body_field::count);
    sweep_ = AlignedArray<double>(body_groups_ * lanes * sweep_field::count);
    delta_ = AlignedArray<double>(body_groups_ * lanes * 8);
    frame_ = AlignedArray<double>(joint_groups * lanes * frame_field::count);
    row_ = AlignedArray<double>(joint_groups * lanes * row_field::count);
    reaction_ = AlignedArray<double>(joint_groups * lanes * reaction_field::count);
    // Empty lanes are computed like the others: they need rotations, so that nothing in them is infinite or slow.
    for (std::size_t slot = 0; slot < body_groups_ * lanes; ++slot) {
        for (int i = 0; i < 9; i += 4) {
            body_[place(static_cast<std::uint32_t>(slot), body_field::count, body_field::rotation + i, width())] = 1;
        }
    }
    for (std::size_t slot = 0; slot < joint_groups * lanes; ++slot) {
        fill(slot, SolverJoint{});
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        sweep_[place(slot_of_body_[i], sweep_field::count, sweep_field::inverse_mass, width())] =
            bodies[i].inverse_mass;
        for (int k = 0; k < 3; ++k) {
            body_[place(slot_of_body_[i], body_field::count, body_field::inverse_inertia + k, width())] =
                bodies[i].inverse_inertia[static_cast<std::size_t>(k)];
        }
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        fill(slot_of_joint_[i], joints[i]);
        frame_[place(slot_of_joint_[i], frame_field::count, frame_field::alive, width())] = 1;
    }
}

void LaneSystem::fill(std::size_t slot, const SolverJoint& joint) {
    const auto at = static_cast<std::uint32_t>(slot);
    const auto put = [&](int field, double value) { frame_[place(at, frame_field::count, field, width())] = value; };
    for (int i = 0; i < 9; ++i) {
        put(frame_field::rotation_a + i, joint.in_a.rotation[static_cast<std::size_t>(i)]);
        put(frame_field::rotation_b + i, joint.in_b.rotation[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i < 3; ++i) {
        put(frame_field::origin_a + i, joint.in_a.origin[static_cast<std::size_t>(i)]);
        put(frame_field::origin_b + i, joint.in_b.origin[static_cast<std::size_t>(i)]);
    }
    put(frame_field::erp, joint.erp);
    row_[place(at, row_field::count, row_field::cfm, width())] = joint.cfm;
}

LaneArrays LaneSystem::arrays() {
    return {body_.data(), sweep_.data(), frame_.data(), row_.data(), reaction_.data(), delta_.data()};
}

void LaneSystem::remove_joint(std::size_t joint) {
    frame_[place(slot_of_joint_[joint], frame_field::count, frame_field::alive, width())] = 0;
    for (int field = 0; field < 6; ++field) {
        reaction_[place(slot_of_joint_[joint], reaction_field::count, field, width())] = 0;
    }
}

void LaneSystem::set_state(std::size_t body, const SolverState& state) {
    double* to = body_.data() + place(slot_of_body_[body], body_field::count, 0, width());
    put(to, width(), body_field::position, state.position);
    put(to, width(), body_field::rotation, state.rotation);
    put(to, width(), body_field::velocity, state.velocity);
    put(to, width(), body_field::spin, state.spin);
}

void LaneSystem::set_force(std::size_t body, const std::array<double, 3>& force, const std::array<double, 3>& torque) {
    double* to = body_.data() + place(slot_of_body_[body], body_field::count, 0, width());
    put(to, width(), body_field::force, force);
    put(to, width(), body_field::torque, torque);
}

SolverState LaneSystem::state(std::size_t body) const {
    const double* from = body_.data() + place(slot_of_body_[body], body_field::count, 0, width());
    SolverState state;
    get(from, width(), body_field::position, state.position);
    get(from, width(), body_field::rotation, state.rotation);
    get(from, width(), body_field::velocity, state.velocity);
    get(from, width(), body_field::spin, state.spin);
    return state;
}

void LaneSystem::advance() {
    kernels_->advance_bodies(arrays(), body_groups_, time_step_);
}

void LaneSystem::prepare(double time_step) {
    time_step_ = time_step;
    kernels_->prepare_bodies(arrays(), body_groups_, time_step);
    for (const LaneBlock& block : blocks_) kernels_->prepare_joints(arrays(), block, time_step);
}

void LaneSystem::sort_blocks(std::span<const SolverContact> contacts) {
    std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
    for (const SolverContact& contact : contacts)
        touched_[block_of_body_[contact.a]] = touched_[block_of_body_[contact.b]] = 1;
    touched_blocks_.clear();
    free_blocks_.clear();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].joints > 0) (touched_[i] != 0 ? touched_blocks_ : free_blocks_).push_back(blocks_[i]);
    }
}

void LaneSystem::solve(std::span<SolverContact> contacts, const ContactRules& rules, int iterations) {
    const LaneArrays all = arrays();
    sort_blocks(contacts);
    std::fill_n(delta_.data(), delta_.size(), 0.0);
    contact_rows_.prepare(contacts, slot_of_body_, body_groups_ * static_cast<std::size_t>(width()), all, width(),
                          rules, time_step_);
    contact_rows_.solve_penetrations(*kernels_, iterations);

    // Floes that touch nothing are on their own: all their sweeps at once, while they are in the nearest cache.
    for (std::size_t i = 0; i < free_blocks_.size(); i += 2) {
        kernels_->sweep(all, &free_blocks_[i], std::min<std::size_t>(2, free_blocks_.size() - i), iterations);
    }
    for (const LaneBlock& block : touched_blocks_) kernels_->from_contacts(all, block);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        kernels_->sweep(all, touched_blocks_.data(), touched_blocks_.size(), 1);
        for (const LaneBlock& block : touched_blocks_) kernels_->to_contacts(all, block);
        contact_rows_.sweep(*kernels_, all.delta);
        for (const LaneBlock& block : touched_blocks_) kernels_->from_contacts(all, block);
    }
    for (const LaneBlock& block : blocks_) {
        if (block.joints == 0) kernels_->from_contacts(all, block);
        kernels_->reactions(all, block, time_step_);
    }
    contact_rows_.finish(contacts);
}

SolverReaction LaneSystem::reaction(std::size_t joint) const {
    const double* from = reaction_.data() + place(slot_of_joint_[joint], reaction_field::count, 0, width());
    SolverReaction reaction;
    get(from, width(), reaction_field::force, reaction.force);
    get(from, width(), reaction_field::moment, reaction.moment);
    return reaction;
}

}  // namespace floes
