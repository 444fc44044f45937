#pragma once
// Interface between the water kernels and their caller. It has only plain numbers and pointers, because this header is
// compiled for every instruction set, and inline code must not leak from one to another.

#include <cstddef>
#include <cstdint>

namespace floes {

/// Fields of an element. The rotation is stored by column: the element's x, normal (y) and z in world axes.
namespace water_field {
inline constexpr std::size_t position = 0;
inline constexpr std::size_t rotation = 3;
inline constexpr std::size_t velocity = 12;
inline constexpr std::size_t angular_velocity = 15;
inline constexpr std::size_t count = 18;
}  // namespace water_field

/// Fields of the result: force, then moment about the centre of mass.
inline constexpr std::size_t wrench_fields = 6;

/// Round what the water flows, if not round the circle: up to so many ellipses.
inline constexpr int most_flow_ellipses = 8;

/// In the structure's axes.
struct FlowEllipse {
    double x, z;                       ///< of its middle, m
    double half_length, half_breadth;  ///< along x and z, m
    bool operator==(const FlowEllipse&) const = default;
};

/// Constants of the terms of water_model.hpp. With A the area of a square, and 4 m² for other elements, whose plan has
/// their own.
struct WaterFactors {
    double side;  ///< of a square, m; 0: elements are of any plan
    double thickness;
    double buoyancy;              ///< ρ_w g
    double form;                  ///< -½ ρ_w C_d
    double skin;                  ///< ½ ρ_w C_s A/4
    double heave;                 ///< ½ ρ_w C_h A/4
    double waves_below;           ///< m: columns submerged by less make waves, so that linear damping acts there
    double radius;                ///< of the waterline circle
    double speed;                 ///< of the tow; 0 in still water
    bool drifts;                  ///< whether any of what follows is not as in still air and water, on a straight tow
    double structure_z;           ///< of the structure's axis, m
    double speed_across;          ///< of the structure through the water along z; `speed` is that along x then
    double current_x, current_z;  ///< of the water far away, m/s
    double turn_cos, turn_sin;    ///< of the turning angle
    double wind_x, wind_z;        ///< force on A/4 of an element's top, N
    int ellipses;                 ///< 0: the circle of `radius` about the axis
    FlowEllipse ellipse[most_flow_ellipses];
    double yaw_cos, yaw_sin;  ///< of the structure, about +y; ellipses turn with it
    bool operator==(const WaterFactors&) const = default;
};

/// Fields of the plan of an element that is no square, in its own axes: where its four columns stand, a quarter of its
/// area, and then of each edge its middle, its outward normal and its length; 0 for edges that it has not.
namespace plan_field {
inline constexpr std::size_t column_x = 0;  // m; columns are at (±x, ±z)
inline constexpr std::size_t column_z = 1;
inline constexpr std::size_t quarter = 2;  // m²
inline constexpr std::size_t first_edge = 3;
inline constexpr std::size_t of_edge = 5;  // x, z, normal x, normal z, length
}  // namespace plan_field

/// Structure of arrays: field f of element i is at [f * stride + i]. All start on a vector boundary; the stride is a
/// multiple of the widest vector.
struct WaterArrays {
    const double* state;
    const std::int64_t* exposed_edges;  ///< the bits of ElementState
    const double* linear;               ///< c/4 of each element
    double* wrench;
    std::size_t stride;
    const double* shelter;  ///< of edge k the two values of EdgeShelter, fields 2 k and 2 k + 1; where it is exposed
    const double* plan;     ///< fields as above, where elements are no squares
    std::size_t edges;      ///< most of any element
};

/// Force and moment on elements [0, count) and on those that fill the last group of lanes; the same bits at every
/// width.
using WaterKernel = void (*)(const WaterArrays&, const WaterFactors&, std::size_t count, double structure_x);

extern const WaterKernel water_scalar;
#if defined(__x86_64__)
extern const WaterKernel water_sse2;
extern const WaterKernel water_avx2;
extern const WaterKernel water_avx512;
#endif

}  // namespace floes
