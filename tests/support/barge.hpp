#pragma once
// The barge of configs/barge.toml as a hull by its sizes.

#include <numbers>

#include "shapes/shape.hpp"

namespace floes::test {

/// 60 x 20 m, 4 m of draught, ends at 45°. Parts: bow, stern, port, starboard, bottom and deck.
inline Shape barge() {
    HullSizes sizes;
    sizes.length = 60;
    sizes.beam = 20;
    sizes.draught = 4;
    sizes.freeboard = 3;
    sizes.stem = std::numbers::pi / 4;
    sizes.flare = std::numbers::pi / 2;
    return Shape(HullKind::barge, sizes);
}

}  // namespace floes::test
