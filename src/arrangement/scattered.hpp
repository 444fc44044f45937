#pragma once
// A disordered field: rectangles thrown on the water anywhere and at any angle, then pushed apart until none overlap.

#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/rectangle.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"

namespace floes {

/// count rectangles at least clearance (m) apart and from the walls. Throws InputError if they do not come to rest in
/// any of ten attempts.
std::vector<PlanarPose> scattered(const Walls& walls, const Rectangle& shape, double clearance, int count,
                                  RandomStream& random);

}  // namespace floes
