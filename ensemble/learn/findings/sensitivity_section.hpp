#pragma once
// The section on what decides the load.

#include <string>
#include <vector>

#include "findings/sensitivity.hpp"

namespace floes {

/// Slopes and indices by [[case]], quantity and axis; the heading first.
Table sensitivity_table(const Sensitivity& found);

/// The meaning of the columns, then the notes, as sentences.
std::vector<std::string> sensitivity_notes(const Sensitivity& found);

/// The table with its notes; JSON has a record for each quantity, CSV a line for each of its axes.
Section sensitivity_section(const Sensitivity& found);

}  // namespace floes
