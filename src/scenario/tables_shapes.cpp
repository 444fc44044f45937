// Keys of the table [shapes]: outlines of the floes.

#include "scenario/keys.hpp"
#include "scenario/tables.hpp"

namespace floes {
namespace {

constexpr double farthest = 1e5;  // m

RowsField outline_rows(TracedOutlines& traced) {
    const Range place = at_least(-farthest).at_most(farthest);
    return {
        {{"floe", unit::one, at_least(0).at_most(most_floes)}, {"x_m", unit::one, place}, {"z_m", unit::one, place}},
        [&traced] {
            std::vector<std::vector<double>> rows;
            for (std::size_t i = 0; i < traced.outlines.size(); ++i)
                for (const Corner& corner : traced.outlines[i])
                    rows.push_back({static_cast<double>(i), corner.x, corner.z});
            return rows;
        },
        [&traced](const std::vector<std::vector<double>>& rows) {
            traced.outlines.clear();
            for (std::size_t k = 0; k < rows.size(); ++k) {
                if (k == 0 || rows[k][0] != rows[k - 1][0]) traced.outlines.emplace_back();
                traced.outlines.back().push_back({rows[k][1], rows[k][2]});
            }
        }};
}

void add_traced(Keys& keys, Shapes& shapes) {
    TracedOutlines& traced = shapes.traced;
    const auto of_file = [&shapes](Key key) {
        return late_key(only_with(
            "shapes.kind = \"file\"", [&shapes] { return shapes.from_file(); }, std::move(key)));
    };
    keys.push_back(of_file(text_key(
        "shapes.file", traced.path, "none",
        "A GeoJSON file of polygons, or a CSV file with the header floe,x,y and a line for each corner; its path is "
        "relative to the configuration file. Coordinates are lengths, not degrees, with y up as on a map. Its outlines "
        "are stored as shapes.outlines in its place.")));
    keys.push_back(late_key(only_with(
        "shapes.file", [&traced] { return !traced.path.empty(); },
        word_key("shapes.unit", traced.unit, {length_unit_words.begin(), length_unit_words.end()}, "SI, as all keys",
                 "Unit of the coordinates in shapes.file, which does not say it."))));
    keys.push_back(of_file(number_key(
        "shapes.scale", traced.scale, unit::one, above(0).at_most(1e4), "floes as they were traced",
        "Lengths of floes over those that were traced: 0.033 puts floes of 30 m into a tank as floes of 1 m. The "
        "thickness does not follow.")));
    keys.push_back(of_file(number_key(
        "shapes.most_added_percent", traced.most_added, unit::percent, at_least(0).at_most(1000), "5 % in each length",
        "Area that a floe may gain in becoming convex: bays that its convex hull closes and holes that are filled, of "
        "its own. More is refused.")));
    keys.push_back(of_file({"shapes.outlines", outline_rows(traced), "none",
                            "The outlines themselves, a row for each corner: the number of its floe, and where it is. "
                            "Convex, with at most 16 corners."}));
    keys.push_back(
        of_file(numbers_key("shapes.traced_areas_m2", traced.areas, unit::one, above(0).at_most(1e10), "none",
                            "Area of each outline in shapes.file, by which the convex ones are judged; "
                            "empty: they came from no file.")));
    keys.push_back(of_file(text_key("shapes.names", traced.names, "none",
                                    "Names of the outlines in shapes.file, divided by commas, for messages.")));
}

}  // namespace

void add_shapes(Keys& keys, Shapes& shapes) {
    const auto of = [&shapes](ShapeKind kind, std::string_view setting, Key key) {
        return late_key(only_with(
            setting, [&shapes, kind] { return shapes.kind == kind; }, std::move(key)));
    };
    keys.push_back(late_key(word_key(
        "shapes.kind", shapes.kind, {"rectangle", "polygon", "voronoi", "file"}, "the paper: squares",
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
    add_traced(keys, shapes);
}

}  // namespace floes
