// Keys of the tables [structure], [hull], [path] and [moorings]: the structure, and how it moves.

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "scenario/tables.hpp"

namespace floes {

namespace {

constexpr double largest = 1e4;       // m
constexpr double farthest_way = 1e5;  // m and s

Key kind_key(Shape& shape) {
    WordField words{{hull_kind_words.begin(), hull_kind_words.end()},
                    [&shape] { return static_cast<std::size_t>(shape.kind()); },
                    [&shape](std::size_t word) { shape.set_kind(static_cast<HullKind>(word)); }};
    return late_key({"hull.shape", std::move(words), "Table 2", hull_kind_doc});
}

Key size_key(Shape& shape, const HullSizeKey& of) {
    const auto size = of.size;
    const bool angle = of.path.ends_with("_deg");
    const bool is_flare = size == &HullSizes::flare;
    NumberField field{[&shape, size] { return shape.sizes().*size; },
                      [&shape, size](double value) { shape.set_size(size, value); }, angle ? unit::degree : unit::one,
                      at_least(0).at_most(angle ? 150 : largest)};
    const auto in_force = [&shape, size, is_flare] {
        return is_flare ? is_ship(shape.kind()) : std::ranges::count(needed_sizes(shape.kind()), size) > 0;
    };
    return late_with("a hull.shape that has it (docs/structures.md)",
                     in_force)({of.path, std::move(field), is_flare ? "most ships' sides" : "not given", of.doc});
}

/// Rows in which a shape is written down, by its getter and its setter of them.
RowsField shape_rows(Shape& shape, std::span<const ShapeColumn> given, auto rows_of, auto set_rows) {
    std::vector<Column> columns;
    for (const ShapeColumn& column : given)
        columns.push_back({fmt::format("{}{}{}", column.name, column.unit.empty() ? "" : "_", column.unit), unit::one,
                           at_least(column.low).at_most(column.high)});
    return {std::move(columns), [&shape, rows_of] { return (shape.*rows_of)(); },
            [&shape, set_rows](const std::vector<std::vector<double>>& rows) { (shape.*set_rows)(rows); }};
}

/// The radius of the lowest point as a key of its own, so that a design can have it as an axis.
Key keel_radius(Shape& shape) {
    const auto rows_of = [&shape] {
        std::vector<std::vector<double>> rows = shape.rows();
        if (rows.empty()) rows.push_back({0, 0});
        return rows;
    };
    NumberField radius{[rows_of] { return rows_of().front().back(); },
                       [&shape, rows_of](double value) {
                           std::vector<std::vector<double>> rows = rows_of();
                           rows.front().back() = value;
                           shape.set_profile(rows);
                       },
                       unit::one, at_least(0).at_most(Shape::columns.back().high)};
    return part_key({"structure.keel_radius_m", std::move(radius), "structure.profile_m",
                     "Radius of the lowest point of structure.profile_m, which has to be given too unless it is the "
                     "default. With it a design can have the wall below the waterline as an axis."});
}

void add_file(Keys& keys, Structure& structure) {
    HullFile& file = structure.hull_file;
    keys.push_back(late_key(text_key(
        "hull.file", file.path, "none",
        "Shape file: an STL or OBJ file, relative to the configuration file, of one or more closed surfaces. It is cut "
        "into convex pieces, which are stored as hull.pieces in its place.")));
    const auto of_file = late_with("hull.file", [&file] { return !file.path.empty(); });
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

void add_structure(Keys& keys, Structure& structure) {
    const auto by_profile = [&structure] { return structure.shape.kind() == HullKind::profile; };
    keys.push_back(only_with(
        "hull.shape = \"profile\"", by_profile,
        {"structure.profile_m", shape_rows(structure.shape, Shape::columns, &Shape::rows, &Shape::set_profile),
         "Table 2; the radius at the bottom is fitted (docs/validation.md)",
         "Radius over height above the waterline, from the keel up, with heights that never decrease. The wall angle "
         "decides the load: a steeper wall below the waterline gives higher loads and more broken floes."}));
    keys.push_back(only_with("hull.shape = \"profile\"", by_profile, keel_radius(structure.shape)));
    keys.push_back(
        number_key("structure.start_m", structure.start, unit::one, at_least(-farthest_way).at_most(farthest_way),
                   "the paper, Simulation Design; of another hull derived: its bow is half a floe before the ice",
                   "Initial position of the structure's axis along x."));
    keys.push_back(number_key("structure.speed_m_s", structure.speed, unit::one, above(0).at_most(100), "Table 1",
                              "Speed of the tow along +x, from the first step on."));
}

void add_hull(Keys& keys, Structure& structure) {
    Shape& shape = structure.shape;
    keys.push_back(kind_key(shape));
    for (const HullSizeKey& one : hull_size_keys) keys.push_back(size_key(shape, one));
    add_file(keys, structure);
    const auto of_pieces = late_with("hull.shape = \"file\"", [&shape] { return shape.kind() == HullKind::file; });
    keys.push_back(of_pieces(
        {"hull.pieces", shape_rows(shape, Shape::piece_columns, &Shape::piece_rows, &Shape::set_pieces), "none",
         "Convex pieces, a row for each corner: the number of its piece, the index of its part in hull.parts, and "
         "where it is. The smallest convex body that holds the corners is the piece."}));
    keys.push_back(of_pieces(text_key("hull.parts", shape.part_list(), "none",
                                      "Names of the parts, divided by commas: each has loads of its own.")));
    keys.push_back(
        of_pieces({"hull.faces", shape_rows(shape, Shape::face_columns, &Shape::face_rows, &Shape::set_faces),
                   "none: all faces are of the part of their piece",
                   "Faces of convex pieces that are of another part than their piece; written by hull.file "
                   "where groups of a file are patches of one body."}));
    keys.push_back(of_pieces(number_key("hull.file_volume_m3", structure.hull_file.volume, unit::one,
                                        at_least(0).at_most(1e12), "none",
                                        "Volume within the surface of hull.file, by which the pieces are judged; 0: "
                                        "they came from no file.")));
}

namespace {

RowsField leg_rows(std::vector<PathLeg>& legs) {
    return rows_of<PathLeg>(legs, {{{"heading_deg", unit::degree, at_least(-3600).at_most(3600)}, &PathLeg::heading},
                                   {{"speed_m_s", unit::one, at_least(0).at_most(100)}, &PathLeg::speed},
                                   {{"time_s", unit::one, above(0).at_most(farthest_way)}, &PathLeg::time},
                                   {{"turn_deg_s", unit::degree, at_least(-90).at_most(90)}, &PathLeg::turn}});
}

RowsField place_rows(std::vector<PathPoint>& places) {
    const Range place = at_least(-farthest_way).at_most(farthest_way);
    return rows_of<PathPoint>(places, {{{"time_s", unit::one, at_least(0).at_most(farthest_way)}, &PathPoint::time},
                                       {{"x_m", unit::one, place}, &PathPoint::x},
                                       {{"z_m", unit::one, place}, &PathPoint::z},
                                       {{"yaw_deg", unit::degree, at_least(-3600).at_most(3600)}, &PathPoint::yaw}});
}

RowsField line_rows(std::vector<MooringLine>& lines) {
    const Range arm = at_least(-1000).at_most(1000);
    const Range load = at_least(0).at_most(1e6);
    return rows_of<MooringLine>(lines,
                                {{{"x_m", unit::one, arm}, &MooringLine::x},
                                 {{"z_m", unit::one, arm}, &MooringLine::z},
                                 {{"azimuth_deg", unit::degree, at_least(-360).at_most(360)}, &MooringLine::azimuth},
                                 {{"distance_m", unit::one, above(0).at_most(farthest_way)}, &MooringLine::distance},
                                 {{"pretension_kN", unit::kilonewton, load}, &MooringLine::pretension},
                                 {{"stiffness_kN_m", unit::kilonewton, load}, &MooringLine::stiffness},
                                 {{"break_load_kN", unit::kilonewton, load}, &MooringLine::break_load}});
}

RowsField hanging_rows(std::vector<HangingLine>& lines) {
    const Range way = at_least(-farthest_way).at_most(farthest_way);
    const Range length = above(0).at_most(farthest_way);
    const auto fairlead = [](int axis) { return [axis](HangingLine& line) -> double& { return line.fairlead[axis]; }; };
    const auto cable = [](double Cable::*number) {
        return [number](HangingLine& line) -> double& { return line.cable.*number; };
    };
    return rows_of<HangingLine>(
        lines, {{{"x_m", unit::one, way}, fairlead(0)},
                {{"height_m", unit::one, way}, fairlead(1)},
                {{"z_m", unit::one, way}, fairlead(2)},
                {{"azimuth_deg", unit::degree, at_least(-360).at_most(360)}, &HangingLine::azimuth},
                {{"distance_m", unit::one, length}, &HangingLine::distance},
                {{"depth_m", unit::one, length}, &HangingLine::depth},
                {{"length_m", unit::one, length}, cable(&Cable::length)},
                {{"weight_N_m", unit::one, above(0).at_most(1e6)}, cable(&Cable::weight)},
                {{"stiffness_kN", unit::kilonewton, above(0).at_most(1e12)}, cable(&Cable::stiffness)},
                {{"friction", unit::one, at_least(0).at_most(10)}, cable(&Cable::friction)},
                {{"break_load_kN", unit::kilonewton, at_least(0).at_most(1e9)}, &HangingLine::break_load}});
}

/// Of a matrix by directions; how many rows there are is checked with the rest.
RowsField six_rows(std::vector<std::vector<double>>& matrix) {
    std::vector<Column> columns;
    for (const char* name : {"surge", "sway", "heave", "roll", "pitch", "yaw"})
        columns.push_back({name, unit::tonne, {}});
    return {std::move(columns), [&matrix] { return matrix; },
            [&matrix](const std::vector<std::vector<double>>& rows) { matrix = rows; }};
}

RowsField curve_rows(std::vector<TensionPoint>& curve, const std::string& extension, const std::string& tension) {
    return rows_of<TensionPoint>(
        curve, {{{extension, unit::one, at_least(-farthest_way).at_most(farthest_way)}, &TensionPoint::extension},
                {{tension, unit::kilonewton, at_least(0).at_most(1e6)}, &TensionPoint::tension}});
}

/// Lines about which the hull turns, or all of a mooring together, as its designers give them.
void add_turret(Keys& keys, Turret& turret, const auto& held) {
    const auto of_turret = late_with("moorings.turret or turret_curve", [&turret] { return turret.any(); });
    keys.push_back(held(switch_key(
        "moorings.turret", turret.lines, "lines turn with the hull",
        "Whether moorings.lines and hanging_lines hang from a turret, about which the hull turns freely: their "
        "fairleads are from its axis, and it keeps its heading. The ice then turns the hull until it lies with the "
        "load.")));
    keys.push_back(held(
        {"moorings.turret_curve", curve_rows(turret.curve, "offset_m", "force_kN"), "none",
         "Force of a whole mooring over the horizontal offset from its place, from 0, 0, both rising: it pulls the "
         "turret back towards there, the same from all sides. In addition to springs and lines. Past its last row a "
         "member is set aside."}));
    keys.push_back(
        held(of_turret(number_key("moorings.turret_m", turret.ahead, unit::one, at_least(-1000).at_most(1000),
                                  "none: on the axis", "Axis of the turret from the structure's, ahead."))));
    keys.push_back(held(of_turret(number_key(
        "moorings.turret_friction_kN_m", turret.friction, unit::kilonewton, at_least(0).at_most(1e9),
        "none: its bearing turns freely",
        "Moment by which the turret's bearing resists the hull's turning, kN m, whatever the load; within it the hull "
        "keeps its heading."))));
}

/// Dynamic positioning.
void add_thrusters(Keys& keys, Thrusters& thrusters, const auto& held) {
    const auto number = [&](std::string_view path, double& field, std::string_view default_words,
                            std::string_view doc) {
        keys.push_back(held(number_key(path, field, unit::kilonewton, at_least(0).at_most(1e9), default_words, doc)));
    };
    number("moorings.dp_surge_kN_m", thrusters.gain[0], "none: no thrusters",
           "Dynamic positioning: thrust of the structure's own along its bow for each metre of offset.");
    number("moorings.dp_sway_kN_m", thrusters.gain[1], "none", "The same across.");
    number("moorings.dp_yaw_kN_m_rad", thrusters.gain[2], "none", "The same in yaw, kN m/rad.");
    number("moorings.dp_surge_limit_kN", thrusters.limit[0], "none: it has no end",
           "The most that thrusters give along the bow, ahead and astern.");
    number("moorings.dp_sway_limit_kN", thrusters.limit[1], "none", "The same across.");
    number("moorings.dp_yaw_limit_kN_m", thrusters.limit[2], "none", "The same in yaw, kN m.");
    keys.push_back(held(only_with(
        "moorings.dp_surge_kN_m, dp_sway_kN_m or dp_yaw_kN_m_rad", [&thrusters] { return thrusters.any(); },
        number_key("moorings.dp_damping_percent", thrusters.damping, unit::percent, at_least(0).at_most(1000),
                   "1/√2: the least at which no frequency of the load is amplified",
                   "Thrust against the velocity, of the critical damping by the thrust for each metre and the inertia "
                   "with the water's."))));
}

/// The hull: what moves, and in which motions.
void add_hull_mass(Keys& keys, Moorings& moorings, const auto& held, const auto& number) {
    keys.push_back(late_key(number_key(
        "moorings.mass_t", moorings.mass, unit::tonne, at_least(0).at_most(1e9), "none: it moves as prescribed",
        "Mass of a structure that gives way on its moorings, without the water that moves with it; its centre is on "
        "the axis. The moorings' anchors then move as the structure otherwise would: ice that drifts past them. 0: no "
        "moorings.")));
    keys.push_back(held(
        {"moorings.free",
         WordsField{{motion_names.begin(), motion_names.end()},
                    [&moorings] { return std::vector<bool>(moorings.free.begin(), moorings.free.end()); },
                    [&moorings](const std::vector<bool>& chosen) { std::ranges::copy(chosen, moorings.free.begin()); }},
         "all that springs and lines hold",
         "Motions in which the structure gives way; it is held in the others. Heave, pitch and roll need a hull that "
         "floats upright: the water's stiffness follows from its shape, mass and centre, and at rest it lies level at "
         "its draught."}));
    keys.push_back(held(number_key(
        "moorings.centre_m", moorings.height, unit::one, at_least(-1000).at_most(1000), "none: in the waterline",
        "Height of the centre of mass over the calm water, on the structure's axis; negative below. Motions, moments "
        "and added inertia are about the axis at the height of the calm water.")));
    number("moorings.gyration_m", moorings.gyration, unit::one,
           "Radius of gyration of the mass in yaw: the root of the yaw inertia over the mass.");
    number("moorings.gyration_pitch_m", moorings.pitch_gyration, unit::one, "The same in pitch, about the centre.");
    number("moorings.gyration_roll_m", moorings.roll_gyration, unit::one, "The same in roll, about the centre.");
    const auto added = [&](std::string_view path, Motion motion, std::string_view doc) {
        number(path, moorings.added.at(at(motion)), unit::tonne, doc);
    };
    added("moorings.added_surge_t", Motion::surge, "Water that moves with the structure in surge.");
    added("moorings.added_sway_t", Motion::sway, "Water that moves with the structure in sway.");
    added("moorings.added_yaw_t_m2", Motion::yaw, "Inertia in yaw of the water that moves with the structure.");
    added("moorings.added_heave_t", Motion::heave, "Water that moves with the structure in heave.");
    added("moorings.added_pitch_t_m2", Motion::pitch, "Inertia in pitch of the water that moves with the structure.");
    added("moorings.added_roll_t_m2", Motion::roll, "Inertia in roll of the water that moves with the structure.");
    const auto matrix = [&](std::string_view path, std::vector<std::vector<double>>& rows, std::string_view doc) {
        keys.push_back(held({path, six_rows(rows), "none", doc}));
    };
    matrix(
        "moorings.added_mass", moorings.added_mass,
        "Added mass and inertia in addition to these, six rows of six as radiation programs have them: t, t m, t m²; "
        "surge, sway, heave, roll, pitch, yaw with x ahead, y to port and z up, about the axis at the calm water.");
    matrix("moorings.radiation_damping", moorings.radiation_damping,
           "Damping by the waves that the hull makes, in the same form: t/s, t m/s, t m²/s.");
}

void add_springs(Keys& keys, Moorings& moorings, const auto& held, const auto& number) {
    number("moorings.surge_kN_m", moorings.surge, unit::kilonewton,
           "Stiffness in surge of a linear spring, in addition to moorings.lines.");
    number("moorings.sway_kN_m", moorings.sway, unit::kilonewton, "Stiffness in sway of a linear spring.");
    number("moorings.yaw_kN_m_rad", moorings.yaw, unit::kilonewton, "Stiffness in yaw of a linear spring, kN m/rad.");
    keys.push_back(held(number_key(
        "moorings.damping_percent", moorings.damping, unit::percent, at_least(0).below(100),
        "none: from a decay test or a mooring program",
        "Linear damping by water and lines in each direction, of the critical one by mass and stiffness without an "
        "offset.")));
    const auto quadratic = [&](std::string_view path, Motion motion, std::string_view doc) {
        number(path, moorings.quadratic.at(at(motion)), unit::kilonewton, doc);
    };
    quadratic("moorings.quadratic_surge_kN_s2_m2", Motion::surge,
              "Damping by the water in surge: this times the square of the speed relative to the anchors. The steady "
              "drag of a current is not in it.");
    quadratic("moorings.quadratic_sway_kN_s2_m2", Motion::sway, "The same in sway.");
    quadratic("moorings.quadratic_yaw_kN_m_s2", Motion::yaw,
              "The same in yaw, by the square of the rate of turning, kN m s²/rad².");
    quadratic("moorings.quadratic_heave_kN_s2_m2", Motion::heave, "The same in heave.");
    quadratic("moorings.quadratic_pitch_kN_m_s2", Motion::pitch, "The same in pitch, kN m s²/rad².");
    quadratic("moorings.quadratic_roll_kN_m_s2", Motion::roll, "The same in roll, kN m s²/rad².");
}

void add_lines(Keys& keys, Moorings& moorings, const auto& held) {
    keys.push_back(
        held({"moorings.lines", line_rows(moorings.lines), "none",
              "Mooring lines: fairlead from the structure's axis (x ahead, z), azimuth towards which the line leads (0 "
              "along +x, 90 towards +z), horizontal distance from fairlead to anchor, and horizontally pretension, "
              "stiffness and break load (0: none). A line above its break load is gone from then on."}));
    keys.push_back(held(
        {"moorings.hanging_lines", hanging_rows(moorings.hanging), "none",
         "Lines with a weight: fairlead in the structure's axes (x ahead, height over the calm water, z), azimuth, "
         "horizontal distance to the anchor, depth of the anchor below the calm water, unstretched length, weight "
         "in water, stiffness EA, friction of the bottom and break load at the fairlead (0: none). They hang as "
         "catenaries that may lie on the bottom, and move with the hull."}));
    keys.push_back(
        held({"moorings.line_curve", curve_rows(moorings.curve, "extension_m", "tension_kN"), "none: lines are linear",
              "Tension of each line over its horizontal distance, both rising: a catenary, for example. The pretension "
              "says where on it a line begins; stiffness in moorings.lines has to be 0 then. Past its rows a member is "
              "set aside, unless the line breaks before."}));
}

}  // namespace

void add_path(Keys& keys, Path& path) {
    const auto of_legs = late_with("path.legs", [&path] { return !path.legs.empty(); });
    keys.push_back(late_key({"path.legs", leg_rows(path.legs), "none: straight on along +x at structure.speed_m_s",
                             "Legs that follow one another: heading at the beginning (0 along +x, 90 towards +z), "
                             "speed (0: it stops), time, and by how much the heading turns in a second: 0 for a "
                             "straight leg, else an arc of the radius speed / turn. "
                             "From leg to leg the heading turns by the shorter way: from 350 to 10 by 20. "
                             "After the last leg the structure stands."}));
    keys.push_back(of_legs(word_key("path.of", path.of, {"structure", "ice"}, "the structure moves in the simulation",
                                    "Whose legs these are. ice: headings and speeds are of ice that drifts past a "
                                    "structure that stands; it then moves the other way through ice at rest.")));
    keys.push_back(of_legs(word_key("path.bow", path.bow, {"ahead", "unturned"}, "a hull that is moored stays",
                                    "ahead: the structure turns with its heading, as a ship does; unturned: its bow "
                                    "stays towards +x.")));
    keys.push_back(of_legs(
        number_key("path.ramp_s", path.ramp, unit::one, at_least(0).at_most(farthest_way), "none: at once, as the tow",
                   "Time at the beginning of each leg in which speed and heading change evenly from those of the leg "
                   "before; the first begins from rest. At most the shortest leg.")));
    keys.push_back(
        late_key({"path.places", place_rows(path.table), "none",
                  "In place of legs: times, places from the start (x and z), and yaw (positive turns +z "
                  "towards +x). Between two "
                  "rows speed and turning are constant, and yaw turns by the shorter way: from 359 to 1 by 2. "
                  "After the last row the structure stands."}));
}

void add_moorings(Keys& keys, Moorings& moorings) {
    const auto held = late_with("moorings.mass_t > 0", [&moorings] { return moorings.give_way(); });
    const auto number = [&](std::string_view path, double& field, double unit, std::string_view doc) {
        keys.push_back(held(number_key(path, field, unit, at_least(0).at_most(1e12), "none", doc)));
    };
    add_hull_mass(keys, moorings, held, number);
    add_springs(keys, moorings, held, number);
    add_lines(keys, moorings, held);
    add_turret(keys, moorings.turret, held);
    add_thrusters(keys, moorings.thrusters, held);
}

}  // namespace floes
