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

WaterLanes::WaterLanes(std::span<const WaterModel> models, std::span<const std::size_t> model_of, int width)
    : kernel_(water_kernel(width)), group_of_(model_of.begin(), model_of.end()), place_of_(model_of.size()) {
    for (const WaterModel& model : models) groups_.push_back({model.factors()});
    for (const std::size_t group : group_of_) ++groups_[group].elements;
    for (Group& group : groups_) {
        group.first = stride_;
        stride_ += (group.elements + widest - 1) / widest * widest;
    }
    state_ = AlignedArray<double>(water_field::count * stride_);
    exposed_edges_ = AlignedArray<std::int64_t>(stride_);
    wrench_ = AlignedArray<double>(wrench_fields * stride_);
}

void WaterLanes::clear() {
    for (Group& group : groups_) group.count = 0;
}

void WaterLanes::set(std::size_t element, const ElementState& state) {
    Group& group = groups_[group_of_[element]];
    const std::size_t place = place_of_[element] = group.first + group.count++;
    put_fields(state, state_.data() + place, stride_);
    exposed_edges_[place] = state.exposed_edges;
}

void WaterLanes::compute(double structure_x) {
    for (const Group& group : groups_)
        kernel_(
            {state_.data() + group.first, exposed_edges_.data() + group.first, wrench_.data() + group.first, stride_},
            group.factors, group.count, structure_x);
}

Wrench WaterLanes::wrench(std::size_t element) const {
    return wrench_at(wrench_.data() + place_of_[element], stride_);
}

}  // namespace floes
