#pragma once
// The ice round the field (Fig. 3): sheets of [ice]'s thickness along both walls and across the far end, where these
// are closed, floating where the floes float.

#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// A box with its sides along the world axes, m: fixed, or pressed along its normal (simulation/sheets.hpp).
struct IceSheet {
    Vec3 centre = Vec3::Zero();
    Vec3 half_extents = Vec3::Zero();
    Vec3 inwards = Vec3::Zero();  ///< its normal towards the field
    double faces = 0;             ///< length of the field's edge that it faces at the start, m
};

struct Channel {
    double room = 0;        ///< behind the structure at t = 0, for a floe that passes round it, m
    double begin = 0;       ///< x where the wall sheets begin, m: behind the structure at t = 0
    double end = 0;         ///< x where they end, m: past the far sheet, or past all that the tow can push ahead
    double inner_edge = 0;  ///< |z| of the wall sheets' inner edges at the start, m
    double outer_edge = 0;  ///< |z| of their outer edges, m
    double drift = 0;       ///< how far ice may drift in a run without being lost, m; 0 between fixed sheets
    std::vector<IceSheet> sheets;
};

/// The channel of a scenario with room for these floes.
Channel make_channel(const Scenario& scenario, const FloeSet& floes);

}  // namespace floes
