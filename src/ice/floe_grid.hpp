#pragma once
// A floe as a grid of square elements with a joint in the middle of every common edge.
// Element (i, k), i along the floe's x and k along its z, has index i + k * elements_long within its floe.

#include <cstdint>
#include <memory>
#include <vector>

#include "core/vector.hpp"
#include "ice/joint_stress.hpp"
#include "scenario/scenario.hpp"
#include "shapes/elements.hpp"

namespace floes {

/// Edge faces of an element, along its own axes; bits of ElementState::exposed_edges.
enum Edge : std::uint8_t { edge_plus_x = 1, edge_minus_x = 2, edge_plus_z = 4, edge_minus_z = 8, every_edge = 15 };

/// The axis of the floe along which a joint connects two elements.
enum class JointAxis : std::uint8_t { x, z };

/// A joint between two elements of a floe: b is a's neighbour in the direction +axis.
struct GridJoint {
    int a = 0;
    int b = 0;
    JointAxis axis = JointAxis::x;
    friend bool operator==(const GridJoint&, const GridJoint&) = default;
};

struct FloeGrid {
    int elements_long = 1;   ///< along the floe's x
    int elements_broad = 1;  ///< along the floe's z
    double element = 0;      ///< L_e, m

    int elements() const { return elements_long * elements_broad; }

    /// Centre of an element from the floe's centre, in the floe's axes, m.
    Vec3 centre(int index) const;

    /// Middle of the common edge face of a joint's elements, as above.
    Vec3 pivot(const GridJoint& joint) const;

    /// The edge faces (bits of Edge) of an element that lie on the outline of the floe.
    std::uint8_t outline_edges(int index) const;
};

/// The elements of a floe of this shape.
FloeGrid grid_of(const FloeShape& shape);

/// All joints of a floe in the order in which they are created, numbered in the break log and swept by the solver.
/// Joints whose Σ is nearly 0 are as stiff as 50 sweeps in this order make them (docs/calibration.md), so the order is
/// part of the model. Chosen: square rings around the floe's centre, inner before outer, within a ring by element, x
/// before z. Σ = 1e-10 on the 5.4 m sheet of Fig. 2 then shows 207 MPa by the point-load formula (the paper: about 200;
/// Bullet's own order 206, row by row 125, all x joints before all z joints 235).
std::vector<GridJoint> joint_order(const FloeGrid& grid);

/// joint -> floe rotation: x from a to b, y up.
Quat joint_frame(JointAxis axis);

// Floes that are convex polygons: their elements, joints and springs.

/// The elements and joints of a polygon; null for a rectangle, which FloeGrid describes.
std::shared_ptr<const CutFloe> cut_of(const FloeShape& shape);

/// A beam joint as wide as the edge that two elements share, from one centre to the other.
JointSpring polygon_joint(const CutJoint& joint, const FloeShape& shape, const Material& material);

/// Rotation about y whose x axis is the unit vector (x, z).
Quat turned_to(const Corner& axis);

}  // namespace floes
