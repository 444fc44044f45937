#pragma once
// A mooring line that hangs in the water and may lie on the bottom, in its closed form.
//
// An elastic cable of length L, wet weight w per length and stiffness EA hangs from its upper end, with the pull H
// along the water and V down, to an anchor that is x away and z lower (Jonkman, NREL/TP-500-41958, Eqs. 2-35 to 2-38).
// With V below wL the part L_B = L - V/w lies on the bottom, where friction of the coefficient C takes C w of H per
// length:
//
//   x = L_B + (H/w) asinh(V/H) + HL/EA + (C w/2EA) [-L_B² + (L_B - H/Cw) max(L_B - H/Cw, 0)]
//   z = (H/w) [√(1 + (V/H)²) - 1] + V²/(2EAw)
//
// and without contact with the bottom
//
//   x = (H/w) [asinh(V/H) - asinh((V - wL)/H)] + HL/EA
//   z = (H/w) [√(1 + (V/H)²) - √(1 + ((V - wL)/H)²)] + (VL - wL²/2)/EA
//
// A line that is long enough hangs straight down, H = 0, and the rest of it lies on the bottom.

#include <vector>

#include "core/vector.hpp"

namespace floes {

/// SI.
struct Cable {
    double length = 0;     ///< L, unstretched, m
    double weight = 0;     ///< w, in water, N/m, > 0
    double stiffness = 0;  ///< EA, N, > 0
    double friction = 0;   ///< C, of the bottom, >= 0

    friend bool operator==(const Cable&, const Cable&) = default;
};

/// Of a cable at its upper end, and what lies.
struct CablePull {
    double along = 0;    ///< H, N
    double down = 0;     ///< V, N
    double resting = 0;  ///< L_B, m
    double anchor = 0;   ///< tension at the lower end, N

    double tension() const;  ///< at the upper end, N
};

/// With the upper end x >= 0 m beside the anchor and z > 0 m above it. To 1e-10.
CablePull hang(const Cable& cable, double x, double z);

/// Where it runs, as hang() has it: from its upper end to the anchor in `parts` of equal length, (x from the anchor, z
/// above it), m. What lies is drawn evenly from the anchor to where it leaves the bottom.
std::vector<Vec2> course(const Cable& cable, double x, double z, int parts);

}  // namespace floes
