#include "arrangement/cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/error.hpp"

namespace floes {

namespace {

constexpr double rounding = 1e-9;  // relative

/// At least as wide as the floes lie apart on average: a wide area with few of them is not divided into millions.
double width_of(const CellArea& area, double reach, std::size_t floes) {
    const double wanted = reach * (1 + rounding);
    if (area.periodic) return wanted;
    return std::max(wanted,
                    std::sqrt(area.length * area.breadth / static_cast<double>(std::max<std::size_t>(floes, 1))));
}

int cells_along(double length, double width, bool periodic) {
    const int count = length > width ? static_cast<int>(std::floor(length / width)) : 1;
    if (periodic && count < 3) {
        throw InputError("a periodic box must be at least three floe diagonals wide; use more floes");
    }
    return count;
}

}  // namespace

Cells::Cells(const CellArea& area, double reach, std::size_t floes)
    : area_(area),
      columns_(cells_along(area.length, width_of(area, reach, floes), area.periodic)),
      rows_(cells_along(area.breadth, width_of(area, reach, floes), area.periodic)),
      columns_per_metre_(area.length > 0 ? columns_ / area.length : 0),
      rows_per_metre_(area.breadth > 0 ? rows_ / area.breadth : 0),
      count_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0),
      residents_(count_.size() * static_cast<std::size_t>(capacity_)),
      slot_(floes),
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
    const auto number = [](double cells, int count) { return static_cast<int>(std::clamp(cells, 0.0, count - 1.0)); };
    return number((x - area_.low_x) * columns_per_metre_, columns_) * rows_ +
           number((z - area_.low_z) * rows_per_metre_, rows_);
}

void Cells::insert(const Resident& resident) {
    const int cell = cell_at(resident.x, resident.z);
    int& count = count_[static_cast<std::size_t>(cell)];
    if (count == capacity_) make_room();
    residents_[first(cell) + static_cast<std::size_t>(count)] = resident;
    slot_[static_cast<std::size_t>(resident.floe)] = {cell, count};
    ++count;
}

void Cells::make_room() {
    const int before = std::exchange(capacity_, 2 * capacity_);
    std::vector<Resident> residents(count_.size() * static_cast<std::size_t>(capacity_));
    for (std::size_t cell = 0; cell < count_.size(); ++cell) {
        std::copy_n(residents_.begin() + static_cast<std::ptrdiff_t>(cell) * before, count_[cell],
                    residents.begin() + static_cast<std::ptrdiff_t>(cell) * capacity_);
    }
    residents_ = std::move(residents);
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
