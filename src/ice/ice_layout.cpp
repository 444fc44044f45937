#include "ice/ice_layout.hpp"

#include <cmath>
#include <memory>

#include "ice/polygon_floe.hpp"

namespace floes {

IceLayout::IceLayout(const FloeSet& floes) : first_joint{0} {
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const FloeShape& shape = floes.shape(i);
        const int first = static_cast<int>(elements.size());
        if (const std::shared_ptr<const CutFloe> cut = cut_of(shape)) {
            add(*cut, static_cast<int>(i), shape.thickness);
            continue;
        }
        const FloeGrid grid = grid_of(shape);
        const Vec3 half_extents = Vec3(shape.element, shape.thickness, shape.element) / 2;
        for (int index = 0; index < grid.elements(); ++index)
            elements.push_back({static_cast<int>(i), half_extents, grid.outline_edges(index)});
        for (const GridJoint& one : joint_order(grid)) {
            const bool along = one.axis == JointAxis::x;
            joints.push_back(
                {first + one.a, first + one.b, along ? edge_plus_x : edge_plus_z, along ? edge_minus_x : edge_minus_z});
        }
        first_joint.push_back(joints.size());
    }
}

void IceLayout::add(const CutFloe& cut, int floe, double thickness) {
    const int first = static_cast<int>(elements.size());
    for (const CutElement& one : cut.elements) {
        Corner half;
        for (const Corner& corner : one.corners)
            half = {std::max(half.x, std::abs(corner.x)), std::max(half.z, std::abs(corner.z))};
        elements.push_back({floe, {half.x, thickness / 2, half.z}, one.rim, one.corners});
    }
    for (const CutJoint& one : cut.joints) joints.push_back({first + one.a, first + one.b, one.edge_a, one.edge_b});
    first_joint.push_back(joints.size());
}

}  // namespace floes
