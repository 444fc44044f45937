#pragma once
// The section on what decides the load.

#include "findings/sensitivity.hpp"

namespace floes {

/// The table with its notes; JSON has a record for each quantity, CSV a line for each of its axes.
Section sensitivity_section(const Sensitivity& found);

}  // namespace floes
