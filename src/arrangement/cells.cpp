#include "arrangement/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"

namespace floes {

namespace {

int cells_along(double length, double reach, bool periodic) {
    const int count = std::max(1, static_cast<int>(std::floor(length / reach)));
    if (periodic && count < 3) {
        throw InputError("a periodic box must be at least three floe diagonals wide; use more floes");
    }
    return count;
}

}  // namespace

Cells::Cells(const CellArea& area, double reach, int capacity, int floes)
    : area_(area),
      columns_(cells_along(area.length, reach, area.periodic)),
      rows_(cells_along(area.breadth, reach, area.periodic)),
      columns_per_metre_(columns_ / area.length),
      rows_per_metre_(rows_ / area.breadth),
      capacity_(capacity),
      residents_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) *
                 static_cast<std::size_t>(capacity)),
      count_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0),
      slot_(static_cast<std::size_t>(floes)),
      neighbours_begin_{0} {
    constexpr std::array<std::array<int, 2>, 9> steps{
        {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    for (int column = 0; column < columns_; ++column) {
        for (int row = 0; row < rows_; ++row) {
            for (const auto& [to_column, to_row] : steps) {
                int other_column = column + to_column;
                int other_row = row + to_row;
                if (area.periodic) {
                    other_column = (other_column + columns_) % columns_;
                    other_row = (other_row + rows_) % rows_;
                }
                if (other_column < 0 || other_column >= columns_ || other_row < 0 || other_row >= rows_) continue;
                neighbours_.push_back(other_column * rows_ + other_row);
            }
            neighbours_begin_.push_back(neighbours_.size());
        }
    }
}

int Cells::cell_at(double x, double z) const {
    // A point on the far edge belongs to the last cell.
    const int column = std::min(static_cast<int>((x - area_.low_x) * columns_per_metre_), columns_ - 1);
    const int row = std::min(static_cast<int>((z - area_.low_z) * rows_per_metre_), rows_ - 1);
    return column * rows_ + row;
}

void Cells::insert(const Resident& resident) {
    const int cell = cell_at(resident.x, resident.z);
    int& count = count_[static_cast<std::size_t>(cell)];
    if (count == capacity_)
        throw RunError("floes of the starting arrangement overlap: more centres in a cell than fit");
    residents_[first(cell) + static_cast<std::size_t>(count)] = resident;
    slot_[static_cast<std::size_t>(resident.floe)] = {cell, count};
    ++count;
}

void Cells::erase(Slot slot) {
    int& count = count_[static_cast<std::size_t>(slot.cell)];
    --count;
    const Resident& last = residents_[first(slot.cell) + static_cast<std::size_t>(count)];
    slot_[static_cast<std::size_t>(last.floe)] = slot;
    residents_[first(slot.cell) + static_cast<std::size_t>(slot.index)] = last;
}

void Cells::move(const Resident& resident) {
    const Slot slot = slot_[static_cast<std::size_t>(resident.floe)];
    if (cell_at(resident.x, resident.z) == slot.cell) {
        residents_[first(slot.cell) + static_cast<std::size_t>(slot.index)] = resident;
        return;
    }
    erase(slot);
    insert(resident);
}

}  // namespace floes
