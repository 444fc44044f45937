#pragma once
// The water's stiffness by a radiation program: WAMIT's .hst, or the six rows of NEMOH's KH.dat. floes has it from the
// hull's own shape; a file of it says whether both programs mean the same hull.

#include <string>
#include <string_view>

#include "core/vector.hpp"
#include "hydro/wamit.hpp"

namespace floes {

/// Whether the first row of numbers is one of such a file: three of them (i, j, C), or six.
bool is_hydrostatic(std::string_view text);

/// N/m, N, N m, in the axes of radiation programs. Without the units of WAMIT's files, ρ g L^k, NEMOH's are in SI.
/// Throws InputError, with the line, for numbers that are none, for a second body, for an element that stands twice
/// with other values, for a table that is not complete, and where heave has none.
Mat6 read_hydrostatics(std::string_view text, const std::string& file, const WamitUnits& units, double gravity);

}  // namespace floes
