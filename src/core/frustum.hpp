#pragma once
// A convex piece of a body of revolution about a vertical axis: what the structure is made of and the world collides
// with.

namespace floes {

/// The frustum of a cone between two heights (m, above the origin of its body; the waterline for a structure).
/// top_height > bottom_height; radii in metres, not negative, not both zero.
struct Frustum {
    double bottom_height = 0;
    double bottom_radius = 0;
    double top_height = 0;
    double top_radius = 0;
    friend bool operator==(const Frustum&, const Frustum&) = default;
};

}  // namespace floes
