#include "world/ice_shape.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

PrismHull::PrismHull(const Outline& corners, double half_thickness)
    : corners_(corners), half_thickness_(half_thickness) {
    const double share = 0.1;  // of the smallest half extent, as of a btBoxShape
    const double margin = share * std::min(half_thickness, inner_radius(corners));
    const double half = half_thickness - margin;
    for (const Corner& one : eroded(corners, margin)) {
        addPoint({one.x, half, one.z}, false);
        addPoint({one.x, -half, one.z}, false);
    }
    setMargin(margin);
    recalcLocalAabb();
}

void PrismHull::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
    const Measures of = measures_of(corners_);
    const double thin = half_thickness_ * half_thickness_ / 3;
    inertia = mass * btVector3(of.zz / of.area + thin, (of.xx + of.zz) / of.area, of.xx / of.area + thin);
}

namespace {

/// Half the sides of a rectangle about its centre of mass and along its axes, wherever its corners begin.
std::optional<Corner> half_sides(const Outline& corners) {
    if (corners.size() != 4) return {};
    const Corner half{0.5 * std::abs(corners[0].x - corners[2].x), 0.5 * std::abs(corners[0].z - corners[2].z)};
    const auto fits = [&](const Corner& one) {
        return std::abs(std::abs(one.x) - half.x) < length_rounding &&
               std::abs(std::abs(one.z) - half.z) < length_rounding;
    };
    return std::ranges::all_of(corners, fits) ? std::optional(half) : std::nullopt;
}

}  // namespace

IceShape::IceShape(const Outline& corners, double half_thickness) {
    if (const std::optional<Corner> half = half_sides(corners)) {
        box_.emplace(btVector3(half->x, half_thickness, half->z));
        const btVector3 with_margin = box_->getHalfExtentsWithMargin();
        prism_ = PrismShape(corners_of(with_margin.x(), with_margin.z()), with_margin.y());
    } else {
        hull_.emplace(corners, half_thickness);
        prism_ = PrismShape(corners, half_thickness);
    }
}

}  // namespace floes
