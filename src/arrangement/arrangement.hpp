#pragma once
// The entry point of the room: the poses of all floes at t = 0.
//
//   scenario, campaign seed, arrangement number -> make_arrangement -> poses, psi4
//
// Methods (scenario.arrangement.method): monte_carlo, hard-rectangle Monte Carlo from a start that it forgets;
// lattice, rows and columns with a random jitter; file, poses given. See docs/arrangement.md.

#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"

namespace floes {

struct Arrangement {
    std::vector<PlanarPose> poses;  ///< floe centres, m, and yaws, rad
    double psi4 = 0;                ///< orientational order of the poses
};

/// Arrangement `number` of the campaign with this seed: a pure function of its arguments, the same bits anywhere.
/// Checked before it is returned. Throws InputError if floes do not fit, a jitter finds no room, or given poses
/// overlap.
Arrangement make_arrangement(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

/// Digest of everything that determines the poses: floe sides, field, arrangement rule. Scenarios with the same key get
/// the same floes for the same seed and number, whatever else differs (common random numbers).
std::uint64_t geometry_key(const Scenario& scenario);

/// |<exp(4 i yaw)>|: 1 if all floes are parallel or at right angles, about 0.89 / sqrt(n) for n random yaws.
double fourfold_order(std::span<const PlanarPose> poses);

}  // namespace floes
