#pragma once
// The last look at an arrangement before it is used: every pair of floes, every wall, the concentration.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arrangement/boundary.hpp"
#include "core/vector.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// The shape of a floe of the scenario.
Rectangle floe_shape(const Scenario& scenario);

/// The walls of the scenario's ice field: x from field.begin to field_end(), |z| <= half_width.
Walls field_walls(const Scenario& scenario);

struct Fault {
    std::string sentence;
    std::vector<std::size_t> floes = {};  ///< that it is about, as numbers of poses; of most faults none, one or two
};

/// The first thing wrong with poses as an arrangement of the scenario; nothing if all is well. Wrong are: another
/// number of floes, a floe nearer than the clearance to a wall or to another floe (by more than a nanometre, which is
/// rounding), a concentration that differs from the scenario's by more than 1e-12 of it. Two floes are too near when
/// they overlap with half the clearance added on every side: between a corner and a side that wants up to 1.21 times
/// the clearance.
std::optional<Fault> find_fault(const Scenario& scenario, std::span<const PlanarPose> poses);

}  // namespace floes
