#pragma once
// Floes side by side, which may differ: shapes and materials stand in tables, and each floe says which are its own.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/vector.hpp"
#include "scenario/scenario.hpp"
#include "shapes/elements.hpp"

namespace floes {

struct Floe {
    PlanarPose pose;           ///< of its centre
    std::size_t shape = 0;     ///< index in FloeSet::shapes
    std::size_t material = 0;  ///< index in FloeSet::materials
};

struct FloeSet {
    std::vector<FloeShape> shapes;
    std::vector<Material> materials;
    std::vector<Floe> floes;

    std::size_t size() const { return floes.size(); }
    const FloeShape& shape(std::size_t floe) const { return shapes[floes[floe].shape]; }
    const Material& material(std::size_t floe) const { return materials[floes[floe].material]; }
    /// But for the pattern of their elements.
    bool alike() const;

    std::vector<PlanarPose> poses() const;
};

/// A floe by itself, without tables.
struct SingleFloe {
    PlanarPose pose;
    FloeShape shape;
    Material material;
};

/// A part of a field without end: the floes whose middles lie behind its end, and ahead of that of the part before. Of
/// level ice the floes are its elements, each of one cell, without yaw; joints hold them together.
struct FieldPart {
    std::vector<SingleFloe> floes;
    double end = 0;  ///< x, m
    /// From a floe of this part to one of it or of an earlier part, a > b: numbers of floes from 0 in the order in
    /// which they are laid. Pivots are places in the field, m.
    std::vector<CutJoint> joints{};
};

/// In a field without end, what is laid already ends at `end`, x in m, and next() lays one part more.
struct IceAhead {
    double end = 0;
    std::function<FieldPart()> next;
    std::vector<CutJoint> joints{};  ///< of what is laid already
};

/// The set of these floes, in their order; equal shapes and equal materials stand in the tables once.
FloeSet gathered(std::span<const SingleFloe> floes);

/// A floe of the scenario's own shape and material at each pose, cut into squares.
FloeSet floes_at(const Scenario& scenario, std::span<const PlanarPose> poses);

/// Which of a campaign's arrangements: what laws draw floes by.
struct Draw {
    std::uint64_t seed = 0;    ///< of the campaign
    std::uint32_t number = 0;  ///< of the arrangement
    std::uint64_t part = 0;    ///< of a field without end, laid part after part; 0: all of any other
};

/// The floes of a scenario, which an arrangement will give their places; given poses are kept. Throws InputError with
/// the column or the floe at fault if the values of single floes are not those of arrangement.columns.
FloeSet floes_of(const Scenario& scenario, const Draw& draw = {});

/// Whether floes of the scenario can differ from each other or from [floe] and [ice].
bool floes_may_differ(const Scenario& scenario);

/// Whether their sizes can.
bool sizes_may_differ(const Scenario& scenario);

/// The sheet of a scenario with level ice; of one without end as much of it as is computed at a time.
FloeShape sheet_shape(const Scenario& scenario);

/// Floes of a scenario that are computed at a time: all of them, or about those in the window of a field without end.
double computed_floes(const Scenario& scenario);

/// Their elements, about.
double computed_elements(const Scenario& scenario);

/// Area of all floes, m².
double covered_area(const FloeSet& floes);

/// Elements of all floes together; a double, since what a user asks for may be more than any integer.
double element_count(const FloeSet& floes);

/// The largest side of any floe, m.
double largest_side(const FloeSet& floes);

// The sizes of a scenario's floes: the same in every arrangement, so that each covers the same area.

/// The shapes of all floes, rounded to whole elements, of the scenario's thickness: `floe` for each unless sizes
/// differ. Floe i of n has the size that a share (i + ½)/n of the law is below, or the list's shares in whole floes,
/// or an outline of shapes.file (traced_shapes()).
std::vector<FloeShape> floe_sizes(const Scenario& scenario);

/// Side of the elements, m, of a floe whose shorter side is `breadth` before it is rounded.
double element_side(const Scenario& scenario, double breadth);

/// How far from the structure's axis the edges of a field without end's window (field.ahead_m, field.behind_m) are at
/// least, m: its radius and the diagonal of the largest floe, so that it touches nothing beyond them.
double window_least(const Scenario& scenario);

/// How many floes each entry of sizes.list is of: the nearest whole numbers whose sum is field.floes.
std::vector<int> listed_counts(const Scenario& scenario);

// The ice of single floes, drawn.

/// Gives each floe the ice that the laws of [spread] draw for it, and what [brine] says. A draw depends on the
/// campaign's seed, the arrangement's number, spread.draw, the property and the floe's number only.
void draw_ice(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes);

/// Multiplies all strengths.
void scale_strengths(Ice& ice, double factor);

/// The least or the largest factor that a property can have, 1 where it has no law.
double least_factor(const Spread& spread);
double largest_factor(const Spread& spread);

// Floes that are polygons, drawn.

/// Gives each floe the outline that [shapes] draws for it, and cells of a Voronoi diagram their places. Outlines depend
/// on the campaign's seed, the arrangement's number, the part and what [shapes], [sizes], [floe] and [field] say. Cells
/// of a field without end, which knows no part alone, stay rectangles (arrangement/endless_field.hpp). Throws
/// InputError if cells are too small, or lie nearer than the clearance.
void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes);

/// Whether a convex outline is a sheet of such ice that can be cut into elements.
bool is_floe(Corners outline, double thickness);

/// Gives the floe an outline, and the place where that lies.
void lie_as(SingleFloe& floe, Corners outline);

/// Throws InputError where cells whose edges moved inwards by `offset` (m) lie nearer than the clearance.
void check_gap(const Scenario& scenario, double offset);

/// Shapes of all floes of shapes.kind = "file": floe i of n has the outline that a share (i + ½)/n of all outlines, by
/// area, is below. So all arrangements have the same floes.
std::vector<FloeShape> traced_shapes(const Scenario& scenario);

/// One floe for each outline, where it was traced, from the near edge of the field on and about its middle line.
std::vector<SingleFloe> floes_as_traced(const Scenario& scenario);

/// Area that each outline gained in becoming convex, over its own in the file; empty if it came from none.
std::vector<double> traced_added(const TracedOutlines& traced);

/// 'outline 3 "A"', as messages name one of the outlines of a file; counted from 1.
std::string outline_name(const TracedOutlines& traced, std::size_t number);

}  // namespace floes
