#pragma once
// The sizes of a scenario's floes: the same in every arrangement, so that each covers the same area.

#include <vector>

#include "scenario/scenario.hpp"

namespace floes {

/// The shapes of all floes, rounded to whole elements, of the scenario's thickness: `floe` for each unless sizes
/// differ. Floe i of n has the size that a share (i + ½)/n of the law is below, or the list's shares in whole floes,
/// or an outline of shapes.file (traced_shapes()).
std::vector<FloeShape> floe_sizes(const Scenario& scenario);

/// Side of the elements, m, of a floe whose shorter side is `breadth` before it is rounded.
double element_side(const Scenario& scenario, double breadth);

/// How far from the structure's axis the edges of a field without end's window (field.ahead_m, field.behind_m) are at
/// least, m: its radius and the diagonal of the largest floe, so that it touches nothing beyond them.
double window_least(const Scenario& scenario);

/// How many floes each entry of sizes.list is of: the nearest whole numbers whose sum is field.floes.
std::vector<int> listed_counts(const Scenario& scenario);

}  // namespace floes
