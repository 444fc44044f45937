#include "arrangement/jittered_lattice.hpp"

#include <fmt/format.h>

#include <numbers>

#include "arrangement/cells.hpp"
#include "arrangement/starts.hpp"
#include "core/error.hpp"

namespace floes {

namespace {

constexpr int trials = 10'000;

PlanarPose jittered(const PlanarPose& site, const Jitter& jitter, RandomStream& random) {
    PlanarPose pose = site;
    pose.x += random.uniform(-jitter.shift, jitter.shift);
    pose.z += random.uniform(-jitter.shift, jitter.shift);
    pose.yaw += random.uniform(-jitter.turn, jitter.turn);
    return pose;
}

}  // namespace

std::vector<PlanarPose> jittered_lattice(const Walls& walls, std::span<const Rectangle> shapes, double clearance,
                                         const Jitter& jitter, RandomStream& random) {
    std::vector<PlanarPose> poses = lattice_start(walls, covering(shapes), clearance, static_cast<int>(shapes.size()));
    if (jitter.shift == 0 && jitter.turn == 0) return poses;
    const Walls room = walls.shrunk(clearance);
    std::vector<Rectangle> grown;
    for (const Rectangle& shape : shapes) grown.push_back(shape.grown(0.5 * clearance));
    Cells cells({walls.low_x, walls.low_z, walls.length, walls.breadth}, 2 * widest_reach(grown), poses.size());
    const auto resident = [&](std::size_t floe, const PlanarPose& pose) {
        return Resident{pose.x, pose.z, turn_of(pose.yaw), static_cast<int>(floe)};
    };
    for (std::size_t floe = 0; floe < poses.size(); ++floe) cells.insert(resident(floe, poses[floe]));
    const auto place = [&](std::size_t floe, const PlanarPose& pose) {
        const Resident moved = resident(floe, pose);
        const auto hit = [&](const Resident& other) {
            const Rectangle& shape = grown[static_cast<std::size_t>(other.floe)];
            return other.floe != moved.floe &&
                   overlap({grown[floe], moved.turn}, {shape, other.turn}, other.x - moved.x, other.z - moved.z);
        };
        if (!room.admits(shapes[floe], pose.x, pose.z, moved.turn) || cells.any_near(pose.x, pose.z, hit)) return false;
        poses[floe] = pose;
        cells.move(moved);
        return true;
    };
    // A floe moves while later ones are still on their sites, so floes never overlap in between.
    for (std::size_t floe = 0; floe < poses.size(); ++floe) {
        const PlanarPose site = poses[floe];
        int trial = 0;
        while (!place(floe, jittered(site, jitter, random))) {
            if (++trial < trials) continue;
            throw InputError(
                fmt::format("the jittered lattice has no room for floe {} of {} ({} trials with shifts up to {} m and "
                            "turns up to {:.4g}°); "
                            "lower arrangement.jitter_m or arrangement.jitter_deg, or use arrangement.method = "
                            "\"monte_carlo\"",
                            floe, shapes.size(), trials, jitter.shift, jitter.turn * 180 / std::numbers::pi));
        }
    }
    return poses;
}

}  // namespace floes
