#include "ice/prism_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ice/felt_patch.hpp"
#include "theory/westergaard.hpp"

namespace floes {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Where the edge along which the ice is stressed ends, and how much of the logarithm goes on from there.
struct End {
    double at = nowhere;  ///< m from the contact, along the edge
    double goes_on = 0;
};

/// The nearest free edge to a contact.
struct FreeEdge {
    double distance = nowhere;
    Corner along{};
    std::array<End, 2> ends{};  ///< one way and the other

    /// Decades of the stress along it, from one radius to a larger one.
    double decades_between(double from, double to) const {
        const auto until = [&](const End& end) {
            const double beyond = end.goes_on > 0 ? end.goes_on * decades(std::max(from, end.at), to) : 0.0;
            return decades(from, std::min(to, end.at)) + beyond;
        };
        return std::min(until(ends[0]), until(ends[1]));
    }
};

/// What lies along the edge `own` from the contact, `way` 1 or -1: nothing where a joint holds the ice there.
End end_along(const PressedPrism& prism, unsigned joined, std::size_t own, const Corner& at, const Corner& way) {
    End end;
    for (std::size_t k = 0; k < prism.corners.size(); ++k) {
        const Corner normal = outward(prism.corners, k);
        const double towards = dot(normal, way);
        if (k == own || !(towards > 1e-9)) continue;
        const double there = std::max(0.0, dot(normal, prism.corners[k] - at)) / towards;
        if (!(there < end.at)) continue;
        const bool free = (joined >> k & 1U) == 0;
        end = {there, free ? std::sqrt(std::max(0.0, dot(normal, outward(prism.corners, own)))) : 1.0};
    }
    return end.goes_on < 1 ? end : End{};
}

FreeEdge nearest_free_edge(const PressedPrism& prism, const Corner& at) {
    unsigned joined = 0;
    for (const PrismJoint& joint : prism.joints) joined |= joint.live ? joint.edge : 0U;
    FreeEdge nearest;
    std::size_t own = 0;
    for (std::size_t k = 0; k < prism.corners.size(); ++k) {
        if ((joined >> k & 1U) != 0) continue;
        const Corner normal = outward(prism.corners, k);
        const double distance = std::max(0.0, dot(normal, prism.corners[k] - at));
        if (!(distance < nearest.distance)) continue;
        nearest = {distance, {-normal.z, normal.x}};
        own = k;
    }
    if (nearest.distance == nowhere) return nearest;
    for (const int way : {0, 1})
        nearest.ends[static_cast<std::size_t>(way)] =
            end_along(prism, joined, own, at, (way == 0 ? 1.0 : -1.0) * nearest.along);
    return nearest;
}

/// The live joint along each axis that is nearest to a contact, in spans, and how far it is, m.
struct Nearest {
    std::size_t joint = PrismStress::none;
    double distance = 0;
};
std::array<Nearest, 2> nearest_joints(const PressedPrism& prism, const Corner& at) {
    std::array<Nearest, 2> found;
    for (std::size_t k = 0; k < prism.joints.size(); ++k) {
        const PrismJoint& joint = prism.joints[k];
        if (!joint.live) continue;
        const Corner from = at - joint.pivot;
        const double beside = std::max(0.0, std::abs(cross(joint.outward, from)) - joint.length / 2);
        const double distance = std::hypot(dot(joint.outward, from), beside);
        Nearest& best = found[joint.axis()];
        if (best.joint == PrismStress::none || distance * prism.joints[best.joint].span < best.distance * joint.span)
            best = {k, distance};
    }
    return found;
}

}  // namespace

PrismStress contact_stress(const PressedPrism& prism, const Press& press) {
    const Corner at{press.x, press.z};
    const double crushed = std::sqrt(std::abs(press.down) / (std::numbers::pi * prism.crushing_pressure));
    const double contact = felt_radius(crushed, prism.thickness);
    const double edge = edge_stress_per_decade(press.down, prism.thickness, prism.poisson_ratio);
    const double interior = interior_stress_per_decade(press.down, prism.thickness, prism.poisson_ratio);
    const FreeEdge rim = nearest_free_edge(prism, at);
    const std::array<Nearest, 2> nearest = nearest_joints(prism, at);
    // An oblique edge meets the joints along both axes, so they are as much closer along it.
    const double crossings = std::abs(rim.along.x) + std::abs(rim.along.z);
    PrismStress found;
    std::array<double, 2> along_rim{};  // decades
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (nearest[axis].joint == PrismStress::none) continue;
        const PrismJoint& joint = prism.joints[nearest[axis].joint];
        const double size = size_of_grid(joint.length, joint.span);
        const double towards = std::max(0.0, joint.span / 2 - nearest[axis].distance);
        const double inside = std::min(felt_inside.radius(size, towards, joint.span), rim.distance);
        const double at_edge = felt_at_edge.radius(size, towards, joint.span) / crossings;
        along_rim[axis] = rim.decades_between(std::max(contact, rim.distance), at_edge);
        const double share = axis == 0 ? rim.along.x * rim.along.x : rim.along.z * rim.along.z;
        found.stress[axis] = interior * decades(contact, inside) + edge * share * along_rim[axis];
        found.joint[axis] = nearest[axis].joint;
    }
    found.shear = edge * rim.along.x * rim.along.z * std::sqrt(along_rim[0] * along_rim[1]);
    return found;
}

double most_contact_stress(const PressedPrism& prism) {
    double largest = 0;
    for (const PrismJoint& joint : prism.joints) largest = std::max(largest, size_of_grid(joint.length, joint.span));
    const double per_decade = std::max(edge_stress_per_decade(1, prism.thickness, prism.poisson_ratio),
                                       interior_stress_per_decade(1, prism.thickness, prism.poisson_ratio));
    // A tension s along a rim is s cos² φ along the normal with a shear of s cos φ sin φ, together at most:
    const double with_shear = 0.5 * (1 + std::numbers::sqrt2);
    return with_shear * per_decade * decades(felt_radius(0, prism.thickness), felt_inside.share * largest);
}

}  // namespace floes
