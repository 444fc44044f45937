// Keys of the table [shapes]: outlines of the floes.

#include "scenario/tables.hpp"

namespace floes {

void add_shapes(Keys& keys, Shapes& shapes) {
    const auto of = [&shapes](ShapeKind kind, std::string_view setting, Key key) {
        return late_key(only_with(
            setting, [&shapes, kind] { return shapes.kind == kind; }, std::move(key)));
    };
    keys.push_back(late_key(word_key(
        "shapes.kind", shapes.kind, {"rectangle", "polygon", "voronoi"}, "the paper: squares",
        "Floes seen from above. rectangle: as [floe] and [sizes] say. polygon: convex polygons of the same areas and "
        "proportions, scattered. voronoi: cells of a Voronoi diagram of the whole field, laid where they grew, with "
        "even gaps that leave the concentration; length_m x breadth_m of [floe] is their mean area. "
        "docs/sea_ice.md.")));
    keys.push_back(of(ShapeKind::polygon, "shapes.kind = \"polygon\"",
                      integer_key("shapes.corners", shapes.corners, 3, 12, "the mean of Voronoi cells in a plane",
                                  "Corners of every floe.")));
    keys.push_back(
        of(ShapeKind::polygon, "shapes.kind = \"polygon\"",
           number_key("shapes.irregularity", shapes.irregularity, unit::one, at_least(0).at_most(0.9),
                      "an example: halfway from regular polygons to any",
                      "How far corners lie from even places on an ellipse, as a share of the way to the next; 0: "
                      "regular polygons.")));
    keys.push_back(
        of(ShapeKind::voronoi, "shapes.kind = \"voronoi\"",
           integer_key("shapes.relaxations", shapes.relaxations, 0, 1000, "no cell smaller than an element; sea_ice.md",
                       "Steps of Lloyd's from random points: 0 leaves cells of very unequal areas, many make "
                       "them alike.")));
}

}  // namespace floes
