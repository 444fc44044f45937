#include "solver/lane_system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "core/vector.hpp"
#include "solver/lane_width.hpp"

namespace floes {

namespace {

/// Neighbouring fields of one lane, `lane` pointing at its first field of all.
template <std::size_t count>
void put(double* lane, int width, int field, const std::array<double, count>& values) {
    for (std::size_t i = 0; i < count; ++i) lane[(field + static_cast<int>(i)) * width] = values[i];
}

template <std::size_t count>
void get(const double* lane, int width, int field, std::array<double, count>& values) {
    for (std::size_t i = 0; i < count; ++i) values[i] = lane[(field + static_cast<int>(i)) * width];
}

}  // namespace

LaneArrays LaneSystem::arrays() {
    return {body_.data(),  sweep_.data(), frame_.data(),  row_.data(),         reaction_.data(),
            delta_.data(), force_.data(), motion_.data(), body_of_slot_.data()};
}

void LaneSystem::remove_joint(std::size_t joint) {
    FLOES_EXPECTS(joint < slot_of_joint_.size());
    double& alive = frame_[place(slot_of_joint_[joint], frame_field::count, frame_field::alive, width())];
    if (alive > 0) cover(joint, -1);
    alive = 0;
    if (direct_) direct_->remove_joint(joint);
    for (int field = 0; field < 6; ++field) {
        reaction_[place(slot_of_joint_[joint], reaction_field::count, field, width())] = 0;
    }
}

void LaneSystem::soften_joint(std::size_t joint, double sound) {
    FLOES_EXPECTS(joint < slot_of_joint_.size() && sound > 0 && sound <= 1);
    if (!direct_) throw RunError("Only the direct solver softens joints.");
    direct_->soften_joint(joint, sound);
}

void LaneSystem::set_water(std::size_t body, const CarriedWater& water) {
    if (!direct_) throw RunError("Only the direct solver lets bodies carry water.");
    direct_->set_water(body, water);
}

void LaneSystem::cover(std::size_t joint, double more) {
    const auto [a, b] = bodies_of_joint_[joint];
    const double* frame = frame_.data() + place(slot_of_joint_[joint], frame_field::count, 0, width());
    // The joint's x axis in each body: out of a's face, and into b's.
    for (const auto& [body, rotation, outward] :
         {std::tuple(a, frame_field::rotation_a, 1.0), std::tuple(b, frame_field::rotation_b, -1.0)}) {
        if (!is_moving_box_[body]) continue;
        std::array<double, 9> to_body{};
        get(frame, width(), rotation, to_body);
        const std::array<double, 3> x{outward * to_body[0], outward * to_body[3], outward * to_body[6]};
        int axis = 0;
        for (int k = 1; k < 3; ++k) {
            if (std::abs(x[static_cast<std::size_t>(k)]) > std::abs(x[static_cast<std::size_t>(axis)])) axis = k;
        }
        const int face = x[static_cast<std::size_t>(axis)] > 0 ? axis : axis + 3;
        body_[place(slot_of_body_[body], body_field::count, body_field::covered + face, width())] += more;
    }
}

void LaneSystem::set_state(std::size_t body, const SolverState& state) {
    FLOES_EXPECTS(body < slot_of_body_.size());
    double* to = body_.data() + place(slot_of_body_[body], body_field::count, 0, width());
    put(to, width(), body_field::position, state.position);
    put(to, width(), body_field::rotation, state.rotation);
    put(to, width(), body_field::velocity, state.velocity);
    put(to, width(), body_field::angular_velocity, state.angular_velocity);
    BodyMotion& motion = motion_[body];
    std::ranges::copy(state.position, motion.position);
    std::ranges::copy(state.rotation, motion.rotation);
    std::ranges::copy(state.velocity, motion.velocity);
    std::ranges::copy(state.angular_velocity, motion.angular_velocity);
}

void LaneSystem::add_force(std::size_t body, const std::array<double, 3>& force, const std::array<double, 3>& torque) {
    double* to = force_.data() + body * force_field::count;
    for (std::size_t i = 0; i < 3; ++i) {
        to[force_field::force + i] += force[i];
        to[force_field::torque + i] += torque[i];
    }
}

SolverState LaneSystem::state(std::size_t body) const {
    FLOES_EXPECTS(body < slot_of_body_.size());
    const BodyMotion& motion = motion_[body];
    return {std::to_array(motion.position), std::to_array(motion.rotation), std::to_array(motion.velocity),
            std::to_array(motion.angular_velocity)};
}

void LaneSystem::take_over(LaneSystem&& other, std::span<const std::size_t> joints) {
    FLOES_EXPECTS(joints.size() == joint_count());
    contact_rows_ = std::move(other.contact_rows_);
    direct_contacts_ = std::move(other.direct_contacts_);
    for (std::size_t i = 0; i < other.body_count(); ++i) {
        set_state(i, other.state(i));
        motion_[i].way = other.motion_[i].way;
        motion_[i].turn = other.motion_[i].turn;
        const double* from = other.force_.data() + i * force_field::count;
        double* to = force_.data() + i * force_field::count;
        for (int field = 0; field < force_field::count; ++field) {
            if (field != force_field::weight) to[field] = from[field];
        }
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i] >= other.joint_count()) continue;
        const auto [force, moment] = other.reaction(joints[i]);
        double* to = reaction_.data() + place(slot_of_joint_[i], reaction_field::count, 0, width());
        put(to, width(), reaction_field::force, force);
        put(to, width(), reaction_field::moment, moment);
    }
}

void LaneSystem::advance() {
    kernels_->advance_bodies(arrays(), body_groups_, time_step_);
}

void LaneSystem::prepare(double time_step) {
    FLOES_EXPECTS(time_step > 0);
    time_step_ = time_step;
    kernels_->prepare_bodies(arrays(), body_groups_, time_step);
    if (direct_) {
        direct_->prepare(arrays(), time_step);
        return;
    }
    for (const LaneBlock& block : blocks_) kernels_->prepare_joints(arrays(), block, time_step);
}

void LaneSystem::find_touched(std::span<const SolverContact> contacts) {
    std::fill(block_touched_.begin(), block_touched_.end(), std::uint8_t{0});
    std::fill(group_touched_.begin(), group_touched_.end(), std::uint8_t{0});
    const auto lanes = static_cast<std::uint32_t>(width());
    for (const SolverContact& contact : contacts) {
        for (const std::uint32_t body : {contact.a, contact.b}) {
            block_touched_[block_of_body_[body]] = 1;
            group_touched_[slot_of_body_[body] / lanes] = 1;
        }
    }
    touched_groups_.clear();
    for (std::uint32_t i = 0; i < group_touched_.size(); ++i) {
        if (group_touched_[i] != 0) touched_groups_.push_back(i);
    }
    touched_blocks_.clear();
    free_blocks_.clear();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].joints > 0) (block_touched_[i] != 0 ? touched_blocks_ : free_blocks_).push_back(blocks_[i]);
    }
}

/// Bodies on rails keep of their velocity changes what is along them: one row of the sweep, solved exactly.
void LaneSystem::keep_on_rails() {
    for (const auto& [slot, axis] : rails_) {
        double* change = delta_.data() + 8 * static_cast<std::size_t>(slot);
        for (int i = 0; i < 3; ++i)
            if (i != axis) change[i] = 0;
        std::fill_n(change + 4, 3, 0.0);
    }
}

int LaneSystem::solve(std::span<SolverContact> contacts, const ContactLaw& law, const Sweeps& sweeps) {
    if (direct_) return solve_directly(contacts, law, sweeps);
    const int iterations = sweeps.most;
    const LaneArrays all = arrays();
    find_touched(contacts);
    kernels_->to_contacts(all, touched_groups_.data(), touched_groups_.size());
    contact_rows_.prepare(contacts, slot_of_body_, body_groups_ * static_cast<std::size_t>(width()), all, *kernels_,
                          law, time_step_);
    contact_rows_.start(*kernels_, all.delta);
    contact_rows_.solve_penetrations(*kernels_, iterations);

    // Floes without contacts are independent: all their sweeps at once, while their data are in the first-level cache.
    for (std::size_t i = 0; i < free_blocks_.size(); i += 2) {
        kernels_->sweep(all, &free_blocks_[i], std::min<std::size_t>(2, free_blocks_.size() - i), iterations);
    }
    kernels_->from_contacts(all, touched_groups_.data(), touched_groups_.size());
    for (int iteration = 0; iteration < iterations; ++iteration) {
        kernels_->sweep(all, touched_blocks_.data(), touched_blocks_.size(), 1);
        kernels_->to_contacts(all, touched_groups_.data(), touched_groups_.size());
        contact_rows_.sweep(*kernels_, all.delta);
        keep_on_rails();
        kernels_->from_contacts(all, touched_groups_.data(), touched_groups_.size());
    }
    for (const LaneBlock& block : blocks_) kernels_->reactions(all, block, time_step_);
    contact_rows_.finish(contacts);
    return iterations;
}

int LaneSystem::solve_directly(std::span<SolverContact> contacts, const ContactLaw& law, const Sweeps& sweeps) {
    const LaneArrays all = arrays();
    direct_->touch(all, contacts);
    direct_contacts_.prepare(contacts, all, *direct_, *kernels_, law, time_step_);
    const int used = direct_contacts_.solve(all, *direct_, *kernels_, sweeps);
    direct_->finish(all);
    direct_contacts_.finish(contacts);
    return used;
}

SolverReaction LaneSystem::reaction(std::size_t joint) const {
    FLOES_EXPECTS(joint < slot_of_joint_.size());
    const double* from = reaction_.data() + place(slot_of_joint_[joint], reaction_field::count, 0, width());
    SolverReaction reaction;
    get(from, width(), reaction_field::force, reaction.force);
    get(from, width(), reaction_field::moment, reaction.moment);
    return reaction;
}

// How floes go into lanes: found by their joints, sorted by pattern, laid out in blocks.

/// Bodies and joints of a floe, in the order of their indices.
struct LaneSystem::Floe {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> joints;
    std::vector<std::int32_t> pairs;  ///< bodies a, b of each joint, counted within the floe
};

LaneSystem::LaneSystem(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, int width,
                       SolverKind solver)
    : kernels_(&lane_kernels(width)),
      slot_of_body_(bodies.size()),
      slot_of_joint_(joints.size()),
      block_of_body_(bodies.size()) {
    const bool direct = solver == SolverKind::direct;
    make_arrays(direct ? place_by_number() : place_floes(find_floes(bodies, joints)));
    fill(bodies, joints);
    if (direct) direct_.emplace(bodies, joints, *kernels_);
}

std::size_t LaneSystem::place_by_number() {
    std::iota(slot_of_body_.begin(), slot_of_body_.end(), 0U);
    std::iota(slot_of_joint_.begin(), slot_of_joint_.end(), 0U);
    body_groups_ = groups_of(slot_of_body_.size(), width());
    return groups_of(slot_of_joint_.size(), width());
}

std::size_t LaneSystem::place_floes(std::vector<Floe> floes) {
    std::map<std::pair<std::size_t, std::vector<std::int32_t>>, std::size_t> kind_of;
    std::vector<std::vector<Floe>> kinds;  // floes with the same bodies and joints, in order of appearance
    std::size_t most_floes = 1;
    for (Floe& floe : floes) {
        const auto [found, added] = kind_of.try_emplace({floe.bodies.size(), floe.pairs}, kinds.size());
        if (added) kinds.emplace_back();
        std::vector<Floe>& kind = kinds[found->second];
        kind.push_back(std::move(floe));
        if (!kind.back().joints.empty()) most_floes = std::max(most_floes, kind.size());
    }
    // No more lanes than it takes to hold the largest set of equal floes.
    kernels_ = &lane_kernels(std::min(width(), static_cast<int>(std::bit_ceil(most_floes))));
    std::size_t joint_groups = 0;
    for (std::vector<Floe>& kind : kinds) joint_groups = place_equal(kind, joint_groups);
    return joint_groups;
}

std::vector<LaneSystem::Floe> LaneSystem::find_floes(std::span<const SolverBody> bodies,
                                                     std::span<const SolverJoint> joints) const {
    Components components(bodies.size());
    for (const SolverJoint& joint : joints) components.connect(joint.a, joint.b);
    std::vector<Floe> floes;
    std::vector<std::size_t> floe_of(bodies.size());
    std::vector<std::int32_t> within(bodies.size());
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        const std::size_t first = components.first(body);
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

std::size_t LaneSystem::place_equal(std::vector<Floe>& floes, std::size_t joint_groups) {
    const auto lanes = static_cast<std::size_t>(width());
    const std::size_t bodies = floes.front().bodies.size();
    const std::size_t joints = floes.front().joints.size();
    const std::int32_t* pairs = pairs_.emplace_back(std::move(floes.front().pairs)).data();
    for (std::size_t first = 0; first < floes.size(); first += lanes) {
        for (std::size_t lane = 0; lane < lanes && first + lane < floes.size(); ++lane) {
            const Floe& floe = floes[first + lane];
            for (std::size_t i = 0; i < bodies; ++i) {
                slot_of_body_[floe.bodies[i]] = static_cast<std::uint32_t>((body_groups_ + i) * lanes + lane);
                block_of_body_[floe.bodies[i]] = static_cast<std::uint32_t>(blocks_.size());
            }
            for (std::size_t i = 0; i < joints; ++i)
                slot_of_joint_[floe.joints[i]] = static_cast<std::uint32_t>((joint_groups + i) * lanes + lane);
        }
        blocks_.push_back(
            {pairs, static_cast<std::int32_t>(joints), static_cast<std::int32_t>(bodies), body_groups_, joint_groups});
        body_groups_ += bodies;
        joint_groups += joints;
    }
    return joint_groups;
}

void LaneSystem::make_arrays(std::size_t joint_groups) {
    const auto lanes = static_cast<std::size_t>(width());
    block_touched_.resize(blocks_.size());
    group_touched_.resize(body_groups_);
    body_ = AlignedArray<double>(body_groups_ * lanes * body_field::count);
    sweep_ = AlignedArray<double>(body_groups_ * lanes * sweep_field::count);
    delta_ = AlignedArray<double>((body_groups_ * lanes + 1) * 8);
    force_ = AlignedArray<double>((slot_of_body_.size() + 1) * force_field::count);
    motion_ = AlignedArray<BodyMotion>(slot_of_body_.size() + 1);
    body_of_slot_.assign(body_groups_ * lanes, static_cast<std::uint32_t>(slot_of_body_.size()));
    for (std::uint32_t body = 0; body < slot_of_body_.size(); ++body) body_of_slot_[slot_of_body_[body]] = body;
    frame_ = AlignedArray<double>(joint_groups * lanes * frame_field::count);
    row_ = AlignedArray<double>(joint_groups * lanes * row_field::count);
    reaction_ = AlignedArray<double>(joint_groups * lanes * reaction_field::count);
    // Empty lanes are computed like the others and need rotations: infinities would make them slow.
    for (std::size_t slot = 0; slot < body_groups_ * lanes; ++slot) {
        for (int i = 0; i < 9; i += 4) {
            body_[place(static_cast<std::uint32_t>(slot), body_field::count, body_field::rotation + i, width())] = 1;
        }
    }
    for (std::size_t slot = 0; slot < joint_groups * lanes; ++slot) fill(slot, SolverJoint{});
}

void LaneSystem::fill(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        sweep_[place(slot_of_body_[i], sweep_field::count, sweep_field::inverse_mass, width())] =
            bodies[i].inverse_mass;
        is_moving_box_.push_back(bodies[i].inverse_mass > 0 && !bodies[i].is_prism);
        if (bodies[i].rail >= 0) rails_.emplace_back(slot_of_body_[i], bodies[i].rail);
        double* body = body_.data() + place(slot_of_body_[i], body_field::count, 0, width());
        put(body, width(), body_field::inverse_inertia, bodies[i].inverse_inertia);
        put(body, width(), body_field::half_extent, bodies[i].half_extent);
        body[body_field::crushing_pressure * width()] = bodies[i].crushing_pressure;
        force_[i * force_field::count + force_field::weight] = bodies[i].weight;
        set_state(i, {});
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        fill(slot_of_joint_[i], joints[i]);
        frame_[place(slot_of_joint_[i], frame_field::count, frame_field::alive, width())] = 1;
        bodies_of_joint_.emplace_back(joints[i].a, joints[i].b);
        cover(i, 1);
    }
}

void LaneSystem::fill(std::size_t slot, const SolverJoint& joint) {
    const auto at = static_cast<std::uint32_t>(slot);
    double* frame = frame_.data() + place(at, frame_field::count, 0, width());
    put(frame, width(), frame_field::rotation_a, joint.in_a.rotation);
    put(frame, width(), frame_field::origin_a, joint.in_a.origin);
    put(frame, width(), frame_field::rotation_b, joint.in_b.rotation);
    put(frame, width(), frame_field::origin_b, joint.in_b.origin);
    frame[frame_field::erp * width()] = joint.erp;
    row_[place(at, row_field::count, row_field::cfm, width())] = joint.cfm;
}

void LaneSystem::archive(StateArchive& state) {
    auto& [kernels, pairs, blocks, slot_of_body, slot_of_joint, rails, bodies_of_joint, moving_box, block_of_body,
           block_touched, group_touched, touched_groups, touched_blocks, free_blocks, body_groups, time_step, body,
           sweep, frame, row, reaction, delta, force, motion, body_of_slot, contact_rows, direct, direct_contacts] =
        *this;
    state.same(slot_of_body.size());
    state.same(slot_of_joint.size());
    state(time_step);
    const int width = kernels->width;
    archive_slots(state, body, slot_of_body, body_field::count, width);
    archive_slots(state, reaction, slot_of_joint, reaction_field::count, width);
    for (const std::uint32_t slot : slot_of_body)
        for (std::size_t i = 0; i < 8; ++i) state(delta[8 * std::size_t{slot} + i]);
    for (std::size_t i = 0; i < slot_of_body.size() * force_field::count; ++i) state(force[i]);
    for (std::size_t i = 0; i < slot_of_body.size(); ++i) {
        auto& [position, rotation, velocity, angular_velocity, way, turn, unused] = motion[i];
        state(position, rotation, velocity, angular_velocity, way, turn);
    }
    if (direct) {
        direct->archive(state);
        return;
    }
    archive_slots(state, sweep, slot_of_body, sweep_field::count, width);
    archive_slots(state, row, slot_of_joint, row_field::count, width);
}

}  // namespace floes
