#pragma once
// From a CAD file to the shape of a structure.

#include <string>

#include "scenario/scenario.hpp"

namespace floes {

/// Gives `structure` the convex pieces of the file that its hull_file describes, with their parts and the volume within
/// the file's surface, and empties hull_file's path. `bytes`: of the file; `name` begins the messages. Throws
/// InputError, a sentence each: as read_surface() and closed_bodies() do, for a hull that does not reach above and
/// below the water, and for axes that are not at right angles.
void take_hull(Structure& structure, const std::string& bytes, const std::string& name);

}  // namespace floes
