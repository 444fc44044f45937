#include "collision/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

Bounds bounds_of(const PrismPlace& prism) {
    const Triple& half = prism.shape->half_extent;
    Bounds bounds;
    for (std::size_t i = 0; i < 3; ++i) {
        const double* row = prism.rotation + 3 * i;
        const double reach = half[0] * std::abs(row[0]) + half[1] * std::abs(row[1]) + half[2] * std::abs(row[2]);
        bounds.low[i] = prism.position[i] - reach;
        bounds.high[i] = prism.position[i] + reach;
    }
    return bounds;
}

Bounds both(const Bounds& a, const Bounds& b) {
    Bounds sum;
    for (std::size_t i = 0; i < 3; ++i) {
        sum.low[i] = std::min(a.low[i], b.low[i]);
        sum.high[i] = std::max(a.high[i], b.high[i]);
    }
    return sum;
}

void NearPairs::set_pieces(std::vector<std::uint32_t> boxes, const std::vector<std::uint32_t>& counts) {
    boxes_ = std::move(boxes);
    pieces_.clear();
    pairs_.reserve(8 * boxes_.size());
    std::uint32_t begin = 0;
    for (const std::uint32_t count : counts) {
        pieces_.push_back({{}, begin, begin + count});
        begin += count;
    }
}

void NearPairs::add_pairs(const Piece& a, const Piece& b, std::span<const Bounds> bounds,
                          const std::vector<std::uint8_t>& fixed, double gap) {
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
        const std::uint32_t one = boxes_[i];
        if (!bounds[one].near(b.bounds, gap)) continue;
        for (std::uint32_t k = b.begin; k < b.end; ++k) {
            const std::uint32_t other = boxes_[k];
            if ((fixed[one] != 0 && fixed[other] != 0) || !bounds[one].near(bounds[other], gap)) continue;
            pairs_.emplace_back(std::min(one, other), std::max(one, other));
        }
    }
}

std::span<const NearPairs::Pair> NearPairs::find(std::span<const Bounds> bounds, const std::vector<std::uint8_t>& fixed,
                                                 double gap) {
    for (Piece& piece : pieces_) {
        piece.bounds = bounds[boxes_[piece.begin]];
        for (std::uint32_t i = piece.begin + 1; i < piece.end; ++i)
            piece.bounds = both(piece.bounds, bounds[boxes_[i]]);
    }
    // Pieces in the order in which they begin along x: those that one may touch follow it closely.
    std::ranges::sort(pieces_, [](const Piece& a, const Piece& b) {
        return a.bounds.low[0] != b.bounds.low[0] ? a.bounds.low[0] < b.bounds.low[0] : a.begin < b.begin;
    });
    pairs_.clear();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double end = pieces_[i].bounds.high[0] + gap;
        for (std::size_t k = i + 1; k < pieces_.size() && pieces_[k].bounds.low[0] <= end; ++k) {
            if (pieces_[i].bounds.near(pieces_[k].bounds, gap)) add_pairs(pieces_[i], pieces_[k], bounds, fixed, gap);
        }
    }
    std::ranges::sort(pairs_);
    return pairs_;
}

}  // namespace floes
