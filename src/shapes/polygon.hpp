#pragma once
// Convex polygons on the water, as plain values. A corner is (x, z); corners follow one another from x to z, so that
// areas are positive (seen from above, where z points down the page, that is clockwise). Edge k runs from corner k to
// the next. Lengths in m.

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/vector.hpp"

namespace floes {

struct Corner {
    double x = 0;
    double z = 0;

    friend Corner operator+(const Corner& a, const Corner& b) { return {a.x + b.x, a.z + b.z}; }
    friend Corner operator-(const Corner& a, const Corner& b) { return {a.x - b.x, a.z - b.z}; }
    friend Corner operator*(double s, const Corner& a) { return {s * a.x, s * a.z}; }
    friend auto operator<=>(const Corner&, const Corner&) = default;
};

inline double dot(const Corner& a, const Corner& b) {
    return a.x * b.x + a.z * b.z;
}
/// Positive where b is turned from a towards z.
inline double cross(const Corner& a, const Corner& b) {
    return a.x * b.z - a.z * b.x;
}

using Outline = std::vector<Corner>;
using Corners = std::span<const Corner>;

/// The corner after corner k, round the polygon.
inline const Corner& after(Corners polygon, std::size_t k) {
    return polygon[k + 1 < polygon.size() ? k + 1 : 0];
}

/// Outward normal of edge k, of length 1; the edge must have a length.
Corner outward(Corners polygon, std::size_t k);

double edge_length(Corners polygon, std::size_t k);

/// Positive where corners go from x to z, m².
double area_of(Corners polygon);

/// Area and its moments about the centroid.
struct Measures {
    double area = 0;  ///< m²
    Corner centroid;
    double xx = 0;  ///< ∫ x² dA, m⁴
    double zz = 0;
    double xz = 0;
};
Measures measures_of(Corners polygon);

/// Unit vector along which ∫ (distance along it)² dA is largest: the long axis; (1, 0) where all are alike.
Corner long_axis(const Measures& of);

/// The points at which normal . p <= bound.
struct HalfPlane {
    Corner normal;  ///< of length 1
    double bound = 0;
};

/// What of a convex polygon lies in the half plane (Sutherland and Hodgman); empty where that has no area.
Outline clipped(Corners polygon, const HalfPlane& within);

/// Refills `kept` with it, which keeps its memory and is no part of the polygon.
void clip_into(Outline& kept, Corners polygon, const HalfPlane& within);

/// The points of a convex polygon at least `offset` from each of its edges; empty where there are none.
Outline eroded(Corners polygon, double offset);

/// With every edge moved outwards by `offset`.
Outline grown(Corners polygon, double offset);

/// Every corner moved, then turned so that the unit vector `axis` becomes the x axis.
Outline in_axes(Corners polygon, const Corner& origin, const Corner& axis);

/// The other way round: from such axes back.
Outline from_axes(Corners polygon, const Corner& origin, const Corner& axis);

/// Without corners nearer than `least` to the one before, and without those that lie on a straight edge.
Outline tidied(Corners polygon, double least);

bool contains(Corners polygon, const Corner& point);

/// How far two convex polygons are apart along the edge normal along which they are farthest apart; negative where they
/// overlap, by the least shift that parts them.
double separation(Corners a, Corners b);

/// Least distance of a point within from the edges, at its largest: half the breadth of the widest circle, to 1e-6 of
/// the polygon's size; exact for corners_of().
double inner_radius(Corners polygon);

/// Largest distance of a corner from the origin.
double reach_of(Corners polygon);

/// The corners of a rectangle about its middle; its edges are those at +x, +z, -x and -z.
Outline corners_of(double half_length, double half_breadth);

/// Half the sides along x and z of corners that are exactly those of corners_of(); nothing of others.
std::optional<Corner> half_sides_of(Corners polygon);
inline bool is_rectangle(Corners polygon) {
    return half_sides_of(polygon).has_value();
}

/// The smallest box along x and z that holds all.
Box2 box_round(Corners points);

/// Extents along x and z.
Corner size_of(Corners polygon);

/// The convex polygon round all points, in order; fewer than three corners where they lie on a line.
Outline convex_hull(Outline points);

/// What is wrong with corners that are to be a convex polygon, as a clause ("it crosses itself between corners 2 and
/// 5"); nothing if they are one, in either direction.
std::optional<std::string> fault_of(Corners polygon);

// How far two convex polygons are apart.

/// Least distance between points of two convex polygons, m; separation() where they overlap.
double distance_between(Corners a, Corners b);

// Outlines as they were traced, which need not be convex.

/// What is wrong with corners that are to enclose one area, as a clause; nothing if they do, in either direction. They
/// may bend inwards, but no edge may meet another one except at the corner between them. Time goes with the square of
/// their number.
std::optional<std::string> ring_fault_of(Corners ring);

/// An outline with at most `most` corners, at least 3, and the same area: the corners that change least of it go one by
/// one, unless it would touch itself without them (Visvalingam and Whyatt, Cartogr. J. 30, 1993, cited from memory),
/// and the rest moves outwards about the centroid. May leave more where none can go.
Outline with_fewer_corners(Corners ring, std::size_t most);

/// Whether it bends inwards nowhere, by more than rounding.
bool is_convex(Corners ring);

/// Convex polygons that make up the outline: ears, joined as long as two make a convex one.
std::vector<Outline> convex_parts(Corners ring);

/// Two convex polygons that do not overlap as one, where that is convex to 1e-6 of their area.
std::optional<Outline> united(Corners a, Corners b);

/// Convex polygons that do not overlap, joined as long as two make a convex one.
std::vector<Outline> joined(std::vector<Outline> parts);

/// How wide the widest convex part of an outline is: its inner_radius().
double inner_radius_of_parts(Corners ring);

/// Least distance between points of two outlines, m; 0 or less where they overlap.
double distance_between_outlines(Corners a, Corners b);

}  // namespace floes
