#pragma once
// The force of the water (water_model.hpp) on many elements at once, one for each SIMD lane. The same bits at every
// width.
//
//   water.clear();
//   water.set(element, state);      // of each element that is to be computed; fastest where neighbours in this order
//   water.compute(structure_x);     // have the same exposed edges
//   water.wrench(element);
//
// Elements that differ in nothing but their plan and damping fill lanes together, so a vector of squares of several
// sizes or thicknesses is a few lanes short.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "solver/aligned_array.hpp"
#include "water/water_kernels.hpp"
#include "water/water_model.hpp"

namespace floes {

/// Which forces of the water and the wind are computed; drag in the plane of the ice is form and skin drag.
enum class WaterTerms { buoyancy, buoyancy_and_wind, and_plane_drag, all_but_waves, all };

class WaterLanes {
  public:
    /// model_of: by element, the index of its model. width: one of lane_widths(); throws RunError for any other.
    WaterLanes(std::span<const WaterModel> models, std::span<const std::size_t> model_of, int width);

    /// Damping c of an element from now on, kg/s (water_model.hpp); that of an element alone at first.
    void set_damping(std::size_t element, double damping) { linear_of_[element] = damping / 4; }

    /// Flow round a structure that is and moves like this from now on; at first it is at z = 0 without yaw, with the
    /// speed of the models along +x.
    void move_structure(const StructureInWater& structure);

    void clear();
    void set(std::size_t element, const ElementState& state);

    /// Forces on the elements set since clear(), with the structure's axis at x = `structure_x`, m.
    void compute(double structure_x, WaterTerms terms = WaterTerms::all);

    /// Whether the element was set since clear().
    bool is_set(std::size_t element) const { return is_set_[element] != 0; }

    /// From the last compute: force (N) and moment about the centre of mass (N m), world axes.
    Wrench wrench(std::size_t element) const;

  private:
    /// Elements of one kind, side by side from a vector boundary on.
    struct Group {
        WaterFactors factors;
        bool flows = false;     ///< round the structure
        std::size_t edges = 0;  ///< most of any plan
        std::size_t elements = 0;
        std::size_t first = 0;
        std::size_t count = 0;
    };

    WaterKernel kernel_;
    std::vector<Group> groups_;
    std::vector<std::size_t> group_of_;       // by element
    std::vector<std::size_t> place_of_;       // by element
    std::vector<std::size_t> plan_of_;        // by element: its model
    std::vector<std::vector<double>> plans_;  // by model: fields of plan_field
    std::vector<double> linear_of_;           // by element: c/4
    std::vector<std::uint8_t> is_set_;        // by element
    std::size_t stride_ = 0;
    AlignedArray<double> state_;
    AlignedArray<std::int64_t> exposed_edges_;
    AlignedArray<double> linear_;
    AlignedArray<double> wrench_;
    AlignedArray<double> plan_;  // of the last element at each place
};

}  // namespace floes
