#pragma once
// Floe poses from a CSV file, for example from a tank photograph.

#include <string>
#include <vector>

#include "keys/document.hpp"

namespace floes {

/// Gives the text of the file at `path`; throws InputError when it cannot be read.
using LoadFile = std::string (*)(const std::string& path);

struct PoseFile {
    std::string path;
    std::string columns;     ///< for arrangement.columns: what the header has behind x_m,z_m,yaw_deg
    Value poses;             ///< for arrangement.poses
    std::vector<int> lines;  ///< line of each pose in the file, from 1
};

/// Reads "x_m,z_m,yaw_deg", keys of which each floe has a value of its own, and a line for each floe; blank lines are
/// skipped. `file` names the text in messages. Throws
/// InputError with file, line and what is allowed.
PoseFile read_poses(const std::string& text, const std::string& file);

}  // namespace floes
