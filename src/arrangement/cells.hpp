#pragma once
// Cell list: cells no smaller than the reach of a rectangle, so that anything that may overlap it has its centre in the
// same cell or in one of the eight around it. The centres of a cell are contiguous in memory, because the sampler
// spends its time iterating over them.

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
    /// reach: least width of a cell, m; capacity: most residents of one cell; floes: their number. Throws InputError
    /// for a periodic area less than three cells wide, where a neighbour would be visited twice.
    Cells(const CellArea& area, double reach, int capacity, int floes);

    /// Index of the cell at a point of the area.
    int cell_at(double x, double z) const;

    /// The cell itself and those around it, the nearest kinds first.
    std::span<const int> neighbourhood(int cell) const {
        const auto at = static_cast<std::size_t>(cell);
        return {neighbours_.data() + neighbours_begin_[at], neighbours_begin_[at + 1] - neighbours_begin_[at]};
    }

    std::span<const Resident> residents(int cell) const {
        return {residents_.data() + first(cell), static_cast<std::size_t>(count_[static_cast<std::size_t>(cell)])};
    }

    void insert(const Resident& resident);
    /// Moves a rectangle that is in the list to its new place.
    void move(const Resident& resident);

  private:
    struct Slot {
        int cell = 0;
        int index = 0;
    };
    std::size_t first(int cell) const { return static_cast<std::size_t>(cell) * static_cast<std::size_t>(capacity_); }
    void erase(Slot slot);

    CellArea area_;
    int columns_;  // along x
    int rows_;     // along z
    double columns_per_metre_;
    double rows_per_metre_;
    int capacity_;
    std::vector<Resident> residents_;  // capacity_ places for each cell
    std::vector<int> count_;           // residents of a cell
    std::vector<Slot> slot_;           // place of each floe
    std::vector<int> neighbours_;
    std::vector<std::size_t> neighbours_begin_;
};

}  // namespace floes
