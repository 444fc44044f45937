#pragma once
// Water velocity around the moving structure: potential flow around a circular cylinder of the waterline's radius.

#include "core/vector.hpp"

namespace floes {

/// Horizontal water velocity (x, z), m/s, in the earth frame: water at rest far away, the circle of radius `radius` (m)
/// moving at `speed` (m/s) along +x. `from_axis`: the place (x, z) relative to the circle's centre, m. From the
/// potential -V a² cosθ / r:  u_r = V a² cosθ / r²,  u_θ = V a² sinθ / r²  for r >= a (no flow through the circle, no
/// vorticity, decreasing as 1/r²). Inside the circle, the value at r = a in the same direction; at the centre (V, 0).
Vec2 potential_flow(const Vec2& from_axis, double radius, double speed);

}  // namespace floes
