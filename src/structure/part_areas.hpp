#pragma once
// Areas of the surfaces of a structure's parts, by closed form.

#include <vector>

#include "structure/shape.hpp"

namespace floes {

/// What each part has of the structure's surface between two heights, m²: of the faces of its pieces, without what
/// lies inside other pieces, against them, or is another's as well. Exact for flat faces and for walls of legs; a
/// horizontal face counts if its height lies between the two. Of a body of revolution, which is one part, none. Throws
/// InputError with the fault of a shape that has one.
std::vector<double> part_areas(const Shape& shape, double low, double high);

}  // namespace floes
