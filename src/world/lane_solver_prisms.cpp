// What contacts of prisms need that boxes have in their kernels: which faces lie inside the ice, and how much crushes.

#include "world/lane_solver.hpp"

namespace floes {
namespace {

/// A direction of the world in the axes of a body.
Triple own_axes(const double* r, const Triple& d, double sign) {
    return {sign * (r[0] * d[0] + r[3] * d[1] + r[6] * d[2]), sign * (r[1] * d[0] + r[4] * d[1] + r[7] * d[2]),
            sign * (r[2] * d[0] + r[5] * d[1] + r[8] * d[2])};
}

}  // namespace

/// The edge on which a joint lies has the joint's x axis as its normal: out of a, and into b.
void LaneSolver::hold_edge(std::uint32_t number, const SolverFrame& frame, double outward, bool held) {
    Body& body = bodies_[number];
    if (!body.parts.is_prism) return;
    const auto& r = frame.rotation;
    const int edge = edge_towards(body.prism, {outward * r[0], outward * r[3], outward * r[6]});
    if (edge < 0) return;
    std::uint8_t& joints = body.joints_at[static_cast<std::size_t>(edge)];
    joints = static_cast<std::uint8_t>(joints + (held ? 1 : -1));
}

/// Whether a normal, from b to a, leaves a prism through an edge that another element of its floe covers.
bool LaneSolver::is_inside(std::uint32_t a, std::uint32_t b, const Triple& normal) const {
    if (definition_.contact.internal_edges) return false;
    const auto leaves = [&](std::uint32_t number, double sign) {
        const Body& body = bodies_[number];
        if (!body.parts.is_prism) return false;
        const int edge = edge_towards(body.prism, own_axes(system_->motions()[number].rotation, normal, sign));
        return edge >= 0 && body.joints_at[static_cast<std::size_t>(edge)] > 0;
    };
    return leaves(a, -1) || leaves(b, 1);
}

/// The smaller of the two bodies' sections, where one of them is a prism.
void LaneSolver::set_section(SolverContact& contact) const {
    if (definition_.contact.normal == NormalLaw::rigid || (!is_prism(contact.a) && !is_prism(contact.b))) return;
    for (const auto& [number, sign] : {std::pair(contact.a, 1.0), std::pair(contact.b, -1.0)}) {
        const Body& body = bodies_[number];
        const PrismShape box = body.parts.is_prism ? PrismShape{} : prism_of_box(body.parts.half_extent);
        const PrismShape& prism = body.parts.is_prism ? body.prism : box;
        if (prism.empty()) continue;  // the structure: flat and unbounded
        const Triple inwards = own_axes(system_->motions()[number].rotation, contact.normal, sign);
        const PrismSection section = crushed_section(prism, inwards, -contact.distance);
        if (contact.section >= 0 && contact.section <= section.area) continue;
        contact.section = section.area;
        contact.section_growth = section.growth;
    }
}

}  // namespace floes
