#pragma once
// The section on what decides the load.

#include "findings/sensitivity.hpp"

namespace floes {

/// The table with its notes; JSON has a record for each quantity, CSV a line for each of its axes.
Section sensitivity_section(const Sensitivity& found);

/// "Thickness from 0.02 to 0.04 m changes the mean load by +5.4 N (+2.1 to +8.7)." Of a row with a fit, for the mean
/// load; the range is left out where it says nothing.
std::string change_sentence(const Sensitivity& found, const SensitivityRow& row, std::size_t axis);

}  // namespace floes
