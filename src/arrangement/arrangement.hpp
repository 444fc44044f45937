#pragma once
// The entry point of the module: the poses of all floes at t = 0.
//
//   scenario, campaign seed, arrangement number -> make_arrangement -> poses and their order
//
// Methods (scenario.arrangement.method): monte_carlo, Monte Carlo of hard floes from a start that it forgets;
// lattice, rows and columns with a random jitter; file, poses given; scattered, thrown at random and pushed apart. See
// docs/field.md.

#include <cstdint>

#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// Floes with their poses: centres in m, yaws in rad.
struct Arrangement : FloeSet {
    double psi4 = 0;            ///< fourfold_order() of the poses
    double local_order = 0;     ///< local_order() of the poses
    double coverage_ahead = 0;  ///< coverage_ahead() of the floes
};

/// Arrangement `number` of the campaign with this seed: a pure function of its arguments, the same bits anywhere.
/// Checked before it is returned. Throws InputError if floes do not fit, a jitter finds no room, scattered floes
/// do not come to rest, or given poses overlap.
Arrangement make_arrangement(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

/// The floes of a field with an end; of one without, those of its first part, and where the others come from.
struct LaidField {
    Arrangement floes;  ///< of level ice one sheet, whether it ends or not
    IceAhead ahead;     ///< next is empty for a field with an end
    FloeSet cells{};    ///< of level ice without end, the elements of its first part

    /// What is in the water at the start.
    const FloeSet& laid() const { return cells.size() > 0 ? cells : floes; }
};

/// As make_arrangement(), with what lies beyond.
LaidField lay_field(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

/// Digest of everything that determines the poses: floe sides, field, arrangement rule. Of scenarios whose field has an
/// end, and of those without, equal keys get the same floes for the same seed and number, whatever else differs (common
/// random numbers).
std::uint64_t geometry_key(const Scenario& scenario);

/// Share of the structure's path that ice covers: |z| at most its radius at the waterline and within the field, along
/// the whole field. NaN if the structure does not reach the water or has another path than straight ahead.
double coverage_ahead(const Scenario& scenario, const FloeSet& floes);

}  // namespace floes
