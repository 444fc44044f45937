#pragma once
// The paper's ice as the proofs of fracture have it, and the stiffness of beams between its elements.

#include <Eigen/SparseCore>
#include <vector>

#include "theory/plate.hpp"

namespace floes::test {

constexpr double modulus = 60e6;     // Pa
constexpr double thickness = 0.033;  // m
constexpr double poisson = 0.3;
constexpr double strength = 36.4e3;   // Pa
constexpr double crushing = 145.6e3;  // Pa
const FloatingPlate plate{.thickness = thickness};

/// The share that a motion of an element, by number, has in a stretch.
struct StretchPart {
    int motion;
    double share;
};

/// A spring that resists the sum of the parts.
inline void add_spring(std::vector<Eigen::Triplet<double>>& entries, double stiffness,
                       const std::vector<StretchPart>& parts) {
    for (const StretchPart& one : parts)
        for (const StretchPart& other : parts)
            entries.emplace_back(one.motion, other.motion, stiffness * one.share * other.share);
}

}  // namespace floes::test
