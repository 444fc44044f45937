// How floes go into lanes: found by their joints, sorted by pattern, laid out in blocks.

#include <algorithm>
#include <map>

#include "core/vector.hpp"
#include "solver/lane_slot.hpp"
#include "solver/lane_system.hpp"
#include "solver/lane_width.hpp"

namespace floes {

/// Bodies and joints of a floe, in the order of their indices.
struct LaneSystem::Floe {
    std::vector<std::uint32_t> bodies;
    std::vector<std::uint32_t> joints;
    std::vector<std::int32_t> pairs;  ///< bodies a, b of each joint, counted within the floe
};

namespace {

/// No more lanes than it takes to hold the largest set of equal floes.
int useful_width(std::size_t most_floes, int width) {
    int useful = 1;
    while (useful < width && static_cast<std::size_t>(useful) < most_floes) useful *= 2;
    return useful;
}

}  // namespace

LaneSystem::LaneSystem(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, int width,
                       SolverKind solver)
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
    const std::size_t joint_groups = place_blocks(kinds);
    make_arrays(joint_groups);
    fill(bodies, joints);
    if (solver == SolverKind::lanes) return;
    direct_.emplace(bodies, joints, LaneSlots{slot_of_body_, slot_of_joint_, body_groups_, joint_groups}, *kernels_);
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

std::size_t LaneSystem::place_blocks(const std::vector<std::vector<Floe>>& kinds) {
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
        if (bodies[i].rail >= 0) rails_.emplace_back(slot_of_body_[i], bodies[i].rail);
        const auto put = [&](int field, double value) {
            body_[place(slot_of_body_[i], body_field::count, field, width())] = value;
        };
        for (int k = 0; k < 3; ++k) {
            put(body_field::inverse_inertia + k, bodies[i].inverse_inertia[static_cast<std::size_t>(k)]);
            put(body_field::half_extent + k, bodies[i].half_extent[static_cast<std::size_t>(k)]);
        }
        put(body_field::crushing_pressure, bodies[i].crushing_pressure);
        force_[i * force_field::count + force_field::weight] = bodies[i].weight;
        set_state(i, {});
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        fill(slot_of_joint_[i], joints[i]);
        frame_[place(slot_of_joint_[i], frame_field::count, frame_field::alive, width())] = 1;
        bodies_of_joint_.emplace_back(joints[i].a, joints[i].b);
        if (!bodies[joints[i].a].is_prism) cover(i, 1);
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

}  // namespace floes
