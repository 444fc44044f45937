#pragma once
// The bodies that a surface encloses, each once.

#include <array>
#include <string>
#include <vector>

#include "campaign/surface_file.hpp"
#include "core/vector.hpp"

namespace floes {

/// Where a surface is open, corners nearer to each other than one of these shares of its size are taken as one: the
/// first that closes it.
inline constexpr std::array welding{1e-6, 1e-5, 1e-4};

/// More bodies no hull has.
inline constexpr std::size_t most_bodies = 64;

/// Of a body's volume: what may count twice, or be missing, where surfaces cross, so that walls which were cut into
/// different triangles may touch.
inline constexpr double most_crossed = 0.01;

/// The bodies that the surface encloses, each a surface whose volume is above 0, whichever way its triangles were
/// turned: of each solid, where solids are closed by themselves, so that they may touch; otherwise solids are patches.
/// A triangle that a solid has twice counts once. Throws InputError, beginning with `file`, where the surface is open,
/// has more than two triangles at an edge or sides that do not agree, crosses itself, encloses more than most_bodies,
/// or bodies that share space: one within another, one twice, or two that overlap.
std::vector<Surface> closed_bodies(const Surface& surface, const std::string& file);

double volume_of(const Surface& body);

/// Whether the point lies inside a closed body.
bool encloses(const Surface& body, const Vec3& point);

/// The diagonal of the box that holds its points.
double size_of(const Surface& surface);

}  // namespace floes
