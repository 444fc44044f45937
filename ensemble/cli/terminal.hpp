#pragma once
// The width of standard output.

namespace floes {

/// Characters on a line of standard output: those of the terminal; elsewhere COLUMNS of the environment, or 100. At
/// least 40.
int terminal_width();

}  // namespace floes
