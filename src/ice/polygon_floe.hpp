#pragma once
// Floes that are convex polygons: their elements, joints and springs.

#include <memory>

#include "ice/beam_joint.hpp"
#include "outline/elements.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// The elements and joints of a polygon; null for a rectangle, which FloeGrid describes.
std::shared_ptr<const CutFloe> cut_of(const FloeShape& shape);

/// A beam joint as wide as the edge that two elements share, from one centre to the other.
JointSpring polygon_joint(const CutJoint& joint, const FloeShape& shape, const Material& material);

/// Rotation about y whose x axis is the unit vector (x, z).
Quat turned_to(const Corner& axis);

}  // namespace floes
