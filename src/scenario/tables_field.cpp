// Keys of the tables [field], [arrangement], [analysis], [shapes], [water] and [wind].

#include <algorithm>

#include "keys/key.hpp"
#include "scenario/keys.hpp"
#include "scenario/tables.hpp"

namespace floes {

namespace {

constexpr double farthest = 1e5;  // m; beyond it a double still holds a micrometre, and no tank is that long

RowsField pose_rows(ArrangementRule& rule) {
    const Range place = at_least(-farthest).at_most(farthest);
    return {
        {{"x_m", unit::one, place}, {"z_m", unit::one, place}, {"yaw_deg", unit::degree, at_least(-360).at_most(360)}},
        [&rule] {
            std::vector<std::vector<double>> rows;
            for (std::size_t floe = 0; floe < rule.poses.size(); ++floe) {
                const PlanarPose& pose = rule.poses[floe];
                rows.push_back({pose.x, pose.z, pose.yaw});
                if (floe < rule.values.size())
                    rows.back().insert(rows.back().end(), rule.values[floe].begin(), rule.values[floe].end());
            }
            return rows;
        },
        [&rule](const std::vector<std::vector<double>>& rows) {
            rule.poses.clear();
            rule.values.clear();
            for (const std::vector<double>& row : rows) {
                rule.poses.push_back({row[0], row[1], row[2]});
                rule.values.emplace_back(row.begin() + 3, row.end());
            }
        },
        true};
}

Key history_steps(Analysis& analysis) {
    constexpr int most = 1'000'000;
    IntegerField steps{[&analysis] { return std::int64_t{analysis.keep_history ? analysis.history_stride : 0}; },
                       [&analysis](std::int64_t value) {
                           analysis.keep_history = value > 0;
                           analysis.history_stride = std::max(1, static_cast<int>(value));
                       },
                       0, most};
    return instead_of({switch_key("analysis.keep_history", analysis.keep_history, "", ""),
                       late_key(integer_key("analysis.history_stride", analysis.history_stride, 1, most, "", ""))},
                      {"analysis.history_steps", std::move(steps), "every step",
                       "Number of successive time steps averaged into one value of the load history that a member "
                       "keeps; it must divide the steps before the window and those in it. 0: no history; a member "
                       "then takes some kB in the campaign file instead of some hundred. Statistics, maxima, counts "
                       "and breaks are kept in any case and use every step."});
}

void add_confinement(Keys& keys, Field& field) {
    constexpr double most = 1e8;  // N/m: floes of metres crush long before
    keys.push_back(late_key(number_key(
        "field.confining_N_m", field.confining, unit::one, at_least(0).at_most(most),
        "none: the paper's sheets are fixed",
        "Ice pressure as a line load. Each ice sheet is then a rigid body that moves along its normal: it presses on "
        "the field with this load times the length (side sheets) or width (far sheet) of the field, and ice that "
        "pushes harder moves it. 0: the sheets are fixed. A few kN/m at full scale; by Froude's law it goes with the "
        "square of the length, so 1/30 of the size has 1/900.")));
    keys.push_back(late_key(only_with(
        "field.confining_N_m > 0", [&field] { return field.confining > 0; },
        number_key("field.closing_speed_m_s", field.closing_speed, unit::one, at_least(0).at_most(farthest),
                   "ice closes as fast as it drifts past; docs/water.md",
                   "Speed at which a sheet closes that meets nothing: its load falls linearly from all of "
                   "field.confining_N_m at rest to nothing at this speed. 0: the speed of the tow."))));
}

/// For a field without end.
void add_window(Keys& keys, Field& field) {
    const auto without_end = late_with("field.far_end = \"never\"", [&field] { return field.endless(); });
    const auto add = [&](const char* path, double& length, const char* source, const char* doc) {
        keys.push_back(without_end(number_key(path, length, unit::one, at_least(0).at_most(farthest), source, doc)));
    };
    add("field.ahead_m", field.ahead,
        "longer changed no load that was seen; of another hull than the paper's derived: it and two breadths or three "
        "floes",
        "How far ahead of the structure's axis floes are computed. Those farther ahead rest, fixed to whatever touches "
        "them, as a field that is held from ahead. 0: two widths of the field; of level ice the structure's radius and "
        "eight characteristic lengths.");
    add("field.behind_m", field.behind,
        "longer changed no load that was seen; of another hull derived: what can touch it, and a floe",
        "How far behind the structure's axis floes are computed. Those farther behind are taken out. 0: one width of "
        "the field; of level ice the structure's radius and four characteristic lengths.");
}

}  // namespace

void add_field(Keys& keys, Field& field) {
    const Range place = at_least(-farthest).at_most(farthest);
    keys.push_back(
        integer_key("field.floes", field.floes, 1, most_floes,
                    "Table 3; of another hull derived: as many as the way of the run needs, or fill what is computed",
                    "Number of floes. Shares of broken floes are of all of them. Of a field without end: of each part "
                    "that is laid; shares are of the floes that were computed."));
    keys.push_back(number_key(
        "field.concentration_percent", field.concentration, unit::percent, above(0).at_most(100), "Table 1",
        "Covered area fraction of the field. Together with the number and size of floes it sets the field's length."));
    keys.push_back(number_key("field.begin_m", field.begin, unit::one, place,
                              "the paper, Simulation Design; of another hull derived: 0, or by structure.start_m",
                              "Position along x where the field begins."));
    keys.push_back(number_key(
        "field.half_width_m", field.half_width, unit::one, above(0).at_most(1e4),
        "the paper, Simulation Design; of another hull derived: it, its path, and a breadth or two floes beside it",
        "Half width of the field: |z| is at most this, between the fixed ice sheets along the walls."));
    keys.push_back(number_key("field.sheet_width_m", field.sheet_width, unit::one, above(0).at_most(1e4),
                              "wider than a floe's diagonal; of another hull derived: that of the largest floe",
                              "Breadth of the fixed ice sheets. If a floe is pushed over a sheet and beyond its outer "
                              "edge, the member ends as failed."));
    keys.push_back(word_key(
        "field.far_end", field.far_end, {"ice_sheet", "open", "never"},
        "design decision; the paper names the walls only",
        "Far end of the field: closed by a fixed ice sheet, open water, or never an end, with ice from ahead as long "
        "as the run lasts. An open far end takes three quarters off the load on a cone of 45° and nearly all of that "
        "on one of 76°, and hardly any floe breaks. never: the ice is laid in parts of field.floes floes, and level "
        "ice goes on row by row; docs/field.md."));
    add_window(keys, field);
    keys.push_back(
        late_key(word_key("field.sides", field.sides, {"ice_sheet", "open", "wall"}, "the paper: walls",
                          "Sides of the field: ice sheets along the walls, open water, into which floes drift, or "
                          "smooth walls of any height, between which lies a slice of wide ice.")));
    keys.push_back(late_key(word_key(
        "field.level_held", field.level_held, {"nowhere", "far_end", "far_end_and_sides"},
        "ice goes on beyond what is computed: docs/field.md",
        "arrangement.method level: edges at which the sheet is frozen to the fixed ice sheets round the field; held at "
        "its sides it is as wide as the field.")));
    keys.push_back(late_key(switch_key(
        "field.level_pushed", field.level_pushed, "a tow through ice at rest",
        "arrangement.method level: the structure stays at structure.start_m, and what holds the sheet pushes it on at "
        "structure.speed_m_s, through water at rest.")));
    add_confinement(keys, field);
    keys.push_back(
        number_key("field.wake_radius_m", field.wake_radius, unit::one, at_least(0).at_most(farthest),
                   "off: every floe is computed",
                   "Not with solver stock: a floe rests, at no cost, until the structure's axis is within this "
                   "distance of its middle or moving ice touches it. This neglects a displacement by the "
                   "flow ahead of the structure of at most waterline radius² / this. 0: off."));
}

void add_arrangement(Keys& keys, ArrangementRule& arrangement) {
    const Key method = word_key(
        "arrangement.method", arrangement.method, {"monte_carlo", "lattice", "file", "scattered", "traced", "level"},
        "floes in a tank are laid at random; docs/field.md",
        "scattered: a disordered field, floes thrown at random and pushed apart until none overlap; "
        "monte_carlo: equilibrium of hard squares, rows and columns where they are dense, independent of the "
        "start; lattice: rows, with jitter; file: given poses, the same for each arrangement; traced: where "
        "shapes.file has them, likewise; level: one sheet of level ice, floe.length_m long from field.begin_m "
        "on and floe.breadth_m wide about the tow's line, up to the field's far end, or as long as the run lasts with "
        "field.far_end = \"never\" (docs/field.md).");
    keys.push_back(
        instead_of({method, word_key("arrangement.start", arrangement.start, {"lattice", "stripes"}, "", "")}, method));
    keys.push_back(number_key("arrangement.clearance_m", arrangement.clearance, unit::one, at_least(0).at_most(10),
                              "a hundredth of an element: none touch at first",
                              "Minimum initial gap between floes, and between floes and walls."));
    keys.push_back(integer_key("arrangement.sweeps", arrangement.sweeps, 0, 10000000,
                               "stripes decay in 9000: docs/field.md",
                               "Monte Carlo sweeps (one trial move per floe) after the step size is frozen; only for "
                               "method monte_carlo."));
    keys.push_back(late_key(integer_key(
        "arrangement.ordering_sweeps", arrangement.ordering_sweeps, 0, 10000000, "none: the field stays disordered",
        "Method scattered: Monte Carlo sweeps after the floes are pushed apart. More of them bring the field from "
        "disorder towards the equilibrium of monte_carlo; the same arrangement with more sweeps is the same chain "
        "later on.")));
    keys.push_back(number_key("arrangement.jitter_m", arrangement.jitter, unit::one, at_least(0).at_most(100), "none",
                              "Method lattice: largest random shift of a floe."));
    keys.push_back(number_key("arrangement.jitter_deg", arrangement.jitter_angle, unit::degree,
                              at_least(0).at_most(180), "none", "Method lattice: largest random turn of a floe."));
    keys.push_back(text_key(
        "arrangement.file", arrangement.file, "none",
        "Method file: a CSV file with the header x_m,z_m,yaw_deg and one line per floe, for example from a tank "
        "photograph. The path is relative to the configuration file. Its lines are stored as arrangement.poses."));
    keys.push_back({"arrangement.poses", pose_rows(arrangement), "none",
                    "Method file: the poses themselves, one per floe; a positive yaw turns +z towards +x. Behind each "
                    "pose stand the floe's own values of arrangement.columns."});
    keys.push_back(late_key(text_key(
        "arrangement.columns", arrangement.columns, "none",
        "Method file: numbers of [floe], [ice] and [joint] that each floe has a value of its own for, such as "
        "\"floe.length_m,floe.breadth_m,ice.thickness_m\". In arrangement.file they stand in the header behind "
        "x_m,z_m,yaw_deg; in arrangement.poses each row has them behind its pose.")));
}

void add_analysis(Keys& keys, Analysis& analysis) {
    keys.push_back(number_key("analysis.steady_start_s", analysis.steady_start, unit::one,
                              at_least(0).at_most(farthest),
                              "loads are steady from 120 s on (docs/validation.md); of another hull derived: ice lies "
                              "along it and two floes more, five natural periods have passed",
                              "Start of the window: late enough for the load to be steady."));
    keys.push_back(number_key("analysis.window_s", analysis.window, unit::one, above(0).at_most(farthest),
                              "the paper, Results; of another hull derived: ten natural periods, and two breadths or "
                              "five floes in each segment",
                              "Length of the window. A longer window needs a longer field."));
    keys.push_back(integer_key("analysis.segments", analysis.segments, 1, 10000,
                               "the paper, Results; of another hull fewer where three do not cut a stated window",
                               "Number of equal parts of the window; mean_maximum is the mean of their maxima."));
    keys.push_back(history_steps(analysis));
    keys.push_back(late_key(numbers_key(
        "analysis.exceedance_levels_N", analysis.exceedance_levels, unit::one, at_least(0).at_most(1e12), "none",
        "Load levels, ascending: each member counts the steps of the window with a surge load "
        "above each level, and how often the load rises through it. Needs no history.")));
    keys.push_back(late_key(numbers_key(
        "analysis.averaging_s", analysis.averaging, unit::one, above(0).at_most(farthest),
        "from a jammed contact to a slow structure",
        "Averaging times, ascending, in whole time steps and at most a segment: each member takes the running mean of "
        "the surge load over each, and its standard deviation and segment maxima. Needs no history. Of the default, "
        "times that do not suit time step or segment are left out.")));
    keys.push_back(late_key(number_key(
        "analysis.peak_separation_s", analysis.peak_separation, unit::one, above(0).at_most(farthest),
        "longer than the load remembers: docs/design_load.md",
        "Peaks of the averaged load count as two where they are this far apart; of nearer ones the highest counts. "
        "Design loads are extrapolated from these peaks.")));
}

namespace {

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
    const auto of_file = late_with("shapes.kind = \"file\"", [&shapes] { return shapes.from_file(); });
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
        "Area that a floe may gain over its own: holes are filled, and bays of less than 1 % closed. More is "
        "refused.")));
    keys.push_back(of_file({"shapes.outlines", outline_rows(traced), "none",
                            "The outlines themselves, a row for each corner: the number of its floe, and where it is. "
                            "With at most 16 corners, or 32 where it has bays."}));
    keys.push_back(
        of_file(numbers_key("shapes.traced_areas_m2", traced.areas, unit::one, above(0).at_most(1e10), "none",
                            "Area of each outline in shapes.file, by which these are judged; "
                            "empty: they came from no file.")));
    keys.push_back(of_file(text_key("shapes.names", traced.names, "none",
                                    "Names of the outlines in shapes.file, divided by commas, for messages.")));
}

}  // namespace

void add_shapes(Keys& keys, Shapes& shapes) {
    const auto of = [&shapes](ShapeKind kind, std::string_view setting) {
        return late_with(setting, [&shapes, kind] { return shapes.kind == kind; });
    };
    const auto of_polygons = of(ShapeKind::polygon, "shapes.kind = \"polygon\"");
    const auto of_cells = of(ShapeKind::voronoi, "shapes.kind = \"voronoi\"");
    keys.push_back(late_key(word_key(
        "shapes.kind", shapes.kind, {"rectangle", "polygon", "voronoi", "file"}, "the paper: squares",
        "Floes seen from above. rectangle: as [floe] and [sizes] say. polygon: convex polygons of the same areas and "
        "proportions, scattered. voronoi: cells of a Voronoi diagram of the whole field, laid where they grew, with "
        "even gaps that leave the concentration; length_m x breadth_m of [floe] is their mean area. "
        "docs/sea_ice.md.")));
    keys.push_back(of_polygons(integer_key("shapes.corners", shapes.corners, 3, 12,
                                           "the mean of Voronoi cells in a plane", "Corners of every floe.")));
    keys.push_back(of_polygons(number_key("shapes.irregularity", shapes.irregularity, unit::one,
                                          at_least(0).at_most(0.9), "an example: halfway from regular polygons to any",
                                          "How far corners lie from even places on an ellipse, as a share of the way "
                                          "to the next; 0: regular polygons.")));
    keys.push_back(of_cells(integer_key(
        "shapes.relaxations", shapes.relaxations, 0, 1000, "no cell smaller than an element; sea_ice.md",
        "Steps of Lloyd's from random points: 0 leaves cells of very unequal areas, many make them alike.")));
    add_traced(keys, shapes);
}

namespace {

void add_current(Keys& keys, Water& water) {
    const Range angle = at_least(-360).at_most(360);
    keys.push_back(late_key(number_key("water.current_m_s", water.current, unit::one, at_least(0).at_most(100), "none",
                                       "Speed of the current. Floes drift with it from the start; the flow past the "
                                       "structure is that of the tow relative to it.")));
    keys.push_back(late_key(only_with(
        "water.current_m_s > 0", [&water] { return water.current > 0; },
        number_key("water.current_direction_deg", water.current_direction, unit::degree, angle, "along the tow",
                   "Direction towards which the current flows: 0 along the tow, 90 towards +z."))));
    keys.push_back(late_key(
        number_key("water.turning_deg", water.turning, unit::degree, at_least(-90).at_most(90),
                   "none in a tank; at sea 20 to 25 (Leppäranta, The Drift of Sea Ice, 2011, chapter 5)",
                   "Turning angle of the boundary layer below the ice: the water's skin drag is turned by it "
                   "from the water's motion relative to the ice, anticlockwise from above (northern hemisphere).")));
}

void add_bed(Keys& keys, Water& water) {
    const auto of_bed = late_with("water.depth_m > 0", [&water] { return water.has_bed(); });
    keys.push_back(late_key(number_key(
        "water.depth_m", water.depth, unit::one, at_least(0).at_most(farthest), "none: deep water",
        "Depth of the bed below structure.start_m. Ice grounds on it, and what it bears is no load of the structure; "
        "docs/water.md. 0: no bed.")));
    keys.push_back(of_bed(
        number_key("water.bed_slope_deg", water.bed_slope, unit::degree, at_least(-80).at_most(80), "level",
                   "Angle by which the bed rises along the tow, from the horizontal; negative where it falls.")));
    keys.push_back(of_bed(number_key("water.bed_friction", water.bed_friction, unit::one, at_least(0).at_most(10),
                                     "an example", "Friction coefficient of ice on the bed.")));
}

}  // namespace

void add_water(Keys& keys, Water& water) {
    const Range coefficient = at_least(0).at_most(100);
    keys.push_back(number_key("water.density_kg_m3", water.density, unit::one, above(0).at_most(5000), "Table 1",
                              "Density of water."));
    keys.push_back(word_key(
        "water.flow", water.flow, {"potential", "still"}, "design; the paper: a simple flow around the structure",
        "Water velocity for the drag: potential flow round the moving waterline circle, or water at rest."));
    keys.push_back(number_key(
        "water.form_drag", water.form_drag, unit::one, coefficient, "Su, Aarsæther and Kristiansen 2019; others 0.5",
        "Form drag coefficient on the wetted edge faces of a floe. It carries floes round the structure."));
    keys.push_back(late_key(number_key(
        "water.shelter_draughts", water.shelter_draughts, unit::one, coefficient,
        "1/0.18, Hanssen-Bauer and Gjessing 1988; Tsamados et al. 2014; others 2",
        "Form drag on an edge with ice ahead, D away, is the share 1 - exp(-D/(n H)) of that in the open, with H the "
        "draught and n this; seen from the ice ahead. 0: no ice shelters another.")));
    keys.push_back(number_key("water.skin_drag", water.skin_drag, unit::one, coefficient,
                              "laminar plate, 1.328 / sqrt(Re) at Re 2.3e4; others 0.002 to 0.01",
                              "Skin drag coefficient on the bottom face."));
    keys.push_back(number_key("water.heave_drag", water.heave_drag, unit::one, coefficient, "bluff plate, DNV-RP-C205",
                              "Quadratic drag coefficient on vertical motion."));
    const auto damped_by_share = [&water] { return water.heave_damping_from == WaterFrom::share; };
    const auto mass_by_share = [&water] { return water.added_mass_from == WaterFrom::share; };
    keys.push_back(late_key(word_key(
        "water.heave_damping_from", water.heave_damping_from, {"share", "outline"},
        "closed form, docs/water.md; ice under water makes no waves",
        "Damping by waves. outline: what a plate of the outline of each connected piece radiates as it heaves, on "
        "ice that cuts the surface. share: water.heave_damping of each element by itself, under water too.")));
    keys.push_back(only_with("water.heave_damping_from = \"share\"", damped_by_share,
                             number_key("water.heave_damping", water.heave_damping, unit::one, at_least(0).at_most(1),
                                        "the paper's preset; usual 0.1 to 0.2",
                                        "Linear damping of vertical motion, as a share of an element's critical "
                                        "damping.")));
    keys.push_back(late_key(word_key(
        "water.added_mass_from", water.added_mass_from, {"share", "outline"}, "closed form, docs/water.md",
        "Water that moves with the ice. outline: in heave, roll and pitch that of a plate of the outline of each "
        "connected piece, 5 times the mass of the tank's floes; with solver direct only. share: water.added_mass in "
        "every direction.")));
    keys.push_back(only_with(
        "water.added_mass_from = \"share\"", mass_by_share,
        number_key("water.added_mass", water.added_mass, unit::one, coefficient, "none, as in the paper's preset",
                   "Added mass: mass of water that moves with an element, equal in all directions, as a "
                   "share of the element's own mass. The stiffness of joints that follow Σ is proportional to the "
                   "total mass (see [joint]), so another value needs another cfm.")));
    keys.push_back(late_key(only_with(
        "water.added_mass_from = \"outline\"", [mass_by_share] { return !mass_by_share(); },
        number_key("water.added_mass_in_plane", water.added_mass_in_plane, unit::one, coefficient,
                   "between 0.04 for fast and 0.18 for slow motion of the tank's floes, docs/water.md",
                   "Added mass along the surface and in yaw, as a share of the ice's mass."))));
    add_current(keys, water);
    add_bed(keys, water);
}

void add_wind(Keys& keys, Wind& wind) {
    const auto of_wind = late_with("wind.speed_m_s > 0", [&wind] { return wind.speed > 0; });
    keys.push_back(late_key(number_key("wind.speed_m_s", wind.speed, unit::one, at_least(0).at_most(100), "none",
                                       "Speed of the wind. Its stress on ice above the water is ρ_a C_a U².")));
    keys.push_back(of_wind(number_key("wind.direction_deg", wind.direction, unit::degree, at_least(-360).at_most(360),
                                      "along the tow",
                                      "Direction towards which the wind blows: 0 along the tow, 90 towards +z.")));
    keys.push_back(
        of_wind(number_key("wind.drag", wind.drag, unit::one, at_least(0).at_most(1),
                           "1e-3 to 2e-3 for the wind at 10 m (Leppäranta, The Drift of Sea Ice, 2011, chapter 5)",
                           "Drag coefficient C_a of the air on the ice.")));
    keys.push_back(of_wind(number_key("wind.air_density_kg_m3", wind.air_density, unit::one, above(0).at_most(10),
                                      "cold air", "Density of the air.")));
}

}  // namespace floes
