#pragma once
// The ice of single floes, drawn.

#include <vector>

#include "scenario/floes.hpp"

namespace floes {

/// Gives each floe the ice that the laws of [spread] draw for it, and what [brine] says. A draw depends on the
/// campaign's seed, the arrangement's number, spread.draw, the property and the floe's number only.
void draw_ice(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes);

/// The least or the largest factor that a property can have, 1 where it has no law.
double least_factor(const Spread& spread);
double largest_factor(const Spread& spread);

}  // namespace floes
