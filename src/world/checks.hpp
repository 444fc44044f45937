#pragma once
// What a World refuses: each function throws InputError with the value and its range. Only for files inside this room.

#include <cstddef>
#include <span>

#include "structure/convex_piece.hpp"
#include "world/definitions.hpp"

namespace floes {

void check(const WorldDefinition& definition);
void check(const BoxDefinition& box);
void check(const FixedBoxDefinition& box);
void check(const JointDefinition& joint, std::size_t bodies);
void check_structure(std::span<const ConvexPiece> pieces, double friction, bool present);

}  // namespace floes
