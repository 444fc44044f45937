#pragma once
// Points of one rectangle within another, in a plane.

namespace floes {

/// Corners of what the rectangle |x| <= half[0], |y| <= half[1] has in common with a parallelogram of four corners (x,
/// y), at most eight; an edge of the rectangle itself is outside. Returns their number.
int clip_to_rectangle(const double* half, const double* corners, double* found);

/// Chooses `wanted` of `count` points in a plane, spread evenly by angle round their middle; the first is `first`.
void spread_evenly(int count, const double* points, int wanted, int first, int* chosen);

}  // namespace floes
