#include "water/water_lanes.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "solver/lane_width.hpp"

namespace floes {

namespace {

constexpr std::size_t widest = 8;
constexpr std::size_t edges_of_square = 4;

WaterKernel water_kernel(int width) {
    static_cast<void>(lane_kernels(width));  // throws for a width that this processor does not have
#if defined(__x86_64__)
    if (width == 2) return water_sse2;
    if (width == 4) return water_avx2;
    if (width == 8) return water_avx512;
#endif
    return water_scalar;
}

WaterFactors with_first(std::size_t terms, WaterFactors factors) {
    for (std::size_t k = terms; k < water_terms.size(); ++k) water_terms[k].leave_out(factors);
    return factors;
}

}  // namespace

WaterLanes::WaterLanes(std::span<const WaterModel> models, std::span<const std::size_t> model_of, int width)
    : kernel_(water_kernel(width)),
      place_of_(model_of.size()),
      plan_of_(model_of.begin(), model_of.end()),
      is_set_(model_of.size()) {
    std::vector<std::size_t> group_of_model;
    std::size_t edges = 0;  // most of any plan
    for (const WaterModel& model : models) {
        auto group = std::ranges::find(groups_, model.factors(), &Group::factors);
        if (group == groups_.end()) group = groups_.insert(group, Group{model.factors(), model.flows()});
        group_of_model.push_back(static_cast<std::size_t>(group - groups_.begin()));
        const std::vector<double>& plan = plans_.emplace_back(model.plan());
        if (!plan.empty())
            group->edges = std::max(group->edges, (plan.size() - plan_field::first_edge) / plan_field::of_edge);
        edges = std::max(edges, group->edges);
    }
    // Zeros stand for the edges that an element has not, or there would be those of what had its place before.
    for (std::size_t i = 0; i < plans_.size(); ++i)
        if (!plans_[i].empty())
            plans_[i].resize(plan_field::first_edge + plan_field::of_edge * groups_[group_of_model[i]].edges);
    for (const std::size_t model : model_of) {
        group_of_.push_back(group_of_model[model]);
        linear_of_.push_back(models[model].damping() / 4);
        ++groups_[group_of_.back()].elements;
    }
    for (Group& group : groups_) {
        group.first = stride_;
        stride_ += (group.elements + widest - 1) / widest * widest;
    }
    state_ = AlignedArray<double>(water_field::count * stride_);
    exposed_edges_ = AlignedArray<std::int64_t>(stride_);
    linear_ = AlignedArray<double>(stride_);
    wrench_ = AlignedArray<double>(wrench_fields * stride_);
    shelter_ = AlignedArray<double>(2 * std::max(edges, edges_of_square) * stride_);
    if (edges > 0) plan_ = AlignedArray<double>((plan_field::first_edge + plan_field::of_edge * edges) * stride_);
}

void WaterLanes::move_structure(const StructureInWater& structure) {
    for (Group& group : groups_) follow_structure(group.factors, group.flows, structure);
}

void WaterLanes::clear() {
    for (Group& group : groups_) group.count = 0;
    std::ranges::fill(is_set_, std::uint8_t{0});
}

void WaterLanes::set(std::size_t element, const ElementState& state) {
    is_set_[element] = 1;
    Group& group = groups_[group_of_[element]];
    const std::size_t place = place_of_[element] = group.first + group.count++;
    put_fields(state, state_.data() + place, stride_);
    put_shelter(state, shelter_.data() + place, stride_);
    exposed_edges_[place] = state.exposed_edges;
    linear_[place] = linear_of_[element];
    const std::vector<double>& plan = plans_[plan_of_[element]];
    for (std::size_t f = 0; f < plan.size(); ++f) plan_[f * stride_ + place] = plan[f];
}

void WaterLanes::compute(double structure_x, std::size_t terms) {
    for (const Group& group : groups_) {
        const WaterFactors factors = with_first(terms, group.factors);
        kernel_({state_.data() + group.first, exposed_edges_.data() + group.first, linear_.data() + group.first,
                 wrench_.data() + group.first, stride_, shelter_.data() + group.first, plan_.data() + group.first,
                 group.edges},
                factors, group.count, structure_x);
    }
}

bool WaterLanes::acts(std::size_t term) const {
    return std::ranges::any_of(groups_, [&](const Group& group) {
        WaterFactors without = group.factors;
        water_terms[term].leave_out(without);
        return without != group.factors;
    });
}

Wrench WaterLanes::wrench(std::size_t element) const {
    return wrench_at(wrench_.data() + place_of_[element], stride_);
}

void WaterLanes::archive(StateArchive& state) {
    auto& [kernel, groups, group_of, place_of, plan_of, plans, linear_of, set, stride, states, exposed_edges, linear,
           wrenches, shelter, plan] = *this;  // all else is of the step
    state(linear_of);
}

}  // namespace floes
