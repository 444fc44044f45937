#pragma once
// Two arrangements to start a Monte Carlo chain from, as different as the channel allows. Neither is random.

#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/rectangle.hpp"
#include "core/vector.hpp"

namespace floes {

/// Rows and columns of a lattice with equal gaps.
struct LatticeSize {
    int columns = 0;   ///< along x
    int rows = 0;      ///< along z
    double gap_x = 0;  ///< between columns, and to the walls, m
    double gap_z = 0;  ///< between rows, and to the walls, m
};

/// The lattice of count rectangles inside the walls with the largest smaller gap. Throws InputError if that gap is
/// below clearance (m): without a lattice there is no start.
LatticeSize lattice_size(const Walls& walls, const Rectangle& shape, double clearance, int count);

/// Rows and columns with equal gaps, all yaws 0. psi4 = 1, even density. Sites after `count` stay empty.
std::vector<PlanarPose> lattice_start(const Walls& walls, const Rectangle& shape, double clearance, int count);

/// The columns of that lattice pushed together to one side and to the near end; those of the near half lean one way,
/// the others the other way, as far as space allows. psi4 about 0.6 in the paper's channel, uneven density.
std::vector<PlanarPose> stripes_start(const Walls& walls, const Rectangle& shape, double clearance, int count);

}  // namespace floes
