#pragma once
// A surface of triangles out of an STL or OBJ file. The only door to assimp.

#include <array>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "shapes/convex_solid.hpp"

namespace floes {

/// In the file's own axes and unit. Points that have the same place are one.
struct Surface {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;  ///< corners, counter-clockwise as seen from outside
    std::vector<int> group;                     ///< of each triangle
    std::vector<std::string> groups;            ///< names of solids (STL) or of objects and groups (OBJ)

    const Vec3& corner(std::size_t triangle, std::size_t k) const {
        return points[static_cast<std::size_t>(triangles[triangle][k])];
    }
};

/// `bytes`: of the file, which its name, ending in .stl or .obj, says how to read. Throws InputError, beginning with
/// the name: what is no such file, has no triangles or more than 20,000, or numbers that are none.
Surface read_surface(const std::string& bytes, const std::string& file);

/// Where a surface is open, corners nearer to each other than one of these shares of its size are taken as one: the
/// first that closes it.
inline constexpr std::array welding{1e-6, 1e-5, 1e-4};

/// The bodies that the surface encloses, each a surface whose volume is above 0: of each group, where groups are closed
/// by themselves, so that they may touch; otherwise groups are patches. Throws InputError, beginning with
/// `file`, where it is open, has more than two triangles at an edge or sides that do not agree, or encloses a hollow.
std::vector<Surface> closed_bodies(const Surface& surface, const std::string& file);

double volume_of(const Surface& body);

/// Whether the point lies inside a closed body.
bool encloses(const Surface& body, const Vec3& point);

// A closed body cut into convex pieces.
//
// A piece that is not convex is cut by a plane through the point of its surface that lies deepest inside its hull: by
// that of a face there, or one across an axis, whichever leaves the least volume in the two hulls. The deepest piece
// goes first. A body that is convex stays whole, and one that meets along faces is cut exactly; a surface that curves
// inwards is cut until no point is deeper than 1/500 of the body's size, or there are as many pieces as wanted. So
// pieces fill hollows less deep than that, never less than the body.
//
// Bullet's HACD was tried instead (docs/structures.md): it divides the surface and not the body, and left one hollow.

struct ConvexPiece {
    Polyhedron body;
    std::vector<int> face_groups;  ///< group of the surface that each face lies in; -1: in none
    int group = 0;                 ///< that of most of its surface
};

/// At most `most` pieces, at least one.
std::vector<ConvexPiece> convex_pieces(const Surface& body, std::size_t most);

// From a CAD file to the shape of a structure.

/// Gives `structure` the convex pieces of the file that its hull_file describes, with their parts and the volume within
/// the file's surface, and empties hull_file's path. `bytes`: of the file; `name` begins the messages. Throws
/// InputError, a sentence each: as read_surface() and closed_bodies() do, for a hull that does not reach above and
/// below the water, and for axes that are not at right angles.
void take_hull(Structure& structure, const std::string& bytes, const std::string& name);

}  // namespace floes
