#pragma once
// One element as the water sees it, and its numbers in the arrays of the kernels.

#include <cstddef>
#include <cstdint>

#include "core/vector.hpp"

namespace floes {

/// Where an element is and how it moves. World axes, SI.
struct ElementState {
    Vec3 position = Vec3::Zero();          ///< of the centre of mass
    Mat3 rotation = Mat3::Identity();      ///< body -> world; the columns are the element's x, normal (y) and z
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass
    Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
    std::uint32_t exposed_edges = 0;  ///< edge faces with form drag: bit 0 +x, 1 -x, 2 +z, 3 -z; of a polygon bit k
};

/// Size of an element: a square box of `side` x `thickness` x `side`, m.
struct ElementShape {
    double side = 0;
    double thickness = 0;
};

/// Writes the fields of water_field, the first to `fields`, the next `stride` further on.
void put_fields(const ElementState& state, double* fields, std::size_t stride);

/// The wrench whose first field is at `fields`, the next `stride` further on.
Wrench wrench_at(const double* fields, std::size_t stride);

}  // namespace floes
