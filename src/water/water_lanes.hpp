#pragma once
// The force of the water (water_model.hpp) on many elements at once, one for each SIMD lane. The same bits at every
// width.
//
//   water.set(place, element);           // places 0, 1, ... in any order; neighbours with the same exposed edges are
//   water.compute(count, structure_x);   // computed fastest
//   water.wrench(place);

#include <cstddef>
#include <cstdint>

#include "core/vector.hpp"
#include "solver/aligned_array.hpp"
#include "water/water_kernels.hpp"
#include "water/water_model.hpp"

namespace floes {

class WaterLanes {
  public:
    /// Space for `elements` elements. width: one of lane_widths(); throws RunError for any other.
    WaterLanes(const WaterModel& model, std::size_t elements, int width);

    void set(std::size_t place, const ElementState& state);

    /// Forces on the elements at places [0, count), with the structure's axis at x = `structure_x`, m.
    void compute(std::size_t count, double structure_x);

    /// Of the last compute: force (N) and moment about the centre of mass (N m), world axes.
    Wrench wrench(std::size_t place) const;

  private:
    WaterKernel kernel_;
    WaterFactors factors_;
    std::size_t stride_;
    AlignedArray<double> state_;
    AlignedArray<std::int64_t> exposed_edges_;
    AlignedArray<double> wrench_;
};

}  // namespace floes
