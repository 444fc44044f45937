#pragma once
// The pressure of ice over the area of each part of a hull.
//
// A part's normal force, averaged over a time, over the area of the part that the ice can lie against: its surface
// between the lower and the upper side of floating ice of the case's thickness, along the wall. What acts on the part
// above or below that is counted as if it acted there, so the pressure is not below that of the ice at the waterline.

#include <vector>

#include "findings/evidence.hpp"

namespace floes {

/// Ice thinner than this, m, is taken as a tank's. Judgement: tanks make a few centimetres, and ice of no thickness
/// that structures are designed for is thinner.
inline constexpr double tank_ice = 0.15;

/// By case, part and averaging time, at full scale: evidence.scale is the length there over that in the campaign;
/// lengths grow with it, pressures likewise, times with its square root. Largest pressure over that time: mean over
/// segments and arrangements; undefined where no ice lies against the part. iso_19906: pressure_of_area(); undefined
/// where there is no pressure, or the ice is a tank's. Nothing of members that were computed without normal forces.
Results find_pressures(const Evidence& evidence);

Section pressure_section(const Evidence& evidence);

// Loads on the parts of a hull and moments on the whole of it, over the arrangements of each case.

/// Surge loads by case and part; cases of a structure that is one part have none.
Results find_parts(const Evidence& evidence);

/// Parts, pressures on them, then moments.
std::vector<Section> parts_sections(Evidence& evidence);

}  // namespace floes
