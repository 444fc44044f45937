#pragma once
// Mooring lines from a file of MoorDyn or MoorPy, versions 1 and 2, read section by section.

#include <string>
#include <string_view>
#include <vector>

#include "shapes/moorings.hpp"

namespace floes {

struct MooringFile {
    std::vector<HangingLine> lines{};
    std::string extent{};                ///< what was read, in one line
    std::vector<std::string> remarks{};  ///< sentences about what was taken for granted and what is not modelled
};

/// Lines from fairleads on the vessel to anchors, hanging as at rest. `name` is for messages; density (kg/m³) and
/// gravity (m/s²) hold where the file's options have none. Throws InputError, with the line, for what is no such file
/// for what such lines are not (rods, free points, lines between two fairleads, lines that fail together or at a time),
/// for what stands twice with other values, and for a line that a configuration refuses.
MooringFile read_moorings(std::string_view text, const std::string& name, double density, double gravity);

}  // namespace floes
