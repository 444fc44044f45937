#pragma once
// What a configuration says, to scale, before anything is computed: hull, ice, banks, moorings and way from above and
// from abeam, its numbers in words, and what of it is seldom meant.

#include "campaign/campaign.hpp"
#include "scenario/floes.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of a case at the beginning of one of its arrangements: `before` the numbers, a line each; `notes` what is odd about
/// it; figures with captions: the plan first, the hull from abeam, and of mooring lines that leave the plan one with
/// their anchors from above and, of lines that hang, one from abeam. Lays the floes as a member does, which is most of
/// its time. Throws as make_arrangement() does.
Section scene(const Campaign& campaign, std::size_t of_case, int arrangement);

// What is seldom meant, found in the floes as they lie.

/// A sentence each: no floe on the way of the hull; one that is farther away than a floe is long; a window in which the
/// hull has left the ice behind; a mooring line that leads across the hull; a hull that stands higher than it is long.
std::vector<std::string> scene_oddities(const Scenario& scenario, const FloeSet& floes);

}  // namespace floes
