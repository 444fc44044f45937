#pragma once
// Which boxes may touch in the coming steps: found by pieces first, whose boxes never touch each other, then by boxes.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/prism.hpp"

namespace floes {

/// Bounds along the world's axes, m.
struct Bounds {
    Triple low;
    Triple high;

    bool near(const Bounds& other, double gap) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (low[i] - other.high[i] > gap || other.low[i] - high[i] > gap) return false;
        }
        return true;
    }
};

Bounds bounds_of(const PrismPlace& prism);
Bounds both(const Bounds& a, const Bounds& b);

class NearPairs {
  public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< lower number first

    /// Boxes by piece: numbers of boxes, and how many there are in each piece. To be called again when pieces change.
    void set_pieces(std::vector<std::uint32_t> boxes, const std::vector<std::uint32_t>& counts);

    /// All pairs of different pieces that leave a gap of `gap` at most along each axis, rising; `bounds` by number of a
    /// box. Pairs of two fixed boxes are left out. Valid until the next call.
    std::span<const Pair> find(std::span<const Bounds> bounds, const std::vector<std::uint8_t>& fixed, double gap);

  private:
    struct Piece {
        Bounds bounds;
        std::uint32_t begin, end;  ///< in boxes_
    };
    void add_pairs(const Piece& a, const Piece& b, std::span<const Bounds> bounds,
                   const std::vector<std::uint8_t>& fixed, double gap);

    std::vector<std::uint32_t> boxes_;
    std::vector<Piece> pieces_;
    std::vector<Pair> pairs_;
};

}  // namespace floes
