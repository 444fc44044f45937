#pragma once
// The mooring of the OC3 spar (NREL/TP-500-47535): three lines from fairleads 70 m down, 5.2 m from the axis.

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/moorings.hpp"

namespace floes::test {

inline std::vector<HangingLine> oc3_lines() {
    std::vector<HangingLine> lines;
    for (const double azimuth : {0.0, 2 * std::numbers::pi / 3, -2 * std::numbers::pi / 3})
        lines.push_back({.fairlead = {5.2 * std::cos(azimuth), -70, 5.2 * std::sin(azimuth)},
                         .azimuth = azimuth,
                         .distance = 853.87 - 5.2,
                         .depth = 320,
                         .cable = {902.2, 698.09, 3.84243e8, 0.001}});
    return lines;
}

}  // namespace floes::test
