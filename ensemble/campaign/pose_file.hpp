#pragma once
// Floe poses from a CSV file, such as a tank photograph gives.

#include <string>

#include "keys/document.hpp"

namespace floes {

/// Reads "x_m,z_m,yaw_deg" and a line for each floe; blank lines are skipped. `file` names the text in messages. Gives
/// the value for arrangement.poses. Throws InputError with file, line and what is allowed.
Value read_poses(const std::string& text, const std::string& file);

}  // namespace floes
