#pragma once
// A disordered field: rectangles thrown on the water anywhere and at any angle, then pushed apart until none overlap.

#include <span>
#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/crowd.hpp"
#include "arrangement/rectangle.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"
#include "outline/polygon.hpp"

namespace floes {

/// A pose of each shape, at least clearance (m) apart and from the walls. Throws InputError if they do not come to rest
/// in any of ten attempts.
std::vector<PlanarPose> scattered(const Walls& walls, std::span<const Rectangle> shapes, double clearance,
                                  RandomStream& random);

/// The same of convex polygons, about their centroids.
std::vector<PlanarPose> scattered(const Walls& walls, std::span<const Outline> outlines, double clearance,
                                  RandomStream& random);

/// What lies already: floes that stay, and others, the first of the shapes, that may be pushed from where they are.
struct Beside {
    Fixed fixed;
    std::span<const PlanarPose> loose;
    double from = 0;   ///< x: the middles of the other floes are thrown anywhere from here to the far wall, m
    double again = 0;  ///< x: and of any that does not fit from here, m
};

/// The same beside what lies already.
std::vector<PlanarPose> scattered_beside(const Walls& walls, std::span<const Rectangle> shapes, const Beside& beside,
                                         double clearance, RandomStream& random);

}  // namespace floes
