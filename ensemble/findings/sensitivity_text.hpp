#pragma once
// What decides the load, as text.

#include <string>

#include "findings/sensitivity.hpp"

namespace floes {

/// A heading, a table a [[case]] of slopes and indices by quantity and axis, what the columns mean, and the notes.
std::string sensitivity_table(const Sensitivity& found, int width);

/// A header line and one line a [[case]], quantity and axis; empty where undefined.
std::string sensitivity_csv(const Sensitivity& found);

/// The figures of sensitivity_table() row by row, the heading first, for a page.
std::vector<std::vector<std::string>> sensitivity_lines(const Sensitivity& found);

/// What the columns mean, and the notes: sentences.
std::vector<std::string> sensitivity_notes(const Sensitivity& found);

}  // namespace floes
