#pragma once
// Outlines as they were traced, which need not be convex.

#include <optional>
#include <string>

#include "outline/polygon.hpp"

namespace floes {

/// What is wrong with corners that are to enclose one area, as a clause; nothing if they do, in either direction. They
/// may bend inwards, but no edge may meet another one except at the corner between them. Time goes with the square of
/// their number.
std::optional<std::string> ring_fault_of(Corners ring);

/// A convex polygon with at most `most` corners, at least 3, and the same area: the corners that cut off least go one
/// by one (Visvalingam and Whyatt, Cartogr. J. 30, 1993, cited from memory), and the rest moves outwards about the
/// centroid.
Outline with_fewer_corners(Corners convex, std::size_t most);

}  // namespace floes
