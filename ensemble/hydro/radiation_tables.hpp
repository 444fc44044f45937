#pragma once
// Tables of added mass and damping as text: WAMIT's .1 and NEMOH's RadiationCoefficients.tec.

#include <string>
#include <string_view>

#include "hydro/radiation.hpp"

namespace floes {

bool is_nemoh(std::string_view bytes);

/// Throw InputError as read_radiation() does.
RadiationFile read_wamit(std::string_view text, const std::string& file, const WamitUnits& units);
RadiationFile read_nemoh(std::string_view text, const std::string& file);

}  // namespace floes
