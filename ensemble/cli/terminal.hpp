#pragma once
// How much room standard output has.

namespace floes {

/// Characters on a line of standard output: the terminal's; elsewhere of the environment's COLUMNS, or 100. Never
/// below 40.
int terminal_width();

}  // namespace floes
