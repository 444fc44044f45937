#pragma once
// What the water kernels share with their caller: plain numbers and pointers only, since this header is compiled under
// every instruction set, and nothing inline may leak from one of those to another.

#include <cstddef>
#include <cstdint>

namespace floes {

/// Fields of an element. Rotation is column by column: the element's x, normal (y) and z in world axes.
namespace water_field {
inline constexpr std::size_t position = 0;
inline constexpr std::size_t rotation = 3;
inline constexpr std::size_t velocity = 12;
inline constexpr std::size_t spin = 15;
inline constexpr std::size_t count = 18;
}  // namespace water_field

/// Fields of the answer: force, then moment about the centre of mass.
inline constexpr std::size_t wrench_fields = 6;

/// WaterModel's constants, multiplied together as it does. Named after the terms of water_model.hpp.
struct WaterFactors {
    double half_side;
    double side;
    double thickness;
    double gauss_offset;
    double buoyancy;  ///< ρ_w g L²/4
    double form;      ///< -½ ρ_w C_d
    double skin;      ///< ½ ρ_w C_s L²/4
    double heave;     ///< ½ ρ_w C_h L²/4
    double linear;    ///< c/4
    double radius;    ///< of the waterline circle
    double speed;     ///< of the tow; 0 in still water
};

/// Arrays of elements side by side: field f of element i is at [f * stride + i]. All start on a vector boundary, the
/// stride is a whole number of the widest vectors.
struct WaterArrays {
    const double* state;
    const std::int64_t* exposed_edges;  ///< the bits of ElementState
    double* wrench;
    std::size_t stride;
};

/// Force and moment on elements [0, count), and on those that fill up the last group of lanes. The same bits as
/// WaterModel::wrench at every width.
using WaterKernel = void (*)(const WaterArrays&, const WaterFactors&, std::size_t count, double structure_x);

}  // namespace floes
