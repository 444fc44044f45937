#pragma once
// A surface of triangles out of an STL or OBJ file, in double precision.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/vector.hpp"

namespace floes {

/// In the file's own axes and unit. Points that have the same place are one.
struct Surface {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;  ///< corners, counter-clockwise as seen from outside
    std::vector<int> group;                     ///< of each triangle
    std::vector<int> solid;  ///< likewise: an STL text may have several of one name; of an OBJ file it is the group
    std::vector<std::string> groups;  ///< names of solids (STL) or of objects and groups (OBJ)

    const Vec3& corner(std::size_t triangle, std::size_t k) const {
        return points[static_cast<std::size_t>(triangles[triangle][k])];
    }
};

/// `bytes`: of the file, which its name, ending in .stl or .obj, says how to read. Polygons are cut into triangles,
/// lines and points left out. Throws InputError, beginning with the name, of a text with the line: what is no such file
/// or was cut off, has no triangles or more than 20,000, numbers that are none, and numbers that are rounded so much,
/// far from the origin, that the volume may be off by more than a hundredth.
Surface read_surface(const std::string& bytes, const std::string& file);

}  // namespace floes
