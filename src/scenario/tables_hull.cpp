// Keys of the table [hull]: shapes of the structure other than a profile.

#include <algorithm>
#include <span>

#include "scenario/tables.hpp"

namespace floes {
namespace {

constexpr double largest = 1e4;  // m

Key kind_key(Shape& shape) {
    WordField words{
        {"profile", "cylinder", "cone_up", "cone_down", "four_legs", "wedge_bow", "drillship", "barge", "file"},
        [&shape] { return static_cast<std::size_t>(shape.kind()); },
        [&shape](std::size_t word) { shape.set_kind(static_cast<HullKind>(word)); }};
    return late_key(
        {"hull.shape", std::move(words), "Table 2",
         "profile: a body of revolution by structure.profile_m; cylinder: vertical; cone_up narrows upwards and breaks "
         "ice upwards; cone_down flares upwards and breaks it downwards; four_legs: vertical, in a square; wedge_bow: "
         "a "
         "ship with a wedge as bow and a flat stern; drillship: a wedge at either end; barge: ends that slope; file: "
         "convex pieces of hull.file or hull.pieces. docs/hulls.md has their drawings."});
}

struct SizeWords {
    std::string_view path;
    double HullSizes::*size;
    std::string_view doc;
};

Key size_key(Shape& shape, const SizeWords& words) {
    const bool angle = words.path.ends_with("_deg");
    const std::string_view name = words.path.substr(words.path.find('.') + 1);
    const bool is_flare = name == "flare_deg";
    NumberField field{[&shape, size = words.size] { return shape.sizes().*size; },
                      [&shape, size = words.size](double value) { shape.set_size(size, value); },
                      angle ? unit::degree : unit::one,
                      angle ? at_least(0).at_most(150) : at_least(0).at_most(largest)};
    const auto in_force = [&shape, name, is_flare] {
        const HullKind kind = shape.kind();
        if (is_flare) return kind == HullKind::wedge_bow || kind == HullKind::drillship || kind == HullKind::barge;
        return std::ranges::count(needed_sizes(kind), name) > 0;
    };
    return late_key(only_with("a hull.shape that has it (docs/hulls.md)", in_force,
                              {words.path, std::move(field), is_flare ? "most ships' sides" : "not given", words.doc}));
}

std::vector<Column> columns_of(std::span<const ShapeColumn> given) {
    std::vector<Column> columns;
    for (const ShapeColumn& column : given)
        columns.push_back({std::string(column.name) + std::string(column.unit), unit::one,
                           at_least(column.low).at_most(column.high)});
    return columns;
}

RowsField piece_rows(Shape& shape) {
    return {columns_of(Shape::piece_columns), [&shape] { return shape.piece_rows(); },
            [&shape](const std::vector<std::vector<double>>& rows) { shape.set_pieces(rows); }};
}

RowsField face_rows(Shape& shape) {
    return {columns_of(Shape::face_columns), [&shape] { return shape.face_rows(); },
            [&shape](const std::vector<std::vector<double>>& rows) { shape.set_faces(rows); }};
}

void add_file(Keys& keys, Structure& structure) {
    HullFile& file = structure.hull_file;
    keys.push_back(late_key(text_key(
        "hull.file", file.path, "none",
        "Shape file: an STL or OBJ file, relative to the configuration file, of one or more closed surfaces. It is cut "
        "into convex pieces, which are stored as hull.pieces in its place.")));
    const auto of_file = [&](Key key) {
        return late_key(only_with(
            "hull.file", [&file] { return !file.path.empty(); }, std::move(key)));
    };
    keys.push_back(of_file(word_key("hull.unit", file.unit, {length_unit_words.begin(), length_unit_words.end()},
                                    "SI, as all keys", "Unit of lengths in hull.file; neither STL nor OBJ says it.")));
    const std::vector<std::string_view> axes{"+x", "-x", "+y", "-y", "+z", "-z"};
    keys.push_back(
        of_file(word_key("hull.up", file.up, axes, "usual in naval CAD", "Axis of hull.file that points up.")));
    keys.push_back(of_file(word_key("hull.forward", file.forward, axes, "usual in naval CAD",
                                    "Axis of hull.file that points along the tow.")));
    keys.push_back(
        of_file(number_key("hull.waterline_m", file.waterline, unit::one, at_least(-largest).at_most(largest),
                           "the file's zero", "Height of the waterline in hull.file along hull.up.")));
    keys.push_back(late_key(only_with(
        "hull.shape = \"file\"", [&structure] { return structure.shape.kind() == HullKind::file; },
        number_key("hull.most_added_percent", file.most_added, unit::percent, at_least(0).at_most(1000),
                   "1.6 % in each length",
                   "Volume that the convex pieces may add to the hull in the file, of its own. More is refused."))));
}

}  // namespace

void add_hull(Keys& keys, Structure& structure) {
    Shape& shape = structure.shape;
    keys.push_back(kind_key(shape));
    const SizeWords words[]{
        {"hull.length_m", &HullSizes::length, "Length of the waterline, of ships and barges."},
        {"hull.beam_m", &HullSizes::beam, "Breadth of the waterline, of ships and barges."},
        {"hull.diameter_m", &HullSizes::diameter,
         "Diameter of the circle that a cylinder, a cone or each leg cuts out of the water."},
        {"hull.spacing_m", &HullSizes::spacing, "Distance between the axes of neighbouring legs."},
        {"hull.draught_m", &HullSizes::draught, "From the waterline down to the keel."},
        {"hull.freeboard_m", &HullSizes::freeboard,
         "From the waterline up to the deck: the hull ends there, so it has to be above ice that piles up."},
        {"hull.wall_deg", &HullSizes::wall, "Angle of a cone's wall from the horizontal, below 90."},
        {"hull.stem_deg", &HullSizes::stem,
         "Angle from the horizontal of a ship's stem, or of both ends of a barge; below 90 they overhang and break ice "
         "downwards."},
        {"hull.flare_deg", &HullSizes::flare,
         "Angle of the sides of ships and barges from the horizontal; 90: vertical, below 90 they flare upwards."},
        {"hull.entrance_deg", &HullSizes::entrance,
         "Angle of the bow's waterline from the centre line, half of what it encloses."}};
    for (const SizeWords& one : words) keys.push_back(size_key(shape, one));
    add_file(keys, structure);
    const auto of_pieces = [&](Key key) {
        return late_key(only_with(
            "hull.shape = \"file\"", [&shape] { return shape.kind() == HullKind::file; }, std::move(key)));
    };
    keys.push_back(of_pieces(
        {"hull.pieces", piece_rows(shape), "none",
         "Convex pieces, a row for each corner: the number of its piece, the index of its part in hull.parts, and "
         "where it is. The smallest convex body that holds the corners is the piece."}));
    keys.push_back(of_pieces(text_key("hull.parts", shape.part_list(), "none",
                                      "Names of the parts, divided by commas: each has loads of its own.")));
    keys.push_back(of_pieces({"hull.faces", face_rows(shape), "none: all faces are of the part of their piece",
                              "Faces of convex pieces that are of another part than their piece; written by hull.file "
                              "where groups of a file are patches of one body."}));
    keys.push_back(of_pieces(number_key("hull.file_volume_m3", structure.hull_file.volume, unit::one,
                                        at_least(0).at_most(1e12), "none",
                                        "Volume within the surface of hull.file, by which the pieces are judged; 0: "
                                        "they came from no file.")));
}

}  // namespace floes
