#pragma once
// What lies on the water already while floes are laid: rectangles and polygons, whether they overlap, who is near whom,
// and how floes that overlap push each other apart. Two convex polygons are disjoint exactly if their projections on
// the normal of one of their sides are; of rectangles these are four directions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/turn.hpp"
#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

// A push removes this many times the overlap. Above 1, chains of floes separate in several times fewer sweeps.
inline constexpr double over_relaxation = 1.5;

// Weight of turning; with 1 a corner moves as far by the turn as by the shift. Then floes turn until their sides are
// parallel where a shift would do, and the field becomes more ordered.
inline constexpr double turning = 0.3;

/// Half the sides of a rectangle, m: length along its own x, breadth along its own z.
struct Rectangle {
    double half_length = 0;
    double half_breadth = 0;

    /// The same with every side moved outward by margin (m).
    Rectangle grown(double margin) const { return {half_length + margin, half_breadth + margin}; }
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
    double half_diagonal() const { return std::sqrt(half_length * half_length + half_breadth * half_breadth); }
};

/// Half the extent of a turned rectangle along world x and z, m.
struct Extent {
    double x = 0;
    double z = 0;
};

inline Extent extent(const Rectangle& shape, Turn turn) {
    const double c = std::abs(turn.cos);
    const double s = std::abs(turn.sin);
    return {shape.half_length * c + shape.half_breadth * s, shape.half_length * s + shape.half_breadth * c};
}

/// The own x and z axes of a turned rectangle in the world's (x, z), of length 1.
inline Vec2 along(Turn turn) {
    return {turn.cos, -turn.sin};
}
inline Vec2 across(Turn turn) {
    return {turn.sin, turn.cos};
}

/// From the middle of a turned rectangle to its corner that lies farthest along direction, m.
inline Vec2 corner(const Rectangle& shape, Turn turn, const Vec2& direction) {
    const Vec2 a = along(turn);
    const Vec2 b = across(turn);
    return std::copysign(shape.half_length, direction.dot(a)) * a +
           std::copysign(shape.half_breadth, direction.dot(b)) * b;
}

/// A rectangle and how it is turned.
struct TurnedRectangle {
    Rectangle shape;
    Turn turn;
};

/// Half the widths of two rectangles together, along the own x and z of the first: they are apart exactly if their
/// centres are at least so far apart along one of these directions, or of those of the second.
inline Extent joint_extent(const TurnedRectangle& first, const TurnedRectangle& second) {
    const double cos_between = std::abs(first.turn.cos * second.turn.cos + first.turn.sin * second.turn.sin);
    const double sin_between = std::abs(first.turn.cos * second.turn.sin - first.turn.sin * second.turn.cos);
    return {
        first.shape.half_length + second.shape.half_length * cos_between + second.shape.half_breadth * sin_between,
        first.shape.half_breadth + second.shape.half_length * sin_between + second.shape.half_breadth * cos_between};
}

/// Whether two rectangles overlap. The second lies at (dx, dz) from the first (m). Touching is not overlap. A
/// rectangle turned by yaw about +y has its own x axis along (cos yaw, -sin yaw) of the world's (x, z).
inline bool overlap(const TurnedRectangle& first, const TurnedRectangle& second, double dx, double dz) {
    const auto apart_along = [&](const TurnedRectangle& own, const TurnedRectangle& other) {
        const Extent reach = joint_extent(own, other);
        return std::abs(own.turn.cos * dx - own.turn.sin * dz) >= reach.x ||
               std::abs(own.turn.sin * dx + own.turn.cos * dz) >= reach.z;
    };
    return !apart_along(first, second) && !apart_along(second, first);
}

/// The smallest rectangle that covers each of the shapes, unturned.
inline Rectangle covering(std::span<const Rectangle> shapes) {
    Rectangle all;
    for (const Rectangle& one : shapes) {
        all.half_length = std::max(all.half_length, one.half_length);
        all.half_breadth = std::max(all.half_breadth, one.half_breadth);
    }
    return all;
}

/// The corners of an outline in its own axes, turned.
inline void turn_corners(Corners own, Turn turn, Outline& corners) {
    corners.clear();
    for (const Corner& one : own)
        corners.push_back({one.x * turn.cos + one.z * turn.sin, one.z * turn.cos - one.x * turn.sin});
}

// What lies on the water already while other floes are laid beside it.

/// Floes that stay where they are; a pose of each outline.
struct Fixed {
    std::span<const Outline> outlines;
    std::span<const PlanarPose> poses;
};

/// Floes that stay, and others, the first of the outlines, that may be pushed from where they are.
struct Beside {
    Fixed fixed;
    std::span<const PlanarPose> loose;
    double from = 0;   ///< x: the middles of the other floes are thrown anywhere from here to the far wall, m
    double again = 0;  ///< x: and of any that does not fit from here, m
};

// The edge of the area that the sampler fills. Another one has the same interface (tests/arrangement/periodic_box.hpp):
//   low_x, low_z, length, breadth   the area, m
//   periodic                        do opposite edges meet?
//   admits(shape, x, z, turn)       may a rectangle lie there, as far as the edge is concerned?
//   admits(corners, x, z)           or a floe with these corners about (x, z)?
//   into(x, z)                      brings a point that left by less than one box back in
//   nearest(dx, dz)                 the shortest difference between two points of the area that this one stands for

/// Four walls that no rectangle may cross.
struct Walls {
    double low_x = 0;
    double low_z = 0;
    double length = 0;   ///< along x, m
    double breadth = 0;  ///< along z, m
    static constexpr bool periodic = false;

    bool admits(const Rectangle& shape, double x, double z, Turn turn) const {
        const Extent half = extent(shape, turn);
        return x - half.x >= low_x && x + half.x <= low_x + length && z - half.z >= low_z &&
               z + half.z <= low_z + breadth;
    }
    bool admits(Corners corners, double x, double z) const {
        return std::ranges::all_of(corners, [&](const Corner& one) {
            return x + one.x >= low_x && x + one.x <= low_x + length && z + one.z >= low_z &&
                   z + one.z <= low_z + breadth;
        });
    }
    void into(double&, double&) const {}
    void nearest(double&, double&) const {}

    /// The walls moved inward by margin (m).
    Walls shrunk(double margin) const {
        return {low_x + margin, low_z + margin, length - 2 * margin, breadth - 2 * margin};
    }
};

// Cell list, the search for neighbours of this module: cells no smaller than the reach of a rectangle, so that anything
// within reach has its centre in the same cell or in one of the eight around it. The centres of a cell are contiguous
// in memory, because the sampler spends its time iterating over them.

/// The area to be divided.
struct CellArea {
    double low_x = 0;
    double low_z = 0;
    double length = 0;
    double breadth = 0;
    bool periodic = false;
};

/// A rectangle in a cell.
struct Resident {
    double x = 0;
    double z = 0;
    Turn turn;
    int floe = 0;
};

class Cells {
  public:
    /// reach: least width of a cell, m; floes: their number. Throws InputError for a periodic area less than three
    /// cells wide, where a neighbour would be visited twice.
    Cells(const CellArea& area, double reach, std::size_t floes);

    void insert(const Resident& resident);
    /// Moves a rectangle that is in the list to its new place.
    void move(const Resident& resident);

    /// Whether `holds(resident)` for any that may be within reach of a point; in no order, and none after the first.
    template <class Holds>
    bool any_near(double x, double z, const Holds& holds) const {
        for (const int cell : neighbourhood(cell_at(x, z))) {
            for (const Resident& resident : residents(cell)) {
                if (holds(resident)) return true;
            }
        }
        return false;
    }

    /// `see(resident)` for all that may be within reach of a point, in no order.
    template <class See>
    void for_each_near(double x, double z, const See& see) const {
        any_near(x, z, [&](const Resident& resident) {
            see(resident);
            return false;
        });
    }

  private:
    struct Slot {
        int cell = 0;
        int index = 0;
    };

    /// Index of the cell at a point; a point beyond an edge belongs to the cell at that edge.
    int cell_at(double x, double z) const;

    /// The cell itself and those around it, the nearest kinds first.
    std::span<const int> neighbourhood(int cell) const {
        const auto at = static_cast<std::size_t>(cell);
        return {neighbours_.data() + neighbours_begin_[at], neighbours_begin_[at + 1] - neighbours_begin_[at]};
    }

    std::span<const Resident> residents(int cell) const {
        return {residents_.data() + first(cell), static_cast<std::size_t>(count_[static_cast<std::size_t>(cell)])};
    }

    std::size_t first(int cell) const { return static_cast<std::size_t>(cell) * static_cast<std::size_t>(capacity_); }
    void erase(Slot slot);
    void make_room();

    CellArea area_;
    int columns_;  // along x
    int rows_;     // along z
    double columns_per_metre_;
    double rows_per_metre_;
    int capacity_ = 4;                 // places for each cell
    std::vector<int> count_;           // residents of a cell
    std::vector<Resident> residents_;  // by cell
    std::vector<Slot> slot_;           // place of each floe
    std::vector<int> neighbours_;
    std::vector<std::size_t> neighbours_begin_;
};

// Convex floes that overlap and push each other apart: how method scattered makes room for its floes. There is no
// randomness here.
//
// Two floes overlap by the least of the depths of the separating-axis test. A sweep takes the pairs one after another
// (Gauss-Seidel) and removes each overlap by the smallest shift and turn of both that does so, projected as in
// M. Müller et al., "Position based dynamics", J. Vis. Commun. Image R. 18 (2007), and somewhat more. Where the sides
// are parallel they press on each other in the middle of what they share, so that nothing rocks.

class Crowd {
  public:
    /// Outlines about their centroids between walls, at poses of any overlap, one an outline. Those of `fixed` push and
    /// are never pushed.
    Crowd(const Walls& walls, std::span<const Outline> outlines, std::span<const PlanarPose> poses,
          const Fixed& fixed = {});

    /// Pushes every overlapping pair apart once, then every floe inside the walls. Returns the largest overlap that it
    /// met, m.
    double sweep();

    /// The largest overlap with another floe or a wall as they lie now, m; 0 if there is none. Valid after sweeps that
    /// moved nothing far.
    double deepest() const;

    /// Sum of the overlaps of each floe, m. As valid as deepest().
    std::vector<double> overlaps() const;

    /// Sum of the overlaps that a floe would have with the others at a pose, m.
    double overlap_at(std::size_t floe, const PlanarPose& pose) const;

    void put(std::size_t floe, const PlanarPose& pose) { bodies_[floe].lie(pose); }

    /// Where they lie. Yaw in [-pi, pi].
    std::vector<PlanarPose> poses() const;

  private:
    struct Body {
        Outline own;                         // in its own axes
        std::optional<Rectangle> rectangle;  // that it is, where all are
        double reach = 0;
        double weight = 0;       // how readily it moves: the first one's area over its own; 0 of one that is fixed
        double turn_weight = 0;  // turn (rad) that counts as much as a shift of 1 m, squared
        PlanarPose pose;
        Turn turn{};
        Outline corners;  // where they are, from its centroid, unless a rectangle

        Corner place() const { return {pose.x, pose.z}; }
        void lie(const PlanarPose& at);
        void shift(const Corner& arm, const Corner& normal, double push);
    };
    struct Contact {
        double depth;
        Corner normal;      // in which the second is to move
        Corner arm_first;   // from the middle of each to where they press
        Corner arm_second;  // 0 for a wall
    };
    Body& add(const Outline& outline, bool as_rectangle, const PlanarPose& pose);
    static std::optional<Contact> contact(const Body& first, const Body& second);
    static std::optional<Contact> contact_of_rectangles(const Body& first, const Body& second);
    std::optional<Contact> contact(const Body& body, const Corner& wall_normal) const;
    template <class See>
    void for_each_overlap(const See& see) const;
    bool neighbours_are_old() const;
    void find_neighbours();

    Walls walls_;
    double widest_ = 0;     // the largest reach, m
    double skin_ = 0;       // m, in which neighbours are found beyond those that can touch
    std::size_t free_ = 0;  // so many bodies, the first, can be pushed
    std::vector<Body> bodies_;
    std::vector<Corner> places_;  // of the bodies when neighbours were found
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace floes
