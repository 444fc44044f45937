#include "arrangement/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"
#include "core/turn.hpp"

namespace floes {

namespace {

// Tolerance for rounding of equal lengths, m.
constexpr double rounding = 1e-12;

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
    if (best_gap < clearance - rounding) {
        throw InputError(fmt::format(
            "{} floes of {} m x {} m with a clearance of {} m do not fit on a lattice in a field of {:.3f} m x {:.3f} "
            "m; "
            "lower field.concentration_percent or the clearance, or change the width so that whole rows fit",
            count, 2 * shape.half_length, 2 * shape.half_breadth, clearance, walls.length, walls.breadth));
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

}  // namespace floes
