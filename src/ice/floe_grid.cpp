#include "ice/floe_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace floes {

FloeGrid grid_of(const FloeShape& shape) {
    return {shape.elements_long(), shape.elements_broad(), shape.element};
}

Vec3 FloeGrid::centre(int index) const {
    const int i = index % elements_long;
    const int k = index / elements_long;
    return {(i - 0.5 * (elements_long - 1)) * element, 0, (k - 0.5 * (elements_broad - 1)) * element};
}

Vec3 FloeGrid::pivot(const GridJoint& joint) const {
    return 0.5 * (centre(joint.a) + centre(joint.b));
}

std::uint8_t FloeGrid::outline_edges(int index) const {
    const int i = index % elements_long;
    const int k = index / elements_long;
    int edges = 0;
    if (i == elements_long - 1) edges |= edge_plus_x;
    if (i == 0) edges |= edge_minus_x;
    if (k == elements_broad - 1) edges |= edge_plus_z;
    if (k == 0) edges |= edge_minus_z;
    return static_cast<std::uint8_t>(edges);
}

namespace {

/// The square ring around the floe's centre on which a joint lies, in half elements: integers, so that ties are exact.
int ring(const FloeGrid& grid, const GridJoint& joint) {
    const int i = joint.a % grid.elements_long;
    const int k = joint.a / grid.elements_long;
    const int x = 2 * i - (grid.elements_long - 1) + (joint.axis == JointAxis::x ? 1 : 0);
    const int z = 2 * k - (grid.elements_broad - 1) + (joint.axis == JointAxis::z ? 1 : 0);
    return std::max(std::abs(x), std::abs(z));
}

}  // namespace

std::vector<GridJoint> joint_order(const FloeGrid& grid) {
    std::vector<GridJoint> joints;
    for (int k = 0; k < grid.elements_broad; ++k) {
        for (int i = 0; i < grid.elements_long; ++i) {
            const int index = i + k * grid.elements_long;
            if (i + 1 < grid.elements_long) joints.push_back({index, index + 1, JointAxis::x});
            if (k + 1 < grid.elements_broad) joints.push_back({index, index + grid.elements_long, JointAxis::z});
        }
    }
    std::ranges::stable_sort(joints, {}, [&](const GridJoint& joint) { return ring(grid, joint); });
    return joints;
}

Quat joint_frame(JointAxis axis) {
    if (axis == JointAxis::x) return Quat::Identity();
    return Quat(std::numbers::sqrt2 / 2, 0, -std::numbers::sqrt2 / 2, 0);
}

std::shared_ptr<const CutFloe> cut_of(const FloeShape& shape) {
    if (!shape.is_polygon()) return nullptr;
    return std::make_shared<const CutFloe>(cut_into_elements(shape.outline, shape.element));
}

JointSpring polygon_joint(const CutJoint& joint, const FloeShape& shape, const Material& material) {
    return beam_joint(elastic_ice(shape, material), joint.length, joint.span);
}

Quat turned_to(const Corner& axis) {
    // By half the angle φ of (x, z) = (cos φ, -sin φ), from roots only.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + axis.x)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - axis.x)));
    return Quat(cosine, 0, axis.z > 0 ? -sine : sine, 0).normalized();
}

}  // namespace floes
