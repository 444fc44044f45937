#pragma once
// Where on the structure the load acts, and when along the tow.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of the most loaded cases: shares of the load by angle and height, and figures. Reads the file.
Section load_map_section(Evidence& evidence);

}  // namespace floes
