#pragma once
// Cell list, the search for neighbours of this room: cells no smaller than the reach of a rectangle, so that anything
// within reach has its centre in the same cell or in one of the eight around it. The centres of a cell are contiguous
// in memory, because the sampler spends its time iterating over them.

#include <cstdint>
#include <span>
#include <vector>

#include "core/turn.hpp"

namespace floes {

/// The area to be divided.
struct CellArea {
    double low_x = 0;
    double low_z = 0;
    double length = 0;
    double breadth = 0;
    bool periodic = false;
};

/// A rectangle in a cell.
struct Resident {
    double x = 0;
    double z = 0;
    Turn turn;
    int floe = 0;
};

class Cells {
  public:
    /// reach: least width of a cell, m; floes: their number. Throws InputError for a periodic area less than three
    /// cells wide, where a neighbour would be visited twice.
    Cells(const CellArea& area, double reach, std::size_t floes);

    void insert(const Resident& resident);
    /// Moves a rectangle that is in the list to its new place.
    void move(const Resident& resident);

    /// Whether `holds(resident)` for any that may be within reach of a point; in no order, and none after the first.
    template <class Holds>
    bool any_near(double x, double z, const Holds& holds) const {
        for (const int cell : neighbourhood(cell_at(x, z))) {
            for (const Resident& resident : residents(cell)) {
                if (holds(resident)) return true;
            }
        }
        return false;
    }

    /// `see(resident)` for all that may be within reach of a point, in no order.
    template <class See>
    void for_each_near(double x, double z, const See& see) const {
        any_near(x, z, [&](const Resident& resident) {
            see(resident);
            return false;
        });
    }

  private:
    struct Slot {
        int cell = 0;
        int index = 0;
    };

    /// Of the cell at a point; a point beyond an edge belongs to the cell at that edge.
    int cell_at(double x, double z) const;

    /// The cell itself and those around it, the nearest kinds first.
    std::span<const int> neighbourhood(int cell) const {
        const auto at = static_cast<std::size_t>(cell);
        return {neighbours_.data() + neighbours_begin_[at], neighbours_begin_[at + 1] - neighbours_begin_[at]};
    }

    std::span<const Resident> residents(int cell) const {
        return {residents_.data() + first(cell), static_cast<std::size_t>(count_[static_cast<std::size_t>(cell)])};
    }

    std::size_t first(int cell) const { return static_cast<std::size_t>(cell) * static_cast<std::size_t>(capacity_); }
    void erase(Slot slot);
    void make_room();

    CellArea area_;
    int columns_;  // along x
    int rows_;     // along z
    double columns_per_metre_;
    double rows_per_metre_;
    int capacity_ = 4;                 // places for each cell
    std::vector<int> count_;           // residents of a cell
    std::vector<Resident> residents_;  // by cell
    std::vector<Slot> slot_;           // place of each floe
    std::vector<int> neighbours_;
    std::vector<std::size_t> neighbours_begin_;
};

}  // namespace floes
