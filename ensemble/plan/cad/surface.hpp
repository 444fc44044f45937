#pragma once
// A surface of triangles out of an STL or OBJ file. The only door to assimp.

#include <array>
#include <string>
#include <vector>

#include "core/vector.hpp"

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

/// The bodies that the surface encloses, each a surface whose volume is above 0: of each group, where groups are closed
/// by themselves, so that they may touch; otherwise groups are patches. Throws InputError, beginning with
/// `file`, where it is open, has more than two triangles at an edge or sides that do not agree, or encloses a hollow.
std::vector<Surface> closed_bodies(const Surface& surface, const std::string& file);

double volume_of(const Surface& body);

/// Whether the point lies inside a closed body.
bool encloses(const Surface& body, const Vec3& point);

}  // namespace floes
