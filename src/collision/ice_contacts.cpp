#include "collision/ice_contacts.hpp"

#include <cmath>
#include <map>

#include "core/contract.hpp"
#include "core/state_archive.hpp"

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
        for (std::uint32_t i = piece.begin + 1; i < piece.end; ++i) piece.bounds.add(bounds[boxes_[i]]);
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

/// Pairs are listed up to this part of the largest moving element's radius beyond the reach of their points.
constexpr double room_in_radii = 0.25;

void IceContacts::add(ContactElement element) {
    there_.push_back(element.shape.empty() ? 0 : 1);
    fixed_.push_back(element.fixed ? 1 : 0);
    asleep_.push_back(0);
    elements_.push_back(std::move(element));
    path_.push_back(0);
    roam_.push_back(0);
    bounds_.emplace_back();
    pieces_changed_ = moved_ = true;
}

void IceContacts::take_out(std::uint32_t element, ContactStore& store) {
    FLOES_EXPECTS(element < there_.size());
    move(element, store);
    there_[element] = 0;
    elements_[element].piece = -1;
    pieces_changed_ = true;
}

void IceContacts::put_in(std::uint32_t number, ContactElement element, ContactStore& store) {
    FLOES_EXPECTS(number < there_.size() && element.reach >= 0);
    move(number, store);
    there_[number] = element.shape.empty() ? 0 : 1;
    fixed_[number] = element.fixed ? 1 : 0;
    asleep_[number] = 0;
    elements_[number] = std::move(element);
    pieces_changed_ = true;
}

void IceContacts::set_piece(std::uint32_t element, int piece) {
    FLOES_EXPECTS(element < elements_.size());
    pieces_changed_ = pieces_changed_ || elements_[element].piece != piece;
    elements_[element].piece = piece;
}

void IceContacts::move(std::uint32_t element, ContactStore& store) {
    moved_ = true;
    for (Pair& pair : pairs_) {
        if (pair.a != element && pair.b != element) continue;
        drop(pair, store);
        pair.axis = -1;  // another shape may come
    }
    std::erase_if(touching_, [&](const Touching& pair) { return pair.a == element || pair.b == element; });
}

void IceContacts::drop(Pair& pair, ContactStore& store) {
    if (pair.points < 0) return;
    store.give_back(pair.points);
    pair.points = -1;
}

void IceContacts::sort_into_pieces(ContactStore& store) {
    std::map<int, std::vector<std::uint32_t>> pieces;
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> counts;
    radius_ = 0;
    double reach = 0;
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (!is_there(i)) continue;
        const ContactElement& element = elements_[i];
        if (!element.fixed) {
            radius_ = std::max(radius_, std::sqrt(dot(element.shape.half_extent, element.shape.half_extent)));
            reach = std::max(reach, element.reach);
        }
        if (element.piece >= 0) {
            pieces[element.piece].push_back(i);
            continue;
        }
        order.push_back(i);
        counts.push_back(1);
    }
    for (const auto& [piece, members] : pieces) {
        order.insert(order.end(), members.begin(), members.end());
        counts.push_back(static_cast<std::uint32_t>(members.size()));
    }
    near_.set_pieces(std::move(order), counts);
    room_ = room_in_radii * radius_;
    margin_ = 2 * reach + room_;  // Bullet looks at pairs up to twice the reach
    lever_ = 3 * radius_ + 2 * margin_;
    pieces_changed_ = false;
    // Room for what packed ice has, so that steps seldom take memory.
    const std::size_t count = elements_.size();
    for (std::vector<Pair>* pairs : {&pairs_, &listed_}) pairs->reserve(8 * count);
    touching_.reserve(8 * count);
    store.reserve(2 * count);
}

/// Adds up the paths; returns how far the bounds of some element have moved at most.
double IceContacts::walk(const BodyMotion* motions) {
    double farthest = 0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
        path_[i] += motions[i].way + lever_ * motions[i].turn;
        roam_[i] += motions[i].way + radius_ * motions[i].turn;
        if (is_there(i)) farthest = std::max(farthest, roam_[i]);
    }
    return farthest;
}

void IceContacts::list_pairs(const BodyMotion* motions, ContactStore& store) {
    for (std::uint32_t i = 0; i < elements_.size(); ++i) {
        if (is_there(i)) bounds_[i] = bounds_of(place(i, motions));
    }
    listed_.clear();
    std::size_t known = 0;
    for (const auto& [a, b] : near_.find(bounds_, fixed_, margin_)) {
        for (; known < pairs_.size() && std::pair(pairs_[known].a, pairs_[known].b) < std::pair(a, b); ++known)
            drop(pairs_[known], store);
        listed_.push_back({a, b, 0, -1, -1});
        if (known == pairs_.size() || pairs_[known].a != a || pairs_[known].b != b) continue;
        listed_.back() = pairs_[known++];
        listed_.back().until -= path_[a] + path_[b];
        if (moved_) listed_.back().until = 0;
    }
    for (; known < pairs_.size(); ++known) drop(pairs_[known], store);
    pairs_.swap(listed_);
    std::ranges::fill(path_, 0.0);
    std::ranges::fill(roam_, 0.0);
    moved_ = false;
}

/// If one is fixed, only its own faces count: it may be longer than the levers of paths allow for.
double IceContacts::find_widest_gap(Pair& pair, const PrismPlace& a, const PrismPlace& b) const {
    const int of_a = face_axes(*a.shape);
    const int first = fixed_[pair.b] != 0 ? of_a : 0;
    const int end = fixed_[pair.a] != 0 ? of_a : of_a + face_axes(*b.shape);
    const FaceGap widest = widest_face_gap(a, b, first, end);
    pair.axis = widest.axis;
    return widest.gap;
}

/// Along the axis that parted the two last; not above 0 where none is known.
double IceContacts::known_gap(const Pair& pair, const PrismPlace& a, const PrismPlace& b) {
    return pair.axis < 0 ? 0 : face_gap(a, b, pair.axis);
}

/// Does a face separate the two? First the one that did so last.
bool IceContacts::apart(Pair& pair, const PrismPlace& a, const PrismPlace& b) const {
    double gap = known_gap(pair, a, b);
    if (!(gap > length_rounding)) gap = find_widest_gap(pair, a, b);
    pair.until = gap > length_rounding ? path_[pair.a] + path_[pair.b] + gap - length_rounding : 0;
    return gap > length_rounding;
}

void IceContacts::look(Pair& pair, const BodyMotion* motions, ContactStore& store) {
    const PrismPlace a = place(pair.a, motions);
    const PrismPlace b = place(pair.b, motions);
    Overlap overlap;
    if (pair.points < 0) {
        if (apart(pair, a, b)) return;
        find_overlap(a, b, overlap);
        if (overlap.count == 0) return;
        pair.points = store.take();
    } else if (!(known_gap(pair, a, b) > length_rounding)) {  // it keeps points while it is but little apart
        find_overlap(a, b, overlap);
        if (overlap.count == 0) find_widest_gap(pair, a, b);
    }
    TouchingPoints& points = store[pair.points];
    const double reach = std::min(elements_[pair.a].reach, elements_[pair.b].reach);
    for (int i = 0; i < overlap.count; ++i) {
        const auto& [on_b, depth] = overlap.points[static_cast<std::size_t>(i)];
        points.add(a, b, on_b, -1 * overlap.normal, -depth, reach);
    }
    points.refresh(a, b, reach);
    pair.until = 0;
    if (points.count() == 0)
        drop(pair, store);
    else
        touching_.push_back({.a = pair.a, .b = pair.b, .points = pair.points});
}

void IceContacts::find(const BodyMotion* motions, ContactStore& store) {
    bool anew = moved_;
    if (pieces_changed_) {
        sort_into_pieces(store);
        anew = true;
    }
    if (!moved_ && walk(motions) > 0.5 * room_ - length_rounding) anew = true;
    if (anew) list_pairs(motions, store);
    touching_.clear();
    for (Pair& pair : pairs_) {
        if (pair.points < 0 && path_[pair.a] + path_[pair.b] < pair.until) continue;
        if (asleep_[pair.a] == 0 || asleep_[pair.b] == 0)
            look(pair, motions, store);
        else if (pair.points >= 0)
            touching_.push_back({.a = pair.a, .b = pair.b, .points = pair.points});
    }
}

void NearPairs::archive(StateArchive& state) {
    auto& [boxes, pieces, pairs] = *this;  // the last are found anew
    state(boxes, pieces);
}

void IceContacts::archive(StateArchive& state) {
    auto& [elements, there, fixed, asleep, path, roam, radius, lever, room, margin, pieces_changed, moved, near, bounds,
           pairs, listed, touching] = *this;
    state(elements, there, fixed, asleep, path, roam, radius, lever, room, margin, pieces_changed, moved, near, pairs,
          touching);
    bounds.resize(elements.size());
}

}  // namespace floes
