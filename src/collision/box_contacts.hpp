#pragma once
// Contacts between boxes, and prisms, from step to step: which touch, and where. The same points, to the last bit, as
// Bullet finds, which looks at every pair whose bounds are near each other in every step (of boxes; prisms are our
// own). Here a pair that a face separates is looked at again only when the two may have come as far as that.
//
//   contacts.add(box);                 // numbered from 0
//   contacts.find(motions);            // of all bodies, by number, once a step
//   for (touching pair) contacts.points(pair)

#include <cstdint>
#include <span>
#include <vector>

#include "collision/near_pairs.hpp"
#include "collision/prism.hpp"
#include "collision/touching_points.hpp"
#include "solver/body_motion.hpp"

namespace floes {

/// Lengths in m.
struct ContactBox {
    Triple half_extent{};
    double reach = 0;    ///< a point lasts while its halves are nearer than this
    bool fixed = false;  ///< never turns, and touches no other that is fixed
    bool is_box = true;  ///< otherwise only a number that is taken
    int piece = -1;      ///< boxes of one piece >= 0 do not touch
    Outline corners{};   ///< of a prism, in its own x and z; half_extent then bounds it
};

class BoxContacts {
  public:
    void add(const ContactBox& box);

    /// From the next find() on the box touches nothing; its number is free for another one.
    void take_out(std::uint32_t box);
    void put_in(std::uint32_t number, const ContactBox& box);

    /// In force from the next find() on.
    void set_piece(std::uint32_t box, int piece);

    /// Two boxes that sleep are not looked at; they must not move.
    void set_asleep(std::uint32_t box, bool asleep) { asleep_[box] = asleep ? 1 : 0; }

    /// The box is somewhere else now; contacts that it had begin anew.
    void move(std::uint32_t box);

    /// Boxes are not quite where their last motions led.
    void distrust() { moved_ = true; }

    /// Finds the points at which boxes touch. motions: of all that were added.
    void find(const BodyMotion* motions);

    struct Pair {
        std::uint32_t a;  ///< the lower number
        std::uint32_t b;
        double until;        ///< apart while the ways of both are less than this in sum, m
        std::int32_t patch;  ///< which points; -1 for none
        std::int32_t axis;   ///< the face normal that separated them last
    };

    /// Pairs with points, rising by (a, b). Valid until the next find().
    std::span<const Pair> touching() const { return touching_; }
    TouchingPoints& points(const Pair& pair) { return patches_[static_cast<std::size_t>(pair.patch)]; }
    const TouchingPoints& points(const Pair& pair) const { return patches_[static_cast<std::size_t>(pair.patch)]; }

  private:
    BoxPlace place(std::uint32_t box, const BodyMotion* motions) const {
        return {half_extent_[box].data(), motions[box].position, motions[box].rotation};
    }
    void sort_into_pieces();
    double walk(const BodyMotion* motions);
    void list_pairs(const BodyMotion* motions);
    bool apart(Pair& pair, const BodyMotion* motions) const;
    void look(Pair& pair, const BodyMotion* motions);
    void drop(Pair& pair);

    PrismPlace prism(std::uint32_t box, const BodyMotion* motions) const { return {&prism_[box], place(box, motions)}; }
    bool meets_prism(const Pair& pair) const { return is_prism_[pair.a] != 0 || is_prism_[pair.b] != 0; }
    void make_prisms(const Pair& pair);
    bool prisms_apart(Pair& pair, const BodyMotion* motions) const;

    std::vector<Triple> half_extent_;
    std::vector<PrismShape> prism_;  ///< of a box empty until it comes near a prism
    std::vector<std::uint8_t> is_prism_;
    std::vector<double> reach_;
    std::vector<std::uint8_t> fixed_, is_box_, asleep_;
    std::vector<int> piece_;
    std::vector<double> path_;  ///< of any point of the box as its neighbours see it, at most, since pairs were listed
    double lever_ = 0;          ///< by how much a turn may move such a point
    double room_ = 0;           ///< in which two boxes may move before pairs are listed anew
    double margin_ = 0;         ///< pairs this near are listed
    bool pieces_changed_ = true;
    bool moved_ = true;  ///< paths do not tell all
    NearPairs near_;
    std::vector<Bounds> bounds_;
    std::vector<Pair> pairs_, listed_, touching_;
    std::vector<TouchingPoints> patches_;
    std::vector<std::int32_t> free_patches_;
};

}  // namespace floes
