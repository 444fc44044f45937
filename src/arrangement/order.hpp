#pragma once
// How ordered floes lie, and how much ice lies ahead of the structure.

#include <span>

#include "arrangement/crowd.hpp"
#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// |<exp(4 i yaw)>|: 1 if all floes are parallel or at right angles, about 0.89 / sqrt(n) for n random yaws.
double fourfold_order(std::span<const PlanarPose> poses);

/// Mean over the floes of cos 4(difference in yaw), averaged over the four nearest other floes by their centres; of
/// equally near ones, those given first. All others if there are fewer than four; 1 for a floe alone. 1 if all floes
/// are parallel or at right angles, about 0 for random yaws.
double local_order(std::span<const PlanarPose> poses);

/// The share of the area between the walls that rectangles cover, one a pose; none of them overlap.
double coverage(const Walls& area, std::span<const Rectangle> shapes, std::span<const PlanarPose> poses);

/// The same of polygons where they lie.
double coverage(const Walls& area, std::span<const Outline> outlines);

}  // namespace floes
