#pragma once
// Mooring lines from a file of MoorDyn or MoorPy, versions 1 and 2, read section by section.

#include <string>
#include <string_view>
#include <vector>

#include "shapes/moorings.hpp"

namespace floes {

struct MooringFile {
    std::vector<HangingLine> lines{};
    std::vector<std::string> remarks{};  ///< sentences about what was taken for granted
};

/// Lines from fairleads on the vessel to anchors, hanging as at rest. `file` names it in messages; density (kg/m³) and
/// gravity (m/s²) hold where the file's options have none. Throws InputError, with the line, for what is no such file
/// and for what such lines are not: rods, free points, lines between two fairleads.
MooringFile read_moorings(std::string_view text, const std::string& file, double density, double gravity);

}  // namespace floes
