#include "collision/box_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "collision/prism_prism.hpp"
#include "core/contract.hpp"

namespace floes {
namespace {

/// Rounding, in lengths of the order of 0.1 m.
constexpr double tolerance = 1e-9;

/// Pairs are listed up to this part of the largest moving box's radius beyond the reach of their points.
constexpr double room_in_radii = 0.25;

}  // namespace

void BoxContacts::add(const ContactBox& box) {
    half_extent_.push_back(box.half_extent);
    reach_.push_back(box.reach);
    fixed_.push_back(box.fixed ? 1 : 0);
    is_box_.push_back(box.is_box ? 1 : 0);
    asleep_.push_back(0);
    piece_.push_back(box.piece);
    is_prism_.push_back(box.corners.empty() ? 0 : 1);
    prism_.push_back(box.corners.empty() ? PrismShape{} : PrismShape(box.corners, box.half_extent[1]));
    path_.push_back(0);
    bounds_.emplace_back();
    pieces_changed_ = moved_ = true;
}

void BoxContacts::take_out(std::uint32_t box) {
    FLOES_EXPECTS(box < is_box_.size());
    move(box);
    is_box_[box] = 0;
    piece_[box] = -1;
    pieces_changed_ = true;
}

void BoxContacts::put_in(std::uint32_t number, const ContactBox& box) {
    FLOES_EXPECTS(number < is_box_.size() && box.reach >= 0);
    move(number);
    half_extent_[number] = box.half_extent;
    is_prism_[number] = box.corners.empty() ? 0 : 1;
    prism_[number] = box.corners.empty() ? PrismShape{} : PrismShape(box.corners, box.half_extent[1]);
    reach_[number] = box.reach;
    fixed_[number] = box.fixed ? 1 : 0;
    is_box_[number] = box.is_box ? 1 : 0;
    asleep_[number] = 0;
    piece_[number] = box.piece;
    pieces_changed_ = true;
}

void BoxContacts::set_piece(std::uint32_t box, int piece) {
    FLOES_EXPECTS(box < piece_.size());
    pieces_changed_ = pieces_changed_ || piece_[box] != piece;
    piece_[box] = piece;
}

void BoxContacts::move(std::uint32_t box) {
    moved_ = true;
    for (Pair& pair : pairs_) {
        if (pair.a == box || pair.b == box) drop(pair);
    }
    std::erase_if(touching_, [&](const Pair& pair) { return pair.a == box || pair.b == box; });
}

void BoxContacts::drop(Pair& pair) {
    if (pair.patch < 0) return;
    free_patches_.push_back(pair.patch);
    pair.patch = -1;
}

void BoxContacts::sort_into_pieces() {
    std::map<int, std::vector<std::uint32_t>> pieces;
    std::vector<std::uint32_t> boxes;
    std::vector<std::uint32_t> counts;
    double radius = 0;
    double reach = 0;
    for (std::uint32_t i = 0; i < is_box_.size(); ++i) {
        if (is_box_[i] == 0) continue;
        if (fixed_[i] == 0) {
            radius = std::max(radius, std::sqrt(dot(half_extent_[i], half_extent_[i])));
            reach = std::max(reach, reach_[i]);
        }
        if (piece_[i] >= 0) {
            pieces[piece_[i]].push_back(i);
            continue;
        }
        boxes.push_back(i);
        counts.push_back(1);
    }
    for (const auto& [piece, members] : pieces) {
        boxes.insert(boxes.end(), members.begin(), members.end());
        counts.push_back(static_cast<std::uint32_t>(members.size()));
    }
    near_.set_pieces(std::move(boxes), counts);
    room_ = room_in_radii * radius;
    margin_ = 2 * reach + room_;  // Bullet looks at pairs up to twice the reach
    lever_ = 3 * radius + 2 * margin_;
    pieces_changed_ = false;
    // Room for what packed ice has, so that steps seldom take memory.
    const std::size_t count = is_box_.size();
    for (std::vector<Pair>* pairs : {&pairs_, &listed_, &touching_}) pairs->reserve(8 * count);
    patches_.reserve(2 * count);
    free_patches_.reserve(2 * count);
}

/// Adds up the paths; returns the longest.
double BoxContacts::walk(const BodyMotion* motions) {
    double longest = 0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
        path_[i] += motions[i].way + lever_ * motions[i].turn;
        if (is_box_[i] != 0) longest = std::max(longest, path_[i]);
    }
    return longest;
}

void BoxContacts::list_pairs(const BodyMotion* motions) {
    for (std::uint32_t i = 0; i < is_box_.size(); ++i) {
        if (is_box_[i] != 0) bounds_[i] = bounds_of(place(i, motions));
    }
    listed_.clear();
    std::size_t known = 0;
    for (const auto& [a, b] : near_.find(bounds_, fixed_, margin_)) {
        for (; known < pairs_.size() && std::pair(pairs_[known].a, pairs_[known].b) < std::pair(a, b); ++known)
            drop(pairs_[known]);
        listed_.push_back({a, b, 0, -1, fixed_[b] != 0 ? 3 : 0});
        if (known == pairs_.size() || pairs_[known].a != a || pairs_[known].b != b) continue;
        listed_.back() = pairs_[known++];
        listed_.back().until -= path_[a] + path_[b];
        if (moved_) listed_.back().until = 0;
    }
    for (; known < pairs_.size(); ++known) drop(pairs_[known]);
    pairs_.swap(listed_);
    std::ranges::fill(path_, 0.0);
    moved_ = false;
}

void BoxContacts::make_prisms(const Pair& pair) {
    for (const std::uint32_t box : {pair.a, pair.b})
        if (prism_[box].empty()) prism_[box] = prism_of_box(half_extent_[box]);
}

bool BoxContacts::prisms_apart(Pair& pair, const BodyMotion* motions) const {
    const double gap =
        widest_face_gap(prism(pair.a, motions), prism(pair.b, motions), fixed_[pair.b] == 0, fixed_[pair.a] == 0);
    pair.until = gap > tolerance ? path_[pair.a] + path_[pair.b] + gap - tolerance : 0;
    return gap > tolerance;
}

/// Does a face separate the two? If one is fixed, only its own faces count: it may be longer than the levers of paths
/// allow for.
bool BoxContacts::apart(Pair& pair, const BodyMotion* motions) const {
    const BoxPlace a = place(pair.a, motions);
    const BoxPlace b = place(pair.b, motions);
    double gap = face_gap(a, b, pair.axis);
    if (!(gap > tolerance)) {
        const int first = fixed_[pair.b] != 0 ? 3 : 0;
        const int end = fixed_[pair.a] != 0 ? 3 : 6;
        for (int axis = first; axis < end; ++axis) {
            const double other = face_gap(a, b, axis);
            if (!(other > gap)) continue;
            gap = other;
            pair.axis = axis;
        }
    }
    pair.until = gap > tolerance ? path_[pair.a] + path_[pair.b] + gap - tolerance : 0;
    return gap > tolerance;
}

void BoxContacts::look(Pair& pair, const BodyMotion* motions) {
    const bool prisms = meets_prism(pair);
    if (prisms) make_prisms(pair);
    if (pair.patch < 0 && (prisms ? prisms_apart(pair, motions) : apart(pair, motions))) return;
    const BoxPlace a = place(pair.a, motions);
    const BoxPlace b = place(pair.b, motions);
    BoxOverlap overlap;
    if (prisms)
        find_overlap(prism(pair.a, motions), prism(pair.b, motions), overlap);
    else
        find_overlap(a, b, overlap);
    if (pair.patch < 0) {
        if (overlap.count == 0) return;
        if (free_patches_.empty()) {
            free_patches_.push_back(static_cast<std::int32_t>(patches_.size()));
            patches_.emplace_back();
        }
        pair.patch = free_patches_.back();
        free_patches_.pop_back();
        points(pair) = {};
    }
    points(pair).update(a, b, overlap, std::min(reach_[pair.a], reach_[pair.b]));
    pair.until = 0;
    if (points(pair).count() == 0)
        drop(pair);
    else
        touching_.push_back(pair);
}

void BoxContacts::find(const BodyMotion* motions) {
    if (pieces_changed_) {
        sort_into_pieces();
        moved_ = true;
    }
    if (moved_ || walk(motions) > 0.5 * room_ - tolerance) list_pairs(motions);
    touching_.clear();
    for (Pair& pair : pairs_) {
        if (pair.patch < 0 && path_[pair.a] + path_[pair.b] < pair.until) continue;
        if (asleep_[pair.a] != 0 && asleep_[pair.b] != 0) {
            if (pair.patch >= 0) touching_.push_back(pair);
            continue;
        }
        look(pair, motions);
    }
}

}  // namespace floes
