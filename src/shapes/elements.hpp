#pragma once
// A floe cut into convex elements that joints hold together.
//
// An outline, which may have bays, is cut into the cells of a Voronoi diagram of points that were thrown into it and
// relaxed until no cell has a sharp corner. Such cells have no direction, so neither has the ice (docs/fracture.md). A
// cell in which the outline bends inwards is cut there, along an edge of the bay, until its pieces are convex. What
// keeps little of a cell becomes part of the neighbour with which it shares the longest edge, where the two are convex;
// so no ice is lost. The paper's floes are rectangles cut into squares.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/vector.hpp"
#include "shapes/polygon.hpp"

namespace floes {

struct CutElement {
    Corner centre;    ///< its centroid, in the axes of the floe
    Corner axis;      ///< its own x axis there, of length 1: a principal axis of its area
    Outline corners;  ///< in its own axes, about the centroid
    double area = 0;  ///< m²
    double xx = 0;    ///< ∫ x² dA in its own axes, m⁴; ∫ x z dA is 0
    double zz = 0;
    unsigned rim = 0;  ///< bit k: edge k lies on the outline of the floe
};

/// Two elements with a common edge. Directions and places in the axes of the floe.
struct CutJoint {
    int a = 0;
    int b = 0;
    Corner normal;        ///< of length 1, from a to b
    Corner pivot;         ///< beside the middle of the common edge, halfway between the centres along the normal
    double length = 0;    ///< of the common edge, m
    double span = 0;      ///< between the centres, along the normal, m
    unsigned edge_a = 0;  ///< bit of the edge of a on which it lies
    unsigned edge_b = 0;
};

struct CutFloe {
    std::vector<CutElement> elements;
    std::vector<CutJoint> joints;  ///< in the order in which they are made, numbered in the break log and swept
    bool squares = false;          ///< all elements are squares of one size along the axes of the floe
};

/// Bits of a square's edges: edge k is bit k, as of any element.
enum Edge : std::uint8_t { edge_plus_x = 1, edge_plus_z = 2, edge_minus_x = 4, edge_minus_z = 8, every_edge = 15 };

/// Squares of this side, m: the one with index i + k * along is the i-th along x and the k-th along z.
///
/// Joints whose Σ is nearly 0 are as stiff as 50 sweeps in their order make them (docs/fracture.md), so the order is
/// part of the model. Chosen: square rings around the floe's centre, inner before outer, within a ring by element, x
/// before z. Σ = 1e-10 on the 5.4 m sheet of Fig. 2 then shows 207 MPa by the point-load formula (the paper: about 200;
/// Bullet's own order 206, row by row 125, all x joints before all z joints 235).
CutFloe cut_into_squares(int along, int across, double side);

/// More corners than this no element may have.
inline constexpr std::size_t most_corners = 24;

/// More corners than this no convex outline may have: cells that clip it, and join, add up to eight.
inline constexpr std::size_t most_outline_corners = most_corners - 8;

/// Nor one with bays, of which an element has a part only.
inline constexpr std::size_t most_bayed_corners = 2 * most_outline_corners;

/// Cells keep at least this share of their area, or are merged.
inline constexpr double least_element_share = 0.3;

/// The elements of an outline about its centroid: as many cells as its area over that of a square of `side`, m,
/// rounded. `pattern`: which draw of the points from which they come.
CutFloe cut_into_cells(Corners outline, double side, std::uint32_t pattern = 0);

/// Where elements of this side share an edge that is not longer, there is no joint, m.
double least_joint(double side);

/// The joint from a to b of elements of this side, m, whose convex outlines share an edge; none where that is too short
/// to carry one. Outlines and centroids in common axes; it has no numbers of elements yet.
std::optional<CutJoint> joint_between(Corners a, const Corner& centre_a, Corners b, const Corner& centre_b,
                                      double side);

/// How many elements that makes.
int count_cells(Corners outline, double side);

/// Rotation about y whose x axis is the unit vector (x, z).
Quat turned_to(const Corner& axis);

}  // namespace floes
