#pragma once
// Rectangles that overlap and push each other apart: how method scattered makes room for its floes. There is no
// randomness here.
//
// Two rectangles overlap by the least of the four depths of the separating-axis test. A sweep takes the pairs one after
// another (Gauss-Seidel) and removes each overlap by the smallest shift and turn of both that does so, projected as in
// M. Müller et al., "Position based dynamics", J. Vis. Commun. Image R. 18 (2007), and somewhat more. Where the sides
// are parallel they press on each other in the middle of what they share, so that nothing rocks.

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/lying.hpp"
#include "arrangement/rectangle.hpp"
#include "core/turn.hpp"
#include "core/vector.hpp"

namespace floes {

class Crowd {
  public:
    /// Rectangles between walls, at poses of any overlap, one a shape. Those of `fixed` push and are never pushed.
    Crowd(const Walls& walls, std::span<const Rectangle> shapes, std::span<const PlanarPose> poses,
          const Fixed<Rectangle>& fixed = {});

    /// Pushes every overlapping pair apart once, then every rectangle inside the walls. Returns the largest overlap
    /// that it met, m.
    double sweep();

    /// The largest overlap with another rectangle or a wall as they lie now, m; 0 if there is none. Valid after sweeps
    /// that moved nothing far.
    double deepest() const;

    /// Sum of the overlaps of each rectangle, m. As valid as deepest().
    std::vector<double> overlaps() const;

    /// Sum of the overlaps that a rectangle would have with the others at a pose, m.
    double overlap_at(std::size_t rectangle, const PlanarPose& pose) const;

    void put(std::size_t rectangle, const PlanarPose& pose);

    /// Where they lie. Yaw in [-pi, pi].
    std::vector<PlanarPose> poses() const;

  private:
    struct Body {
        Rectangle shape;
        double weight = 1;       // how readily it moves: the first one's area over its own
        double turn_weight = 0;  // turn (rad) that counts as much as a shift of 1 m, squared
        double yaw = 0;
        Turn turn;
        Vec2 place = Vec2::Zero();  // (x, z)

        TurnedRectangle turned() const { return {shape, turn}; }
        void lie(const PlanarPose& pose);
    };
    struct Contact {
        double depth;
        Vec2 normal;      // in which the second is to move
        Vec2 arm_first;   // from the middle of each to where they press
        Vec2 arm_second;  // 0 for a wall
    };
    std::optional<Contact> contact(const Body& first, const Body& second) const;
    std::optional<Contact> contact(const Body& body, const Vec2& wall_normal) const;
    template <class See>
    void for_each_overlap(const See& see) const;
    bool neighbours_are_old() const;
    void find_neighbours();

    Walls walls_;
    double diagonal_;   // of the largest, m
    double skin_;       // m, in which neighbours are found beyond those that can touch
    std::size_t free_;  // so many bodies, the first, can be pushed
    std::vector<Body> bodies_;
    std::vector<Vec2> places_;  // of the bodies when neighbours were found
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace floes
