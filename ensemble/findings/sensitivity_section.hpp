#pragma once
// What decides the load, as it is told.

#include <string>
#include <vector>

#include "findings/sensitivity.hpp"

namespace floes {

/// Slopes and indices by [[case]], quantity and axis; the heading first.
Table sensitivity_table(const Sensitivity& found);

/// What the columns mean, and the notes: sentences.
std::vector<std::string> sensitivity_notes(const Sensitivity& found);

/// The table with its notes; in JSON a record a quantity, in CSV a line for each of its axes.
Section sensitivity_section(const Sensitivity& found);

}  // namespace floes
