#pragma once
// The options of a file of MoorDyn or MoorPy: those that say how a line hangs at rest.

#include <optional>
#include <string>
#include <vector>

#include "hydro/mooring_sections.hpp"

namespace floes {

struct MooringFileOptions {
    double density;
    double gravity;
    double friction = 0;            ///< of the bottom, along a line
    std::optional<double> depth{};  ///< m
};

/// Density and gravity as given where the file has none. Adds to `remarks` what acts on lines and is not modelled, and
/// options that are not known. Throws InputError for an option that stands twice with other values.
MooringFileOptions mooring_options(const MooringSections& file, double density, double gravity,
                                   std::vector<std::string>& remarks);

}  // namespace floes
