#pragma once
// An elastic joint: six springs in the joint's frame.

#include <array>

namespace floes {

/// Order of the parts as in SolverReaction. What two bodies that swing against each other lose is the same for each
/// part: a share of critical damping.
struct JointSpring {
    std::array<double, 3> force{};   ///< N/m: axial, shear up, shear in the plane
    std::array<double, 3> moment{};  ///< N m: torsion, in-plane bending, bending
    double damping_ratio = 0;        ///< of critical, >= 0

    friend bool operator==(const JointSpring&, const JointSpring&) = default;
};

}  // namespace floes
