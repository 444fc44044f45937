#include "water/water_lanes.hpp"

#include <fmt/ranges.h>

#include <algorithm>

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

WaterFactors with(WaterTerms terms, WaterFactors factors) {
    if (terms < WaterTerms::buoyancy_and_wind) factors.wind_x = factors.wind_z = 0;
    if (terms < WaterTerms::and_plane_drag) factors.form = factors.skin = 0;
    if (terms < WaterTerms::all_but_waves) factors.heave = 0;
    if (terms < WaterTerms::all) factors.waves_below = 0;
    return factors;
}

}  // namespace

WaterLanes::WaterLanes(std::span<const WaterModel> models, std::span<const std::size_t> model_of, int width,
                       std::vector<PolygonWater> polygons)
    : kernel_(water_kernel(width)),
      group_of_(model_of.begin(), model_of.end()),
      place_of_(model_of.size()),
      is_set_(model_of.size()),
      polygon_water_(std::move(polygons)) {
    for (const WaterModel& model : models) groups_.push_back({model.factors(), model.flows()});
    for (std::size_t element = 0; element < group_of_.size(); ++element) {
        const std::size_t group = group_of_[element];
        linear_of_.push_back(
            (is_polygon(element) ? polygon_water_[group - models.size()].damping() : models[group].damping()) / 4);
        if (!is_polygon(element)) {
            ++groups_[group].elements;
            continue;
        }
        place_of_[element] = polygons_.size();
        polygons_.push_back({element, {}, {}});
    }
    for (Group& group : groups_) {
        group.first = stride_;
        stride_ += (group.elements + widest - 1) / widest * widest;
    }
    state_ = AlignedArray<double>(water_field::count * stride_);
    exposed_edges_ = AlignedArray<std::int64_t>(stride_);
    linear_ = AlignedArray<double>(stride_);
    wrench_ = AlignedArray<double>(wrench_fields * stride_);
}

void WaterLanes::move_structure(const StructureInWater& structure) {
    for (Group& group : groups_) follow_structure(group.factors, group.flows, structure);
    for (PolygonWater& water : polygon_water_) water.move_structure(structure);
}

void WaterLanes::clear() {
    for (Group& group : groups_) group.count = 0;
    std::ranges::fill(is_set_, std::uint8_t{0});
}

void WaterLanes::set(std::size_t element, const ElementState& state) {
    is_set_[element] = 1;
    if (is_polygon(element)) {
        polygons_[place_of_[element]].state = state;
        return;
    }
    Group& group = groups_[group_of_[element]];
    const std::size_t place = place_of_[element] = group.first + group.count++;
    put_fields(state, state_.data() + place, stride_);
    exposed_edges_[place] = state.exposed_edges;
    linear_[place] = linear_of_[element];
}

void WaterLanes::compute(double structure_x, WaterTerms terms) {
    for (Polygon& one : polygons_) {
        if (!is_set(one.element)) continue;
        const PolygonWater& water = polygon_water_[group_of_[one.element] - groups_.size()];
        one.wrench = water.wrench(one.state, with(terms, water.factors()), 4 * linear_of_[one.element], structure_x);
    }
    for (const Group& group : groups_) {
        const WaterFactors factors = with(terms, group.factors);
        kernel_({state_.data() + group.first, exposed_edges_.data() + group.first, linear_.data() + group.first,
                 wrench_.data() + group.first, stride_},
                factors, group.count, structure_x);
    }
}

Wrench WaterLanes::wrench(std::size_t element) const {
    if (is_polygon(element)) return polygons_[place_of_[element]].wrench;
    return wrench_at(wrench_.data() + place_of_[element], stride_);
}

}  // namespace floes
