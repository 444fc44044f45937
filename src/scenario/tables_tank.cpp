// Keys of the tables [field], [arrangement], [structure], [analysis]: the tank and what is measured in it.

#include <fmt/format.h>

#include <algorithm>

#include "keys/former.hpp"
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

RowsField shape_rows(Shape& shape) {
    std::vector<Column> columns;
    for (const ShapeColumn& column : Shape::columns)
        columns.push_back(
            {fmt::format("{}_{}", column.name, column.unit), unit::one, at_least(column.low).at_most(column.high)});
    return {columns, [&shape] { return shape.rows(); },
            [&shape](const std::vector<std::vector<double>>& rows) { shape.set_profile(rows); }};
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

/// Of a field without end.
void add_window(Keys& keys, Field& field) {
    const auto add = [&](const char* path, double& length, const char* source, const char* doc) {
        keys.push_back(late_key(only_with(
            "field.far_end = \"never\"", [&field] { return field.endless(); },
            number_key(path, length, unit::one, at_least(0).at_most(farthest), source, doc))));
    };
    add("field.ahead_m", field.ahead, "longer changed no load that was seen; docs/endless.md",
        "How far ahead of the structure's axis floes are computed. Those farther ahead rest, fixed to whatever touches "
        "them, as a field that is held from ahead. 0: two widths of the field.");
    add("field.behind_m", field.behind, "longer changed no load that was seen; docs/endless.md",
        "How far behind the structure's axis floes are computed. Those farther behind are taken out. 0: one width of "
        "the field.");
}

}  // namespace

void add_field(Keys& keys, Field& field) {
    const Range place = at_least(-farthest).at_most(farthest);
    keys.push_back(integer_key(
        "field.floes", field.floes, 1, most_floes, "Table 3",
        "Number of floes. The failure ratio is relative to all of them. Of a field without end: of each part "
        "that is laid; the failure ratio is relative to the floes that were computed."));
    keys.push_back(number_key(
        "field.concentration_percent", field.concentration, unit::percent, above(0).at_most(100), "Table 1",
        "Covered area fraction of the field. Together with the number and size of floes it sets the field's length."));
    keys.push_back(number_key("field.begin_m", field.begin, unit::one, place, "the paper, Simulation Design",
                              "Position along x where the field begins."));
    keys.push_back(number_key(
        "field.half_width_m", field.half_width, unit::one, above(0).at_most(1e4), "the paper, Simulation Design",
        "Half width of the field: |z| is at most this, between the fixed ice sheets along the walls."));
    keys.push_back(number_key("field.sheet_width_m", field.sheet_width, unit::one, above(0).at_most(1e4),
                              "wider than a floe's diagonal",
                              "Breadth of the fixed ice sheets. If a floe is pushed over a sheet and beyond its outer "
                              "edge, the member ends as failed."));
    keys.push_back(word_key(
        "field.far_end", field.far_end, {"ice_sheet", "open", "never"},
        "design decision; the paper names the walls only",
        "Far end of the field: closed by a fixed ice sheet, or open water. With an open far end, the "
        "load on a straight 45° wall is half as large and that on a 76° wall a fifth, and hardly any floe breaks. "
        "never: ice comes from ahead as long as the run lasts, laid in parts of field.floes floes; docs/endless.md."));
    add_window(keys, field);
    keys.push_back(
        late_key(word_key("field.sides", field.sides, {"ice_sheet", "open"}, "the paper: walls",
                          "Sides of the field: ice sheets along the walls, or open water, into which floes drift.")));
    add_confinement(keys, field);
    keys.push_back(
        number_key("field.wake_radius_m", field.wake_radius, unit::one, at_least(0).at_most(farthest),
                   "off: every floe is computed",
                   "Not with solver stock: a floe rests, at no cost, until the structure's axis is within this "
                   "distance of its middle or moving ice touches it. This neglects a displacement by the "
                   "flow ahead of the structure of at most waterline radius² / this. 0: off."));
}

void add_arrangement(Keys& keys, ArrangementRule& arrangement) {
    const Key method =
        word_key("arrangement.method", arrangement.method, {"monte_carlo", "lattice", "file", "scattered", "traced"},
                 "floes in a tank are laid at random; docs/order.md",
                 "scattered: a disordered field, floes thrown at random and pushed apart until none overlap; "
                 "monte_carlo: equilibrium of hard squares, rows and columns where they are dense, independent of the "
                 "start; lattice: rows, with jitter; file: given poses, the same for each arrangement; traced: where "
                 "shapes.file has them, likewise.");
    keys.push_back(
        instead_of({method, word_key("arrangement.start", arrangement.start, {"lattice", "stripes"}, "", "")}, method));
    keys.push_back(number_key("arrangement.clearance_m", arrangement.clearance, unit::one, at_least(0).at_most(10),
                              "a hundredth of an element: none touch at first",
                              "Minimum initial gap between floes, and between floes and walls."));
    keys.push_back(integer_key("arrangement.sweeps", arrangement.sweeps, 0, 10000000,
                               "stripes decay in 9000: docs/arrangement.md",
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

void add_structure(Keys& keys, Structure& structure) {
    const auto by_profile = [&structure] { return structure.shape.kind() == HullKind::profile; };
    keys.push_back(only_with(
        "hull.shape = \"profile\"", by_profile,
        {"structure.profile_m", shape_rows(structure.shape),
         "Table 2; the radius at the bottom is fitted (docs/validation.md)",
         "Radius over height above the waterline, from the keel up, with heights that never decrease. The wall angle "
         "decides the load: a steeper wall below the waterline gives higher loads and more broken floes."}));
    keys.push_back(only_with("hull.shape = \"profile\"", by_profile, keel_radius(structure.shape)));
    keys.push_back(number_key("structure.start_m", structure.start, unit::one, at_least(-farthest).at_most(farthest),
                              "the paper, Simulation Design", "Initial position of the structure's axis along x."));
    keys.push_back(number_key("structure.speed_m_s", structure.speed, unit::one, above(0).at_most(100), "Table 1",
                              "Speed of the tow along +x, from the first step on."));
}

void add_analysis(Keys& keys, Analysis& analysis) {
    keys.push_back(number_key("analysis.steady_start_s", analysis.steady_start, unit::one,
                              at_least(0).at_most(farthest), "loads are steady from 120 s on (docs/validation.md)",
                              "Start of the window: late enough for the load to be steady."));
    keys.push_back(number_key("analysis.window_s", analysis.window, unit::one, above(0).at_most(farthest),
                              "the paper, Results", "Length of the window. A longer window needs a longer field."));
    keys.push_back(integer_key("analysis.segments", analysis.segments, 1, 10000, "the paper, Results",
                               "Number of equal parts of the window; mean_maximum is the mean of their maxima."));
    keys.push_back(history_steps(analysis));
    keys.push_back(late_key(numbers_key(
        "analysis.exceedance_levels_N", analysis.exceedance_levels, unit::one, at_least(0).at_most(1e6), "none",
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

}  // namespace floes
