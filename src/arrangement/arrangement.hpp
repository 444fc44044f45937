#pragma once
// The front door of the room: where all floes lie at t = 0.
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
/// Checked before it is returned. Floes that do not fit, a jitter that finds no room and given poses that
/// overlap are an InputError.
Arrangement make_arrangement(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

/// Digest of what decides where floes lie: floe sides, field, arrangement rule. Scenarios of one key get the same floes
/// for the same seed and number, whatever else differs (common random numbers).
std::uint64_t geometry_key(const Scenario& scenario);

/// |<exp(4 i yaw)>|: 1 if all floes are parallel or at right angles, about 0.89 / sqrt(n) for n random yaws.
double fourfold_order(std::span<const PlanarPose> poses);

}  // namespace floes
