#include "ice/ice_layout.hpp"

namespace floes {

IceLayout::IceLayout(const FloeSet& floes) : first_joint{0} {
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const FloeShape& shape = floes.shape(i);
        const FloeGrid grid = grid_of(shape);
        const int first = static_cast<int>(elements.size());
        const Vec3 half_extents = Vec3(shape.element, shape.thickness, shape.element) / 2;
        for (int index = 0; index < grid.elements(); ++index)
            elements.push_back({static_cast<int>(i), half_extents, grid.outline_edges(index)});
        for (const GridJoint& one : joint_order(grid)) joints.push_back({first + one.a, first + one.b, one.axis});
        first_joint.push_back(joints.size());
    }
}

}  // namespace floes
