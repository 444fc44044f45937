#pragma once
// What lies on the water already while other floes are laid beside it.

#include <span>

#include "core/vector.hpp"

namespace floes {

/// Rectangles or outlines that stay where they are; a pose of each.
template <class Shape>
struct Fixed {
    std::span<const Shape> shapes;
    std::span<const PlanarPose> poses;
};

/// Floes that stay, and others, the first of the shapes, that may be pushed from where they are.
template <class Shape>
struct Beside {
    Fixed<Shape> fixed;
    std::span<const PlanarPose> loose;
    double from = 0;   ///< x: the middles of the other floes are thrown anywhere from here to the far wall, m
    double again = 0;  ///< x: and of any that does not fit from here, m
};

}  // namespace floes
