#pragma once
// Moorings that others published: three equal lines, one ahead or astern and two abeam.

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/moorings.hpp"

namespace floes::test {

/// From fairleads `radius` m from the axis and `deep` m down to anchors `away` m from the axis; the first leads ahead
/// or astern.
inline std::vector<HangingLine> three_lines(double radius, double deep, double away, double depth, const Cable& cable,
                                            double first = 0) {
    std::vector<HangingLine> lines;
    for (const double turn : {0.0, 2 * std::numbers::pi / 3, -2 * std::numbers::pi / 3}) {
        const double azimuth = first + turn;
        lines.push_back({.fairlead = {radius * std::cos(azimuth), -deep, radius * std::sin(azimuth)},
                         .azimuth = azimuth,
                         .distance = away - radius,
                         .depth = depth,
                         .cable = cable});
    }
    return lines;
}

/// The OC3 spar (NREL/TP-500-47535).
inline std::vector<HangingLine> oc3_lines() {
    return three_lines(5.2, 70, 853.87, 320, {902.2, 698.09, 3.84243e8, 0.001});
}

/// The OC4 semi-submersible (NREL/TP-5000-60601): 113.35 kg/m and 0.0766 m thick.
inline std::vector<HangingLine> oc4_lines() {
    return three_lines(40.868, 14, 837.6, 200, {835.35, 1065.3, 7.536e8}, std::numbers::pi / 3);
}

/// The IEA 15 MW semi-submersible (its MoorDyn file in NREL/ROSCO): 685 kg/m and 0.333 m thick.
inline std::vector<HangingLine> iea15_lines() {
    return three_lines(58, 14, 837.6, 200, {850, 5842.1, 3.27e9}, std::numbers::pi);
}

}  // namespace floes::test
