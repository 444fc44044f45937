#pragma once
// Convex polygons that overlap and push each other apart: crowd.hpp for other shapes than rectangles.

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arrangement/crowd.hpp"
#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

class PolygonCrowd {
  public:
    /// Outlines about their centroids between walls, at poses of any overlap, one an outline. Those of `fixed` push and
    /// are never pushed.
    PolygonCrowd(const Walls& walls, std::span<const Outline> outlines, std::span<const PlanarPose> poses,
                 const Fixed<Outline>& fixed = {});

    /// As Crowd's.
    double sweep();
    double deepest() const;
    std::vector<double> overlaps() const;
    double overlap_at(std::size_t polygon, const PlanarPose& pose) const;
    void put(std::size_t polygon, const PlanarPose& pose);
    std::vector<PlanarPose> poses() const;

  private:
    struct Body {
        Outline own;      // in its own axes
        Outline corners;  // where they are, from its centroid
        double reach = 0;
        double weight = 0;       // the first one's area over its own; 0 of one that is fixed
        double turn_weight = 0;  // squared turn (rad) that counts as much as a shift of 1 m
        PlanarPose pose;

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
    Body& add(const Outline& outline, const PlanarPose& pose);
    static std::optional<Contact> contact(const Body& first, const Body& second);
    std::optional<Contact> contact(const Body& body, const Corner& wall_normal) const;
    template <class See>
    void for_each_overlap(const See& see) const;
    void find_neighbours();
    bool neighbours_are_old() const;

    Walls walls_;
    double widest_ = 0;     // the largest reach, m
    std::size_t free_ = 0;  // so many bodies, the first, can be pushed
    std::vector<Body> bodies_;
    std::vector<Corner> places_;  // of the bodies when neighbours were found
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace floes
