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

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "solver/aligned_array.hpp"
#include "statistics/work_shares.hpp"
#include "water/water_kernels.hpp"
#include "water/water_model.hpp"

namespace floes {

/// A force of the water or the wind on floes.
struct WaterTerm {
    void (*leave_out)(WaterFactors&);  ///< factors with which the kernel computes everything else
    double WorkShares::*work;          ///< where its work goes
};

/// All of them, in the order in which a split adds one after the other. A new one is its part of the kernel with its
/// factors (water_kernels), what they are (water_model), its keys (scenario/tables_field.cpp) and its line here.
inline constexpr std::array water_terms{
    WaterTerm{[](WaterFactors& factors) { factors.buoyancy = 0; }, &WorkShares::lifting},
    WaterTerm{[](WaterFactors& factors) { factors.wind_x = factors.wind_z = 0; }, &WorkShares::driving},
    WaterTerm{[](WaterFactors& factors) { factors.form = factors.skin = 0; }, &WorkShares::plane_drag},
    WaterTerm{[](WaterFactors& factors) { factors.heave = 0; }, &WorkShares::vertical_drag},
    WaterTerm{[](WaterFactors& factors) { factors.waves_below = 0; }, &WorkShares::waves}};

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

    /// Forces on the elements set since clear(), with the structure's axis at x = `structure_x`, m: the sum of the
    /// first `terms` of water_terms.
    void compute(double structure_x, std::size_t terms = water_terms.size());

    /// Whether the term acts on any element.
    bool acts(std::size_t term) const;

    /// Whether the element was set since clear().
    bool is_set(std::size_t element) const { return is_set_[element] != 0; }

    /// From the last compute: force (N) and moment about the centre of mass (N m), world axes.
    Wrench wrench(std::size_t element) const;

    /// What set_damping() was told, saved or set (core/state_archive.hpp).
    void archive(StateArchive& state);

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
    AlignedArray<double> shelter_;
    AlignedArray<double> plan_;  // of the last element at each place
};

}  // namespace floes
