#pragma once
// Hull, ice, banks and way from above and from abeam, to scale, as parts of figures. For this module only. From above
// +x goes to the right and +z down the page, as on the water.

#include <set>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "tables/figure.hpp"

namespace floes {

/// From where to where a figure sees, m: (x, z) from above, (x, height) from abeam.
using Seen = Eigen::AlignedBox2d;

/// Where the structure's axis is to be during a run, by its tow or its path; a hull on moorings is somewhere round it.
struct Way {
    std::vector<PlanarPose> poses{};  ///< evenly over the run, m and rad
    std::size_t first_measured = 0;
    double length = 0;    ///< m, along it
    double interval = 0;  ///< s, between two poses

    double time(std::size_t pose) const { return interval * static_cast<double>(pose); }
};
Way way_of(const Scenario& scenario);

Vec2 place_of(const PlanarPose& pose);

/// Points of what lies so, (x, z) in its own axes.
Figure::Points from_above(const std::vector<Vec2>& own, const PlanarPose& pose);
Figure::Points floe_from_above(const FloeShape& floe, const PlanarPose& pose);

/// What the hull cuts out of the water, an outline for each piece.
std::vector<Figure::Points> waterlines_at(const Shape& shape, const PlanarPose& pose);

/// Axes of a plan, at most `widest` wide.
Figure plan_figure(const Seen& seen, std::string description, double widest);

/// How much of the ice sheet beside a field is drawn, m.
double drawn_bank(const Scenario& scenario);

void add_banks(Figure& plan, const Scenario& scenario);
void add_floes(Figure& plan, const FloeSet& floes, const std::set<int>& broken = {});
void add_hull(Figure& plan, const Shape& shape, const PlanarPose& pose);

/// The parts of a line that lie within the figure's axes.
void add_clipped(Figure& figure, const Figure::Points& points, const std::string& style);

/// Of a figure with one scale for both axes. `head`: its length, m.
void add_arrow(Figure& figure, const Vec2& from, const Vec2& to, double head, const std::string& style);

/// A bar of about a sixth of the figure's width, with its length in words, at the lower left.
void add_scale_bar(Figure& figure);

/// Its pieces, the axis at 0 and the calm water at height 0.
void add_hull_from_abeam(Figure& figure, const Shape& shape);

/// The hull from abeam, the water and the ice beside it. `names` stands before the unit of the axis.
Figure elevation_of(const Scenario& scenario, const std::string& names, double widest);

}  // namespace floes
