#include "water/water_lanes.hpp"

#include <fmt/ranges.h>

#include "core/error.hpp"
#include "solver/lane_width.hpp"

namespace floes {

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
    put_fields(state, state_.data() + place, stride_);
    exposed_edges_[place] = state.exposed_edges;
}

void WaterLanes::compute(std::size_t count, double structure_x) {
    kernel_({state_.data(), exposed_edges_.data(), wrench_.data(), stride_}, factors_, count, structure_x);
}

Wrench WaterLanes::wrench(std::size_t place) const {
    return wrench_at(wrench_.data() + place, stride_);
}

}  // namespace floes
