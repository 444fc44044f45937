#pragma once
// A lattice whose floes are randomly shifted and turned about their sites: a broken sheet that has not drifted.

#include <span>
#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/rectangle.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"

namespace floes {

/// Largest shift along x and along z (m) and largest turn (rad) of a floe from its site.
struct Jitter {
    double shift = 0;
    double turn = 0;
};

/// A floe of each shape, at least clearance (m) apart and from the walls, each uniformly distributed over the positions
/// within its jitter that the others leave free. Throws InputError if floes fit on no lattice, or if a floe finds no
/// position in 10 000 trials.
std::vector<PlanarPose> jittered_lattice(const Walls& walls, std::span<const Rectangle> shapes, double clearance,
                                         const Jitter& jitter, RandomStream& random);

}  // namespace floes
