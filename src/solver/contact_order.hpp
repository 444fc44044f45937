#pragma once
// In what order contacts are solved, and where in the lanes their rows lie.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/lane_layout.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

/// Neighbouring contacts of the same two bodies stay together, as a pair. Pairs that share no moving body commute, so
/// those of a level are solved side by side, and levels one after the other. Where the result must be that of the given
/// order, each pair goes to the level after the last one that moved its bodies; otherwise to the first level in which
/// nothing moves them, which makes few levels, with hardly a lane empty.
class ContactOrder {
  public:
    enum class Order { as_given, any };

    struct Contact {
        std::uint32_t a, b;              ///< slots of the bodies
        std::uint32_t a_group, b_group;  ///< what moves together with them: below `spare`
        bool a_moves, b_moves;
        bool pressed;  ///< carries an impulse already
    };

    /// spare: the slot after those of all bodies; width and turns: see LaneKernels.
    void lay_out(std::span<const Contact> contacts, std::uint32_t spare, int width, int turns,
                 Order order = Order::as_given);

    ContactPacks packs() const { return {pack_slots_.data(), packs_.data(), packs_.size(), spare_}; }
    std::size_t rows() const { return packs_.empty() ? 0 : packs_.back().end_row; }

    /// Places of a contact's rows: row * width + lane.
    std::uint32_t slot(std::size_t contact) const { return row_slots_[contact]; }

  private:
    struct Pair {
        std::uint32_t level;
        bool pressed;
        std::uint32_t contacts;
        std::uint32_t first;
    };
    void add_pack(std::span<const Contact> contacts, std::span<const Pair> pairs, std::uint32_t width,
                  std::uint32_t before);
    void find_pairs(std::span<const Contact> contacts, Order order);
    std::uint32_t next_level(const Contact& pair);
    std::uint32_t first_level(const Contact& pair);
    void sort_pairs();

    std::uint32_t spare_ = 0;
    std::vector<Pair> pairs_, sorted_;
    std::vector<std::uint32_t> start_;       ///< of each rank in sorted_
    std::vector<std::uint32_t> next_level_;  ///< by group
    std::vector<std::uint64_t> levels_;      ///< by group: one bit for each of the first levels that moves it
    std::vector<ContactPack> packs_;
    std::vector<std::uint32_t> pack_slots_, row_slots_;
};

// Contacts as the kernels see them, in the lanes of their rows.

/// Fields of point_field, by groups of `width`. Empty places get a gap that never closes.
void fill_points(AlignedArray<double>& points, std::span<const SolverContact> contacts, const ContactOrder& order,
                 int width);

/// The friction impulses that contacts bring along, world axes, N s: 3 fields by groups of `width`.
void fill_friction_start(AlignedArray<double>& start, std::span<const SolverContact> contacts,
                         const ContactOrder& order, int width);

/// The friction that a solve found, world axes, N s: its size, and its direction where there is any.
void set_friction(SolverContact& contact, const std::array<double, 3>& impulse);

}  // namespace floes
