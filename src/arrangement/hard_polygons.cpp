#include "arrangement/hard_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/turn.hpp"

namespace floes {
namespace {

void lie(Corners own, double x, double z, Turn turn, Outline& corners) {
    corners.clear();
    for (const Corner& one : own)
        corners.push_back({x + one.x * turn.cos + one.z * turn.sin, z - one.x * turn.sin + one.z * turn.cos});
}

bool are_within(const Walls& walls, Corners corners) {
    return std::ranges::all_of(corners, [&](const Corner& one) {
        return one.x >= walls.low_x && one.x <= walls.low_x + walls.length && one.z >= walls.low_z &&
               one.z <= walls.low_z + walls.breadth;
    });
}

/// Whether an edge of one has the whole other on its far side.
bool has_parting_edge(Corners one, Corners other) {
    for (std::size_t k = 0; k < one.size(); ++k) {
        const Corner along = after(one, k) - one[k];
        const Corner normal{along.z, -along.x};
        const double edge = dot(normal, one[k]);
        if (std::ranges::all_of(other, [&](const Corner& corner) { return dot(normal, corner) >= edge; })) return true;
    }
    return false;
}

double widest_reach(std::span<const Outline> outlines, double margin) {
    double widest = 0;
    for (const Outline& one : outlines) widest = std::max(widest, reach_of(grown(one, margin)));
    return widest;
}

}  // namespace

bool overlap(Corners a, Corners b) {
    return !has_parting_edge(a, b) && !has_parting_edge(b, a);
}

HardPolygons::HardPolygons(const Walls& walls, std::span<const Outline> outlines, double clearance,
                           std::span<const PlanarPose> poses)
    : walls_(walls),
      widest_(widest_reach(outlines, 0.5 * clearance)),
      poses_(poses.begin(), poses.end()),
      cells_({walls.low_x, walls.low_z, walls.length, walls.breadth}, 2 * widest_, poses.size()) {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        const Turn turn = turn_of(poses_[i].yaw);
        Body& body = bodies_.emplace_back(Body{outlines[i], grown(outlines[i], 0.5 * clearance), {}, 0});
        body.reach = reach_of(body.larger);
        lie(body.larger, poses_[i].x, poses_[i].z, turn, body.corners);
        cells_.insert({poses_[i].x, poses_[i].z, turn, static_cast<int>(i)});
    }
}

int HardPolygons::sweep(const Step& step, RandomStream& random) {
    int accepted = 0;
    for (std::size_t i = 0; i < poses_.size(); ++i) accepted += try_move(i, step, random);
    return accepted;
}

bool HardPolygons::try_move(std::size_t polygon, const Step& step, RandomStream& random) {
    PlanarPose pose = poses_[polygon];
    pose.x += step.shift * (2 * random.uniform() - 1);
    pose.z += step.shift * (2 * random.uniform() - 1);
    pose.yaw += step.turn * (2 * random.uniform() - 1);
    Body& body = bodies_[polygon];
    const Resident trial{pose.x, pose.z, turn_of(pose.yaw), static_cast<int>(polygon)};
    lie(body.own, pose.x, pose.z, trial.turn, trial_);  // at its actual size: the walls have the whole clearance
    if (!are_within(walls_, trial_)) return false;
    lie(body.larger, pose.x, pose.z, trial.turn, trial_);
    if (hits_another(trial, trial_)) return false;
    std::swap(body.corners, trial_);
    poses_[polygon] = {pose.x, pose.z, std::remainder(pose.yaw, 2 * std::numbers::pi)};
    cells_.move(trial);
    return true;
}

bool HardPolygons::hits_another(const Resident& trial, Corners corners) const {
    const double reach = bodies_[static_cast<std::size_t>(trial.floe)].reach;
    return cells_.any_near(trial.x, trial.z, [&](const Resident& other) {
        if (other.floe == trial.floe) return false;
        const Body& body = bodies_[static_cast<std::size_t>(other.floe)];
        const Corner apart{other.x - trial.x, other.z - trial.z};
        const double both = reach + body.reach;
        return dot(apart, apart) < both * both && overlap(corners, body.corners);
    });
}

}  // namespace floes
