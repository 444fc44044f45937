#pragma once
// The circle below which Westergaard's formula has the stress that a joint of the grid shows: b_L of docs/fracture.md,
// as docs/figures/fracture.py finds it from the grid.

#include <cmath>

namespace floes {

/// b_L over the size of the grid for a contact level with the middle of an element, and the decades by which it shrinks
/// for each span that the contact is nearer to the joint.
struct FeltPatch {
    double share, decades;

    /// m; `size`: of the grid, of squares their side; `towards`: the contact from the middle of the span to the joint.
    double radius(double size, double towards, double span) const {
        return share * size * std::pow(10, -decades * towards / span);
    }
};
inline constexpr FeltPatch felt_at_edge{0.6, 0.66};
inline constexpr FeltPatch felt_inside{1.0, 0.92};

/// The size of a grid whose joints are `length` wide and `span` long, m. A load on a node of a grid shows the sum of
/// moments that the plate has on a circle of e^-γ/4 √(length² + span²), the same for every such grid of one diagonal:
/// the radius by which Peaceman (SPE Journal 18, 1978 and 1983; from memory) joins a well to its cell.
inline double size_of_grid(double length, double span) {
    return std::sqrt(0.5 * (length * length + span * span));
}

/// Powers of ten from one radius to a larger one; 0 if it is not larger.
inline double decades(double from, double to) {
    return to > from ? std::log10(to / from) : 0.0;
}

}  // namespace floes
