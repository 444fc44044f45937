#pragma once
// A field without end of the cells of one Voronoi diagram, laid part after part as a tow needs it: a sheet that broke
// and opened. Of each part field.floes points are thrown; its floes are the next field.floes cells along x of the
// diagram of all points (outline/endless_cells.hpp), with their edges moved inwards by one distance that leaves the
// concentration. Cells that this would leave narrower than the ice is thick are open water.
//
// Part k is the same whatever the length of the run: a pure function of (scenario, seed, number, k).

#include <cstdint>
#include <vector>

#include "outline/endless_cells.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"

namespace floes {

class CellField {
  public:
    /// Nothing is laid yet. The scenario's shapes.kind is voronoi.
    CellField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number);

    /// Lays the next part. Its floes stand in the order of their cells' middles; they keep the clearance from each
    /// other, from those of the parts before and from the sides. Throws InputError if the cells are too narrow or lie
    /// too near.
    FieldPart next();

  private:
    void throw_points();
    std::vector<Outline> opened(std::size_t count, std::size_t& taken);
    void check_beside_last(const std::vector<SingleFloe>& floes) const;

    Scenario scenario_;
    std::uint64_t seed_;
    std::uint32_t number_;
    WaterArea strip_;  // of the points that are thrown next
    EndlessCells diagram_;
    std::uint64_t thrown_ = 0;      // times
    std::uint64_t parts_ = 0;       // laid
    std::vector<SingleFloe> last_;  // part
};

}  // namespace floes
