#include "water/water_lanes.hpp"

#include <fmt/ranges.h>

#include "core/error.hpp"
#include "solver/lane_width.hpp"

namespace floes {

extern const WaterKernel water_scalar;
#if defined(__x86_64__)
extern const WaterKernel water_sse2;
extern const WaterKernel water_avx2;
extern const WaterKernel water_avx512;
#endif

namespace {

constexpr std::size_t widest = 8;

WaterKernel water_kernel(int width) {
    static_cast<void>(lane_kernels(width));  // throws for a width that this processor does not have
#if defined(__x86_64__)
    if (width == 2) return water_sse2;
    if (width == 4) return water_avx2;
    if (width == 8) return water_avx512;
#endif
    return water_scalar;
}

}  // namespace

WaterLanes::WaterLanes(const WaterModel& model, std::size_t elements, int width)
    : kernel_(water_kernel(width)),
      factors_(model.factors()),
      stride_((elements + widest - 1) / widest * widest),
      state_(water_field::count * stride_),
      exposed_edges_(stride_),
      wrench_(wrench_fields * stride_) {}

void WaterLanes::set(std::size_t place, const ElementState& state) {
    double* at = state_.data() + place;
    const auto put = [&](const double* values, std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) at[(first + i) * stride_] = values[i];
    };
    put(state.position.data(), water_field::position, 3);
    put(state.rotation.data(), water_field::rotation, 9);  // by column, as in Eigen
    put(state.velocity.data(), water_field::velocity, 3);
    put(state.angular_velocity.data(), water_field::angular_velocity, 3);
    exposed_edges_[place] = state.exposed_edges;
}

void WaterLanes::compute(std::size_t count, double structure_x) {
    kernel_({state_.data(), exposed_edges_.data(), wrench_.data(), stride_}, factors_, count, structure_x);
}

Wrench WaterLanes::wrench(std::size_t place) const {
    const auto field = [&](std::size_t f) { return wrench_[f * stride_ + place]; };
    return {{field(0), field(1), field(2)}, {field(3), field(4), field(5)}};
}

}  // namespace floes
