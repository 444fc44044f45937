#pragma once
// From a CAD file to the shape of a structure: its bodies, cut into convex pieces.

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/surface_file.hpp"
#include "scenario/scenario.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {

// A closed body cut into convex pieces.
//
// A piece that is not convex is cut by a plane through the point of its surface that lies deepest inside its hull: by
// that of a face there, or one across an axis, whichever leaves the least volume in the two hulls. The deepest piece
// goes first. A body that is convex stays whole, and one that meets along faces is cut exactly; a surface that curves
// inwards is cut until no point is deeper than 1/500 of the body's size, or there are as many pieces as wanted. So
// pieces fill hollows less deep than that, never less than the body.
//
// Bullet's HACD was tried instead (docs/decisions.md): it divides the surface and not the body, and left one hollow.

struct ConvexPiece {
    Polyhedron body;
    std::vector<int> face_groups;  ///< group of the surface that each face lies in; -1: in none
    int group = 0;                 ///< that of most of its surface
};

/// At most `most` pieces, at least one.
std::vector<ConvexPiece> convex_pieces(const Surface& body, std::size_t most);

/// Gives `structure` the convex pieces of the file that its hull_file describes, with their parts and the volume within
/// the file's surface, and empties hull_file's path. `bytes`: of the file; `name` begins the messages. Throws
/// InputError, a sentence each: as read_surface() and closed_bodies() do, for a hull that does not reach above and
/// below the water, and for axes that are not at right angles.
void take_hull(Structure& structure, const std::string& bytes, const std::string& name);

}  // namespace floes
