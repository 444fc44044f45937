#pragma once
// Figures of where on the structure and when along the tow the load acts. For this room only.

#include "findings/evidence.hpp"
#include "findings/load_maps.hpp"
#include "tables/figure.hpp"

namespace floes {

/// Of each map the wall unrolled: angle by height, all in one scale of colours.
std::vector<Figure> wall_figures(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);
Figure load_rose(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);       ///< by angle, in plan
Figure load_profile(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);    ///< by height
Figure load_along_tow(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);  ///< over the distance towed

}  // namespace floes
