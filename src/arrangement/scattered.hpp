#pragma once
// A disordered field: floes thrown on the water anywhere and at any angle, then pushed apart until none overlap.

#include <optional>
#include <span>
#include <vector>

#include "arrangement/crowd.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// A pose of each convex outline, about its centroid, at least clearance (m) apart and from the walls, and from what
/// lies already. Throws InputError if they do not come to rest in any of ten attempts.
std::vector<PlanarPose> scattered(const Walls& walls, std::span<const Outline> outlines, double clearance,
                                  RandomStream& random, const std::optional<Beside>& beside = {});

}  // namespace floes
