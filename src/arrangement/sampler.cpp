#include "arrangement/sampler.hpp"

#include <algorithm>
#include <numbers>

#include "arrangement/crowd.hpp"
#include "core/error.hpp"
#include "core/turn.hpp"

namespace floes {

namespace {

// Tolerance for equal_lengths of equal lengths, m.
constexpr double equal_lengths = 1e-12;

// Columns pushed together, leaning by angle; lengths in m along x and z.
struct Leaning {
    double angle;
    Turn turn;
    double spacing;      // between columns, along x
    double half_extent;  // of one column along x
    double length;       // of both halves
    double breadth;
};

Leaning lean(const LatticeSize& size, const Rectangle& grown, double angle) {
    const Turn turn = turn_of(angle);
    const double half_column = size.rows * grown.half_breadth;
    const double spacing = 2 * grown.half_length / turn.cos;
    const double half_extent = half_column * turn.sin + grown.half_length * turn.cos;
    const double breadth = 2 * (half_column * turn.cos + grown.half_length * turn.sin);
    const int halves = size.columns > 1 ? 2 : 1;
    return {angle, turn, spacing, half_extent, 2 * halves * half_extent + (size.columns - halves) * spacing, breadth};
}

Leaning furthest_lean(const Walls& room, const LatticeSize& size, const Rectangle& grown) {
    constexpr double degree = std::numbers::pi / 180;
    for (int degrees = 22; degrees > 0; --degrees) {
        const Leaning leaning = lean(size, grown, degrees * degree);
        if (leaning.length <= room.length && leaning.breadth <= room.breadth) return leaning;
    }
    return lean(size, grown, 0);
}

}  // namespace

LatticeSize lattice_size(const Walls& walls, const Rectangle& shape, double clearance, int count) {
    LatticeSize best;
    double best_gap = -1;
    for (int rows = 1; rows <= count; ++rows) {
        const int columns = (count + rows - 1) / rows;
        const double gap_x = (walls.length - columns * 2 * shape.half_length) / (columns + 1);
        const double gap_z = (walls.breadth - rows * 2 * shape.half_breadth) / (rows + 1);
        if (std::min(gap_x, gap_z) > best_gap) {
            best_gap = std::min(gap_x, gap_z);
            best = {columns, rows, gap_x, gap_z};
        }
    }
    if (best_gap < clearance - equal_lengths) {
        throw InputError(
            "{} floes of {} m x {} m with a clearance of {} m do not fit on a lattice in a field of {:.3f} m x {:.3f} "
            "m; lower field.concentration_percent or the clearance, or change the width so that whole rows fit",
            count, 2 * shape.half_length, 2 * shape.half_breadth, clearance, walls.length, walls.breadth);
    }
    return best;
}

std::vector<PlanarPose> lattice_start(const Walls& walls, const Rectangle& shape, double clearance, int count) {
    const LatticeSize size = lattice_size(walls, shape, clearance, count);
    std::vector<PlanarPose> poses;
    for (int i = 0; i < count; ++i) {
        const int column = i / size.rows;
        const int row = i % size.rows;
        poses.push_back({walls.low_x + size.gap_x * (column + 1) + shape.half_length * (2 * column + 1),
                         walls.low_z + size.gap_z * (row + 1) + shape.half_breadth * (2 * row + 1), 0});
    }
    return poses;
}

std::vector<PlanarPose> stripes_start(const Walls& walls, const Rectangle& shape, double clearance, int count) {
    const LatticeSize size = lattice_size(walls, shape, clearance, count);
    const Rectangle grown = shape.grown(0.5 * clearance);
    const Walls room = walls.shrunk(0.5 * clearance);
    const Leaning leaning = furthest_lean(room, size, grown);
    const int near_columns = (size.columns + 1) / 2;
    std::vector<PlanarPose> poses;
    for (int i = 0; i < count; ++i) {
        const int column = i / size.rows;
        const bool near = column < near_columns;
        const double along = (2 * (i % size.rows) + 1 - size.rows) * grown.half_breadth;  // from the column's middle
        const double middle = near ? leaning.half_extent + column * leaning.spacing
                                   : 3 * leaning.half_extent + (column - 1) * leaning.spacing;
        poses.push_back({room.low_x + middle + (near ? along : -along) * leaning.turn.sin,
                         room.low_z + 0.5 * leaning.breadth + along * leaning.turn.cos,
                         near ? leaning.angle : -leaning.angle});
    }
    return poses;
}

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
    Cells cells({walls.low_x, walls.low_z, walls.length, walls.breadth},
                2 * std::ranges::max(grown, {}, &Rectangle::half_diagonal).half_diagonal(), poses.size());
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
                "the jittered lattice has no room for floe {} of {} ({} trials with shifts up to {} m and turns up to "
                "{:.4g}°); lower arrangement.jitter_m or arrangement.jitter_deg, or use arrangement.method = "
                "\"monte_carlo\"",
                floe, shapes.size(), trials, jitter.shift, jitter.turn * 180 / std::numbers::pi);
        }
    }
    return poses;
}

namespace {

/// Whether an edge of one has the whole other, moved by `apart`, on its far side.
bool has_parting_edge(Corners one, Corners other, const Corner& apart) {
    for (std::size_t k = 0; k < one.size(); ++k) {
        const Corner along = after(one, k) - one[k];
        const Corner normal{along.z, -along.x};
        const double edge = dot(normal, one[k] - apart);
        if (std::ranges::all_of(other, [&](const Corner& corner) { return dot(normal, corner) >= edge; })) return true;
    }
    return false;
}

}  // namespace

bool overlap(Corners a, Corners b, const Corner& apart) {
    return !has_parting_edge(a, b, apart) && !has_parting_edge(b, a, -1 * apart);
}

}  // namespace floes
