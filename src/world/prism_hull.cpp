#include "world/prism_hull.hpp"

#include <algorithm>
#include <memory>

namespace floes {

PrismHull::PrismHull(const PrismDefinition& definition) : prism_(definition.corners, definition.half_thickness) {
    const double share = 0.1;  // of the smallest half extent, as of a btBoxShape
    const double margin = share * std::min(definition.half_thickness, inner_radius(definition.corners));
    const double half = definition.half_thickness - margin;
    for (const Corner& one : eroded(definition.corners, margin)) {
        addPoint({one.x, half, one.z}, false);
        addPoint({one.x, -half, one.z}, false);
    }
    setMargin(margin);
    recalcLocalAabb();
}

void PrismHull::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
    const Measures of = measures_of(prism_.corners);
    const double thin = prism_.half_thickness * prism_.half_thickness / 3;
    inertia = mass * btVector3(of.zz / of.area + thin, (of.xx + of.zz) / of.area, of.xx / of.area + thin);
}

PrismHull* PrismHulls::take(const PrismDefinition& prism) {
    if (unused_.empty()) return &hulls_.emplace_back(prism);
    PrismHull* const hull = unused_.back();
    unused_.pop_back();
    std::destroy_at(hull);
    return std::construct_at(hull, prism);
}

void PrismHulls::give_back(const btCollisionShape* shape) {
    const auto is_it = [&](const PrismHull& hull) { return &hull == shape; };
    unused_.push_back(&*std::ranges::find_if(hulls_, is_it));
}

}  // namespace floes
