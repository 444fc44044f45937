#pragma once
// Contacts of ice on ice from step to step: which elements touch, and where. Between boxes the same points, to the last
// bit, as Bullet finds, which looks at every pair whose bounds are near each other in every step. Here a pair that a
// face separates is looked at again only when the two may have come as far as that.
//
//   contacts.add(element);             // numbered from 0
//   contacts.find(motions, store);     // of all bodies, by number, once a step
//   for (touching pair) store[pair.points]

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "collision/prism.hpp"
#include "collision/touching_points.hpp"
#include "solver/body_motion.hpp"

namespace floes {

class StateArchive;

// Which boxes may touch in the coming steps: found by pieces first, whose boxes never touch each other, then by boxes.

/// Bounds along the world's axes, m.
struct Bounds {
    Triple low;
    Triple high;

    void add(const Bounds& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], other.low[i]);
            high[i] = std::max(high[i], other.high[i]);
        }
    }
    bool near(const Bounds& other, double gap) const {
        for (std::size_t i = 0; i < 3; ++i) {
            if (low[i] - other.high[i] > gap || other.low[i] - high[i] > gap) return false;
        }
        return true;
    }
};

Bounds bounds_of(const PrismPlace& prism);

class NearPairs {
  public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< lower number first

    /// Boxes by piece: numbers of boxes, and how many there are in each piece. To be called again when pieces change.
    void set_pieces(std::vector<std::uint32_t> boxes, const std::vector<std::uint32_t>& counts);

    /// All pairs of different pieces that leave a gap of `gap` at most along each axis, rising; `bounds` by number of a
    /// box. Pairs of two fixed boxes are left out. Valid until the next call.
    std::span<const Pair> find(std::span<const Bounds> bounds, const std::vector<std::uint8_t>& fixed, double gap);

    void archive(StateArchive& state);  ///< core/state_archive.hpp

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

/// Lengths in m.
struct ContactElement {
    PrismShape shape;    ///< empty: only a number that is taken
    double reach = 0;    ///< a point lasts while its halves are nearer than this
    bool fixed = false;  ///< never turns, and touches no other that is fixed
    int piece = -1;      ///< elements of one piece >= 0 do not touch
};

class IceContacts {
  public:
    void add(ContactElement element);

    const PrismShape& shape(std::uint32_t element) const { return elements_[element].shape; }

    /// From the next find() on the element touches nothing; its number is free for another one.
    void take_out(std::uint32_t element, ContactStore& store);
    void put_in(std::uint32_t number, ContactElement element, ContactStore& store);

    /// In force from the next find() on.
    void set_piece(std::uint32_t element, int piece);

    /// Two elements that sleep are not looked at; they must not move.
    void set_asleep(std::uint32_t element, bool asleep) { asleep_[element] = asleep ? 1 : 0; }

    /// The element is somewhere else now; contacts that it had begin anew.
    void move(std::uint32_t element, ContactStore& store);

    /// Elements are not quite where their last motions led.
    void distrust() { moved_ = true; }

    /// Finds the points at which elements touch. motions: of all that were added.
    void find(const BodyMotion* motions, ContactStore& store);

    /// Pairs with points, rising by (a, b), a below b. Valid until the next find().
    std::span<const Touching> touching() const { return touching_; }

    void archive(StateArchive& state);  ///< core/state_archive.hpp

  private:
    struct Pair {
        std::uint32_t a;  ///< the lower number
        std::uint32_t b;
        double until;         ///< apart while the ways of both are less than this in sum, m
        std::int32_t points;  ///< in the store; -1 for none
        std::int32_t axis;    ///< of face_gap(), along which they were apart last; -1: not known
    };

    bool is_there(std::size_t element) const { return there_[element] != 0; }
    PrismPlace place(std::uint32_t element, const BodyMotion* motions) const {
        return {&elements_[element].shape, motions[element].position, motions[element].rotation};
    }
    void sort_into_pieces(ContactStore& store);
    double walk(const BodyMotion* motions);
    void list_pairs(const BodyMotion* motions, ContactStore& store);
    double find_widest_gap(Pair& pair, const PrismPlace& a, const PrismPlace& b) const;
    static double known_gap(const Pair& pair, const PrismPlace& a, const PrismPlace& b);
    bool apart(Pair& pair, const PrismPlace& a, const PrismPlace& b) const;
    void look(Pair& pair, const BodyMotion* motions, ContactStore& store);
    static void drop(Pair& pair, ContactStore& store);

    std::vector<ContactElement> elements_;
    std::vector<std::uint8_t> there_, fixed_, asleep_;
    std::vector<double> path_;  ///< of any point of it as its neighbours see it, at most, since pairs were listed
    std::vector<double> roam_;  ///< of its bounds, at most, since then
    double radius_ = 0;         ///< of the largest element that moves
    double lever_ = 0;          ///< by how much a turn may move such a point
    double room_ = 0;           ///< in which two elements may move before pairs are listed anew
    double margin_ = 0;         ///< pairs this near are listed
    bool pieces_changed_ = true;
    bool moved_ = true;  ///< paths do not tell all
    NearPairs near_;
    std::vector<Bounds> bounds_;
    std::vector<Pair> pairs_, listed_;
    std::vector<Touching> touching_;
};

}  // namespace floes
