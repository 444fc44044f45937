#pragma once
// How IceField numbers the elements and joints of floes: floe by floe, within a floe by grid and by joint_order().

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vector.hpp"
#include "ice/floe_grid.hpp"
#include "outline/elements.hpp"
#include "scenario/floes.hpp"

namespace floes {

struct IceLayout {
    struct LaidElement {
        int floe = 0;
        Vec3 half_extents = Vec3::Zero();  ///< m
        std::uint32_t outline = 0;         ///< edge faces on the outline of the floe, bits of Edge; of a polygon bit k
        Outline corners{};                 ///< of an element that is no square, in its own x and z, m
    };
    struct LaidJoint {
        int a = 0;
        int b = 0;
        std::uint32_t edge_a = 0;  ///< the edge of a that it holds, a bit as above
        std::uint32_t edge_b = 0;
    };

    explicit IceLayout(const FloeSet& floes);

    std::vector<LaidElement> elements;
    std::vector<LaidJoint> joints;
    std::vector<std::size_t> first_joint;  ///< of each floe, and the number of all

    int floes() const { return static_cast<int>(first_joint.size()) - 1; }

    /// The floe of the joint with this index.
    std::size_t floe_of_joint(std::size_t index) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(first_joint, index) - first_joint.begin()) - 1;
    }

    /// Index of a floe's joint by its number in joint_order(), as the break log has it.
    std::size_t joint(int floe, int number) const {
        return first_joint[static_cast<std::size_t>(floe)] + static_cast<std::size_t>(number);
    }

  private:
    void add(const CutFloe& cut, int floe, double thickness);
};

}  // namespace floes
