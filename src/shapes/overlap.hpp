#pragma once
// Convex pieces of one body, continued into each other, so that the faces at which they meet lie inside the body where
// ice cannot touch them.

#include <span>
#include <vector>

#include "shapes/convex_solid.hpp"

namespace floes {

/// The same body of pieces that are continued, straight on along their faces, through each face at which others go on
/// and for as long as the union stays convex: nothing outside the body is added but 1e-5 of a piece's volume, which is
/// what rounding in single precision leaves. A continuation that does not take in the whole of the piece that it enters
/// ends a quarter of its length before that piece's far side: its end is then inside, and not a second wall there. A
/// piece that lies in a continued one is left out, so that a wall is there once and crushes ice once. Pieces that the
/// planes of no neighbour meet stay as they are, and so do frusta: a body with one is given back unchanged.
/// Lengths in m. A face in the plane of a face of the piece keeps its part, another has that of a piece with such a
/// face.
std::vector<ConvexSolid> overlapping(const std::vector<ConvexSolid>& pieces);

/// The part of the body whose surface a point is at that touches `touched`, one of `overlapping(pieces)`: of the faces
/// of `pieces` in the plane of the touched face that of the piece which holds the point, or is nearest to it.
int part_at(const ConvexSolid& touched, std::span<const ConvexSolid> pieces, const Vec3& point);

}  // namespace floes
