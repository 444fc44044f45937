#pragma once
// The edge of the area that the sampler fills. Another one has the same interface (tests/arrangement/periodic_box.hpp):
//   low_x, low_z, length, breadth   the area, m
//   periodic                        do opposite edges meet?
//   admits(shape, x, z, turn)       may a rectangle lie there, as far as the edge is concerned?
//   into(x, z)                      brings a point that left by less than one box back in
//   nearest(dx, dz)                 the shortest difference between two points of the area that this one stands for

#include "arrangement/rectangle.hpp"

namespace floes {

/// Four walls that no rectangle may cross.
struct Walls {
    double low_x = 0;
    double low_z = 0;
    double length = 0;   ///< along x, m
    double breadth = 0;  ///< along z, m
    static constexpr bool periodic = false;

    bool admits(const Rectangle& shape, double x, double z, Turn turn) const {
        const Extent half = extent(shape, turn);
        return x - half.x >= low_x && x + half.x <= low_x + length && z - half.z >= low_z &&
               z + half.z <= low_z + breadth;
    }
    void into(double&, double&) const {}
    void nearest(double&, double&) const {}

    /// The walls moved inward by margin (m).
    Walls shrunk(double margin) const {
        return {low_x + margin, low_z + margin, length - 2 * margin, breadth - 2 * margin};
    }
};

}  // namespace floes
