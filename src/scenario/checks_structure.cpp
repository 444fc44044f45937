// Contradictions of the structure: its path and moorings, and with field, floes and laws.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/vector.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {

namespace {

/// A turn goes the shorter way, so one that is written as more than a full turn is not what it says.
std::string beyond_a_turn(double from, double to) {
    constexpr double full = 2 * std::numbers::pi * (1 + 1e-12);
    if (std::abs(to - from) <= full) return "";
    return fmt::format("turns from {:g} to {:g} degrees, and turns go the shorter way, never by more than 180; ",
                       from / unit::degree, to / unit::degree);
}

void check_legs(const Scenario& scenario, Contradictions& found) {
    const Path& path = scenario.path;
    if (!path.table.empty()) {
        refuse(found, {"path.places", "path.legs"}, "path.legs and path.places are two paths; leave one out");
        return;
    }
    const double shortest = std::ranges::min(path.legs, {}, &PathLeg::time).time;
    if (path.ramp > shortest) {
        refuse(scenario, found, {"path.ramp_s", "path.legs"},
               "<path.ramp_s> is longer than the shortest leg, {:g} s; take at most that", shortest);
    }
    if (path.of == PathOf::ice && path.bow == PathBow::ahead) {
        refuse(found, {"path.bow", "path.of"},
               "path.bow = \"ahead\" turns the structure with the heading, and path.of = \"ice\" has it stand; take "
               "path.bow = \"unturned\"");
    }
    for (std::size_t k = 1; k < path.legs.size(); ++k) {
        const PathLeg& before = path.legs[k - 1];
        const PathLeg& leg = path.legs[k];
        const std::string turn = beyond_a_turn(before.heading, leg.heading);
        if (turn.empty() || beyond_a_turn(before.heading + before.turn * before.time, leg.heading).empty()) continue;
        refuse(found, {"path.legs"}, "path.legs[{}] {}let a leg turn by its turn_deg_s for more", k, turn);
        return;
    }
}

void check_table(const std::vector<PathPoint>& table, Contradictions& found) {
    const auto wrong = [&](std::size_t row, const std::string& what) {
        refuse(found, {"path.places"}, "path.places[{}] {}", row, what);
    };
    const PathPoint& first = table.front();
    if (first.time != 0 || first.x != 0 || first.z != 0)
        wrong(0, "is not at time 0 at the start; begin with [0, 0, 0, yaw], since places are from the start");
    for (std::size_t row = 1; row < table.size(); ++row) {
        if (const std::string turn = beyond_a_turn(table[row - 1].yaw, table[row].yaw); !turn.empty())
            return wrong(row, turn + "put rows between them for more");
        if (table[row].time > table[row - 1].time) continue;
        return wrong(row, fmt::format("is at {:g} s, not after the row before at {:g} s; times have to rise",
                                      table[row].time, table[row - 1].time));
    }
}

/// Where on its way the structure is not between the banks and the ends of the channel.
void check_way(const Scenario& scenario, const std::vector<PathPlace>& places, Contradictions& found) {
    const std::string key = scenario.path.legs.empty() ? "path.places" : "path.legs";
    const double radius = scenario.structure.shape.largest_radius();
    const double step = scenario.general.time_step;
    const double begin = scenario.structure.start - length_rounding;
    const bool endless = scenario.field.endless();
    const double end = endless ? std::numeric_limits<double>::infinity() : scenario.field_end() + length_rounding;
    bool meets = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const PathPlace& place = places[k];
        const double x = scenario.structure.start + place.pose.x;
        const double time = step * static_cast<double>(k);
        meets = meets || x + radius >= scenario.field.begin;
        if (std::abs(place.pose.z) + radius > scenario.field.half_width + length_rounding)
            return refuse(scenario, found, {key},
                          "the path takes the structure, of radius {:.4g} m, to z = {:.4g} m after {:.6g} s, into the "
                          "bank at <field.half_width_m>; turn earlier or widen the field",
                          radius, place.pose.z, time);
        if (x + radius > end || x < begin)
            return refuse(scenario, found, {key},
                          "the path leaves the channel: after {:.6g} s the axis is at x = {:.4g} m, and it has to stay "
                          "{} <structure.start_m>{}",
                          time, x, endless ? "ahead of" : "from",
                          endless ? std::string("; begin with a leg along +x")
                                  : fmt::format(" to {:.4g} m; take a shorter way or more floes", end - radius));
        const double speed = place.velocity.norm() + radius * std::abs(place.turning);
        if (speed >= scenario.general.runaway_speed)
            return refuse(scenario, found, {key},
                          "the path moves the structure's wall at {:.4g} m/s at {:.6g} s, not below "
                          "<general.runaway_speed_m_s>; give turns time, by path.ramp_s or more rows",
                          speed, time);
    }
    if (!meets)
        refuse(scenario, found, {key, "structure.start_m", "field.begin_m"},
               "the path never reaches the ice that begins at <field.begin_m>; start nearer or go farther");
}

/// The first row that has not more of both than the row before; as many as there are where all rise.
std::size_t first_that_does_not_rise(const std::vector<TensionPoint>& curve) {
    std::size_t row = 1;
    while (row < curve.size() && curve[row].extension > curve[row - 1].extension &&
           curve[row].tension > curve[row - 1].tension)
        ++row;
    return row;
}

void check_lines(const Scenario& scenario, Contradictions& found) {
    const Moorings& moorings = scenario.moorings;
    const std::vector<TensionPoint>& curve = moorings.curve;
    if (!curve.empty()) {
        if (moorings.lines.empty())
            refuse(found, {"moorings.line_curve", "moorings.lines"},
                   "moorings.line_curve is of moorings.lines, and there are none; give lines or leave it out");
        if (curve.size() < 2)
            refuse(found, {"moorings.line_curve"}, "moorings.line_curve has one row; two or more are a curve");
        if (const std::size_t row = first_that_does_not_rise(curve); row < curve.size())
            refuse(found, {"moorings.line_curve"},
                   "moorings.line_curve[{}] does not have more extension and more tension than the row before; both "
                   "have to rise",
                   row);
    }
    for (std::size_t row = 0; row < moorings.lines.size(); ++row) {
        const MooringLine& line = moorings.lines[row];
        const auto wrong = [&](const std::string& what) {
            refuse(found, {"moorings.lines", "moorings.line_curve"}, "moorings.lines[{}] {}", row, what);
        };
        if (!curve.empty() && line.stiffness > 0)
            wrong("has a stiffness beside moorings.line_curve; make it 0 or leave the curve out");
        if (curve.empty() && line.stiffness == 0) wrong("has no stiffness; give it one or moorings.line_curve");
        if (curve.size() > 1 && (line.pretension < curve.front().tension ||
                                 (line.pretension == curve.front().tension && line.pretension > 0)))
            wrong(fmt::format("has a pretension of {:g} kN, not above the {:g} kN where moorings.line_curve begins",
                              line.pretension / 1e3, curve.front().tension / 1e3));
        if (curve.size() > 1 && line.pretension >= curve.back().tension)
            wrong(fmt::format("has a pretension of {:g} kN, not below the {:g} kN where moorings.line_curve ends",
                              line.pretension / 1e3, curve.back().tension / 1e3));
        if (line.break_load > 0 && line.pretension > line.break_load)
            wrong(fmt::format("breaks at {:g} kN, below its pretension of {:g} kN", line.break_load / 1e3,
                              line.pretension / 1e3));
    }
}

void check_turret(const Moorings& moorings, Contradictions& found) {
    const std::vector<TensionPoint>& curve = moorings.turret.curve;
    if (moorings.turret.lines && moorings.line_count() == 0)
        refuse(found, {"moorings.turret", "moorings.hanging_lines"},
               "moorings.turret = true is of moorings.hanging_lines or moorings.lines, and there are none; give lines "
               "or moorings.turret_curve");
    if (curve.empty()) return;
    const auto wrong = [&](std::size_t row, const char* what) {
        refuse(found, {"moorings.turret_curve"}, "moorings.turret_curve[{}] {}", row, what);
    };
    if (curve.size() < 2) return wrong(0, "is the only row; two or more are a curve");
    if (curve.front() != TensionPoint{})
        return wrong(0, "is not [0, 0], where the mooring is at rest; begin with that");
    if (const std::size_t row = first_that_does_not_rise(curve); row < curve.size())
        wrong(row, "does not have more offset and more force than the row before; both have to rise");
}

void check_thrusters(const Scenario& scenario, Contradictions& found) {
    struct Direction {
        const char *gain, *limit;
    };
    constexpr std::array<Direction, 3> directions{{{"moorings.dp_surge_kN_m", "moorings.dp_surge_limit_kN"},
                                                   {"moorings.dp_sway_kN_m", "moorings.dp_sway_limit_kN"},
                                                   {"moorings.dp_yaw_kN_m_rad", "moorings.dp_yaw_limit_kN_m"}}};
    const Thrusters& thrusters = scenario.moorings.thrusters;
    for (int k = 0; k < 3; ++k) {
        if (thrusters.limit[k] == 0 || thrusters.gain[k] > 0) continue;
        const auto [gain, limit] = directions.at(static_cast<std::size_t>(k));
        refuse(scenario, found, {limit, gain}, "<{}> limits thrusters that {} = 0 leaves out; give both or neither",
               limit, gain);
    }
}

double heaviest_floe(const Scenario& scenario) {
    const FloeSet floes = floes_of(scenario);
    double heaviest = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const FloeShape& shape = floes.shape(i);
        heaviest = std::max(heaviest, shape.area() * shape.thickness * floes.material(i).ice.density);
    }
    return heaviest;
}

/// The load of a step moves the structure in the next: right while the ice that it strikes is light beside it.
void check_mass(const Scenario& scenario, Contradictions& found) {
    constexpr double least = 10;
    const double ratio = structure_over_floe(scenario);
    if (ratio >= least) return;
    if (scenario.arrangement.level())
        return refuse(scenario, found, {"moorings.mass_t", "arrangement.method"},
                      "<moorings.mass_t> and the water that moves with it are {:.4g} times the sheet of level ice, and "
                      "{:g} times is the least: the structure moves after each step only, too late for ice that is "
                      "one piece; take moorings.mass_t = 0, which holds it",
                      ratio, least);
    refuse(scenario, found, {"moorings.mass_t", "floe.length_m"},
           "<moorings.mass_t> and the water that moves with it are {:.4g} times the heaviest floe, and {:g} times is "
           "the least: a floe that strikes the structure would push it {:.2g} % too hard, since the structure moves "
           "after each step only; take smaller floes or moorings.mass_t = 0",
           ratio, least, 100 / ratio);
}

void check_periods(const Scenario& scenario, Contradictions& found) {
    constexpr double fewest_steps = 50;
    for (const NaturalMode& mode : natural_modes(scenario.moorings, scenario.water_stiffness())) {
        const std::string_view word = motion_names.at(at(mode.motion));
        if (std::isnan(mode.period)) {
            refuse(scenario, found, {"moorings.centre_m", "moorings.mass_t"},
                   "the hull does not float upright: with its centre at <moorings.centre_m>, in {} its weight turns it "
                   "over; take a lower centre, or a moorings.free without {}; a hull of a file that lies on its side "
                   "wants another hull.up",
                   word, word);
        } else if (weathervanes(scenario.moorings, mode)) {
            continue;
        } else if (!std::isfinite(mode.period) && scenario.moorings.turret.any()) {
            refuse(scenario, found, {"moorings.turret_m", "moorings.free"},
                   "nothing rights the structure in yaw: ice turns it away from a turret at <moorings.turret_m>; take "
                   "a turret ahead of the axis, thrusters that hold the heading, or a moorings.free without yaw");
        } else if (!std::isfinite(mode.period)) {
            refuse(found, {"moorings.free", "moorings.lines"},
                   "nothing holds the structure in {}; give a stiffness, lines or thrusters that hold it, or take a "
                   "moorings.free without {}",
                   word, word);
        } else if (mode.period < fewest_steps * scenario.general.time_step) {
            refuse(scenario, found, {"moorings.mass_t", "general.time_step_s"},
                   "the moored structure's natural period in {} is {:.4g} s, fewer than {:g} steps of "
                   "<general.time_step_s>; take softer moorings, a shorter step or moorings.mass_t = 0",
                   word, mode.period, fewest_steps);
        }
    }
}

void check_matrix(const std::vector<std::vector<double>>& rows, const std::string& key, Contradictions& found) {
    if (rows.empty()) return;
    if (rows.size() != 6)
        return refuse(found, {key}, "{} has {} rows of six; a matrix of six motions has six", key, rows.size());
    std::array<double, 2> largest{};  // of motions along axes and about them
    for (std::size_t k = 0; k < 6; ++k) largest[k / 3] = std::max(largest[k / 3], std::abs(rows[k][k]));
    constexpr double much = 0.02;  // radiation programs differ by less
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (std::abs(rows[a][b] - rows[b][a]) <= much * std::sqrt(largest[a / 3] * largest[b / 3])) continue;
            return refuse(found, {key}, "{}[{}][{}] and [{}][{}] differ, {:g} and {:g}; such a matrix is symmetric",
                          key, a, b, b, a, rows[a][b] / unit::tonne, rows[b][a] / unit::tonne);
        }
    }
}

/// Waves take energy from a motion. Radiation programs have negative damping where they are out of their depth.
void check_damping(const std::vector<std::vector<double>>& rows, Contradictions& found) {
    for (std::size_t k = 0; k < rows.size() && rows.size() == 6; ++k) {
        if (rows[k][k] >= 0) continue;
        return refuse(found, {"moorings.radiation_damping"},
                      "moorings.radiation_damping[{}][{}] is {:g}, which would drive that motion on; give 0 or more, "
                      "as floes hydro does",
                      k, k, rows[k][k] / unit::tonne);
    }
}

/// Something to move in every motion in which it gives way.
void check_inertia(const Scenario& scenario, Contradictions& found) {
    const Moorings& moorings = scenario.moorings;
    const std::vector<int> directions = moorings.directions();
    if (directions.empty()) {
        return refuse(found, {"moorings.free"},
                      "moorings.free = [] holds the structure in all motions; name one, or take moorings.mass_t = 0");
    }
    constexpr std::array<const char*, 6> gyrations{
        "", "", "moorings.gyration_m", "", "moorings.gyration_pitch_m", "moorings.gyration_roll_m"};
    const Mat6 inertia = moorings.inertia();
    for (const int k : directions) {
        const auto motion = static_cast<std::size_t>(k);
        const std::string gyration = gyrations.at(motion);
        if (inertia(k, k) > 0) continue;
        if (inertia(k, k) < 0 || gyration.empty())
            refuse(found, {"moorings.added_mass", "moorings.mass_t"},
                   "mass and added mass together are {:.4g} {} in {}; they have to be above 0",
                   inertia(k, k) / unit::tonne, gyration.empty() ? "t" : "t m²", motion_names.at(motion));
        else
            refuse(found, {gyration, "moorings.free"},
                   "{} = 0 leaves nothing to turn; give the radius of gyration, or take a moorings.free without \"{}\"",
                   gyration, motion_names.at(motion));
    }
    if (!found.empty()) return;
    const Mat6 even = 0.5 * (inertia + inertia.transpose());
    const Eigen::MatrixXd moved = even(directions, directions);
    if (moved.llt().info() != Eigen::Success)
        refuse(found, {"moorings.added_mass"},
               "mass and moorings.added_mass together are no inertia (not positive definite): some motion would have "
               "none; look at the signs and units of the matrix");
}

}  // namespace

double structure_over_floe(const Scenario& scenario) {
    const Mat6 inertia = scenario.moorings.inertia();
    return std::min(inertia(0, 0), inertia(1, 1)) / heaviest_floe(scenario);
}

double struck_over_floe(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const std::vector<int> free = scenario.moorings.directions();
    const Eigen::MatrixXd inertia = scenario.moorings.inertia()(free, free);
    const Eigen::LLT<Eigen::MatrixXd> solver(inertia);
    double most = 0;  // of what a blow of 1 N s moves its own place by, m/s
    const auto strike = [&](const Vec2& at, const Vec2& along) {
        Vec6 blow = Vec6::Zero();
        blow.head<3>() << along.x(), along.y(), at.y() * along.x() - at.x() * along.y();
        const Eigen::VectorXd given = blow(free);
        most = std::max(most, given.dot(solver.solve(given)));
    };
    for (const std::vector<Vec2>& outline : shape.waterlines()) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Vec2& next = outline[(k + 1) % outline.size()];
            const Vec2 edge = next - outline[k];
            const Vec2 normal = Vec2(-edge.y(), edge.x()).normalized();
            // A round wall is met on the normal through its axis.
            const double half = shape.is_of_revolution() ? 0.5 : 0.0;
            if (edge.norm() > 0) strike(outline[k] + half * edge, normal), strike(next - half * edge, normal);
        }
    }
    return 1 / (most * heaviest_floe(scenario));
}

void check_hanging(const HangingLine& line, const std::string& name, Contradictions& found) {
    constexpr double most_strain = 0.1;
    const auto wrong = [&](const std::string& what) { refuse(found, {"moorings.hanging_lines"}, "{} {}", name, what); };
    const double drop = line.depth + line.fairlead.y();
    if (!(drop > 1e-4 * line.distance))  // ten times what the stiffness is found with
        return wrong(fmt::format(
            "has its fairlead {:g} m below its anchor; depth_m is of the anchor below the calm water", -drop));
    const double chord = std::hypot(line.distance, drop);
    if (chord > (1 + most_strain) * line.cable.length)
        wrong(fmt::format("is {:.4g} m long and would be stretched to {:.4g} m; take a longer line or a nearer anchor",
                          line.cable.length, chord));
    const double tension = pull(line, Vec6::Zero()).tension;
    if (line.break_load > 0 && tension > line.break_load)
        wrong(fmt::format("pulls with {:.4g} kN at rest, more than its break load", tension / unit::kilonewton));
}

void check_matrices(const Moorings& moorings, Contradictions& found) {
    check_matrix(moorings.added_mass, "moorings.added_mass", found);
    check_matrix(moorings.radiation_damping, "moorings.radiation_damping", found);
    check_damping(moorings.radiation_damping, found);
}

void check_path(const Scenario& scenario, Contradictions& found) {
    const Path& path = scenario.path;
    if (!path.any() || !found.empty()) return;  // the tow without it is to be without fault
    if (!path.legs.empty()) check_legs(scenario, found);
    if (!path.table.empty()) check_table(path.table, found);
    if (found.empty()) check_way(scenario, scenario.places(), found);
}

void check_moorings(const Scenario& scenario, Contradictions& found) {
    const Moorings& moorings = scenario.moorings;
    if (!moorings.give_way()) return;
    const std::size_t before = found.size();
    check_lines(scenario, found);
    for (std::size_t row = 0; row < moorings.hanging.size(); ++row)
        check_hanging(moorings.hanging[row], fmt::format("moorings.hanging_lines[{}]", row), found);
    check_turret(moorings, found);
    check_thrusters(scenario, found);
    check_matrices(moorings, found);
    if (found.size() > before) return;
    check_inertia(scenario, found);
    if (scenario.path.any() && scenario.path.bow == PathBow::ahead && !scenario.path.legs.empty()) {
        refuse(found, {"path.bow", "moorings.mass_t"},
               "path.bow = \"ahead\" would turn the moorings with the heading; take \"unturned\"");
    }
    if (std::ranges::any_of(scenario.path.table, [](const PathPoint& at) { return at.yaw != 0; })) {
        refuse(found, {"path.places", "moorings.mass_t"},
               "path.places has yaw, which would turn the moorings; make it 0, the structure yaws by itself");
    }
    if (found.size() > before) return;
    check_mass(scenario, found);
    check_periods(scenario, found);
}

namespace {

void check_added_volume(const Structure& structure, Contradictions& found) {
    const double own = structure.hull_file.volume;
    if (structure.shape.kind() != HullKind::file || own == 0) return;
    const double added = structure.shape.volume() / own - 1;
    if (added <= structure.hull_file.most_added) return;
    refuse(found, {"hull.most_added_percent", "hull.file"},
           "the convex pieces of the hull fill {:.3g} % more than it, over hull.most_added_percent = {:g}; cut the "
           "hull into bodies that are convex yourself, or allow more",
           100 * added, 100 * structure.hull_file.most_added);
}

}  // namespace

void check_shape(const Scenario& scenario, Contradictions& found) {
    const Structure& structure = scenario.structure;
    const bool by_profile = structure.shape.kind() == HullKind::profile;
    const std::string key = by_profile ? "structure.profile_m" : "hull.shape";
    if (const auto fault = structure.shape.fault()) {
        refuse(scenario, found, {key}, "<{}> {}", key, *fault);
        return;
    }
    check_added_volume(structure, found);
    const double breadth = 2 * structure.shape.waterline_radius();
    if (by_profile || breadth >= 0.5 * scenario.floe.element) return;
    refuse(scenario, found, {key, "floe.element_m"},
           "the structure is {:.4g} m wide at the waterline, less than half of <floe.element_m>; take smaller "
           "elements, or look at hull.unit",
           breadth);
}

void check_tow(const Scenario& scenario, Contradictions& found) {
    const Structure& structure = scenario.structure;
    const double radius = structure.shape.waterline_radius();
    const double ahead = structure.shape.waterline_ahead(scenario.first_yaw());
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    // Ice that nothing holds drifts with the current while the structure comes.
    const double drift = scenario.field.far_end == FarEnd::open ? scenario.water.current_velocity().x() : 0;
    const double end = structure.start + (structure.speed - drift) * duration;
    if (structure.speed >= scenario.general.runaway_speed) {
        refuse(scenario, found, {"structure.speed_m_s", "general.runaway_speed_m_s"},
               "<structure.speed_m_s> is not below <general.runaway_speed_m_s>, so ice pushed by the structure would "
               "count as run away; raise the limit");
    }
    if (scenario.field.sides != FieldSides::wall && radius >= scenario.field.half_width) {
        refuse(scenario, found, {"structure.profile_m", "field.half_width_m"},
               "the structure's waterline radius of {:.4g} m does not fit between the ice sheets at "
               "<field.half_width_m>; widen the field or make the structure slimmer",
               radius);
    }
    if (structure.start + ahead > scenario.field.begin + length_rounding) {
        refuse(scenario, found, {"structure.start_m", "field.begin_m"},
               "<structure.start_m> puts the structure's waterline to x = {:.4g} m, inside the ice that begins at "
               "<field.begin_m>; start before {:.4g}",
               structure.start + ahead, scenario.field.begin - ahead);
    } else if (end + ahead < scenario.field.begin && !scenario.path.any()) {
        refuse(
            scenario, found,
            {"field.begin_m", "structure.start_m", "structure.speed_m_s", "analysis.window_s",
             "analysis.steady_start_s"},
            "the tow never reaches the ice: with <structure.start_m> and <structure.speed_m_s> the structure's "
            "waterline ends at x = {:.4g} m after {:.6g} s, before <field.begin_m>; start nearer, tow faster or longer",
            end + ahead, duration);
    }
    if (!scenario.field.endless() && end + ahead > scenario.field_end() + length_rounding && !scenario.path.any()) {
        const bool closed = scenario.field.far_end == FarEnd::ice_sheet;
        refuse(
            scenario, found,
            {"analysis.window_s", "analysis.steady_start_s", "structure.speed_m_s", "structure.start_m", "field.floes"},
            "the tow runs {}: with <structure.start_m> and <structure.speed_m_s> the structure's waterline ends at x = "
            "{:.4g} m after {:.6g} s, past the field's end at {:.4g} m; tow for a shorter time or take more floes",
            closed ? "into the ice sheet at the far end" : "out of the ice", end + ahead, duration,
            scenario.field_end());
    }
}

void check_boundaries(const Scenario& scenario, Contradictions& found) {
    const Field& field = scenario.field;
    if (field.confining > 0 && field.sides == FieldSides::open && field.far_end == FarEnd::open) {
        refuse(scenario, found, {"field.confining_N_m", "field.sides", "field.far_end"},
               "<field.confining_N_m> needs an ice sheet that presses; close the sides or the far end, or take 0");
    }
    for (const std::string key : {"water.current_m_s", "wind.speed_m_s"}) {
        const double speed = key.starts_with("wind") ? scenario.wind.speed : scenario.water.current;
        if (speed == 0 || field.wake_radius == 0) continue;
        refuse(scenario, found, {"field.wake_radius_m", key},
               "<{}> lets no floe rest, so <field.wake_radius_m> cannot stand; take 0 for none at rest", key);
    }
}

void check_wake(const Scenario& scenario, Contradictions& found) {
    const double radius = scenario.field.wake_radius;
    if (radius == 0) return;
    double diagonal = 0;
    constexpr double larger = 1.5;  // floes of other arrangements, where outlines are drawn
    for (const FloeShape& shape : floes_of(scenario).shapes)
        diagonal = std::max(diagonal, shape.is_polygon() ? larger * 2 * reach_of(shape.outline)
                                                         : std::hypot(shape.length, shape.breadth));
    const double least = scenario.structure.shape.largest_radius() + 0.5 * diagonal;
    if (radius < least) {
        refuse(scenario, found, {"field.wake_radius_m", "structure.profile_m", "floe.length_m", "floe.breadth_m"},
               "<field.wake_radius_m> lets the structure strike a floe at rest, whose middle may be {:.4g} m from its "
               "axis then; take more than that, or 0 for none at rest",
               least);
    }
}

namespace {

/// A floe of a law or an outline that fits into the channel in no direction.
void check_widest(const Scenario& scenario, Contradictions& found) {
    const FloeSet floes = floes_of(scenario);
    double widest = 0;
    for (std::size_t i = 0; i < floes.size(); ++i)
        widest = std::max(widest, std::min(floes.shape(i).length, floes.shape(i).breadth));
    const double room = 2 * (scenario.field.half_width - scenario.arrangement.clearance);
    if (widest <= room) return;
    refuse(scenario, found, {"field.half_width_m", "sizes.law", "shapes.file"},
           "<field.half_width_m> leaves {:.4g} m for floes, and one is {:.4g} m wide where it is narrowest; widen the "
           "field or take smaller floes",
           room, widest);
}

}  // namespace

void check_lattice(const Scenario& scenario, Contradictions& found) {
    // Cells fit at any concentration.
    if (scenario.arrangement.given() || scenario.shapes.kind == ShapeKind::voronoi) return;
    const double clearance = scenario.arrangement.clearance;
    const auto fitting = [&](double room, double side) {
        return std::max(0.0, std::floor((room - clearance) / (side + clearance) + length_rounding));
    };
    FloeShape cell = scenario.floe;
    if (sizes_may_differ(scenario)) {
        if (found.empty()) check_widest(scenario, found);
        if (scenario.arrangement.method != ArrangementMethod::lattice) return;  // such floes need no lattice
        cell.length = cell.breadth = 0;
        for (const FloeShape& shape : floe_sizes(scenario)) {
            cell.length = std::max(cell.length, shape.length);
            cell.breadth = std::max(cell.breadth, shape.breadth);
        }
    }
    const double rows = fitting(2 * scenario.field.half_width, cell.breadth);
    const double columns = fitting(scenario.field_length(), cell.length);
    if (rows * columns >= scenario.field.floes) return;
    refuse(scenario, found,
           {"field.concentration_percent", "arrangement.clearance_m", "field.half_width_m", "field.floes",
            "floe.length_m", "floe.breadth_m"},
           "<field.concentration_percent> cannot hold <field.floes> with <arrangement.clearance_m>: the field of "
           "{:.4g} m x {:.4g} m has room for {} rows of {}; lower the concentration or the clearance, or change the "
           "width so that whole rows fit",
           scenario.field_length(), 2 * scenario.field.half_width, rows, columns);
}

void check_given_floes(const Scenario& scenario, Contradictions& found) {
    const ArrangementRule& rule = scenario.arrangement;
    const std::vector<std::string> keys{"arrangement.columns", "arrangement.poses", "arrangement.file"};
    if (rule.columns.empty()) {
        const auto longer = std::ranges::find_if(rule.values, [](const auto& values) { return !values.empty(); });
        if (longer == rule.values.end()) return;
        refuse(
            found, keys,
            "arrangement.poses[{}] has more than x_m, z_m and yaw_deg; name what follows them in arrangement.columns",
            longer - rule.values.begin());
        return;
    }
    if (rule.method != ArrangementMethod::file || rule.poses.empty()) {
        refuse(scenario, found, keys,
               "<arrangement.columns> needs arrangement.method = \"file\" and poses with these columns");
        return;
    }
    try {
        const FloeSet floes = floes_of(scenario);
        std::set<std::pair<std::size_t, std::size_t>> kinds;
        Scenario alike = scenario;
        alike.arrangement = {};  // a copy of the poses for each kind of floe would take too long
        alike.arrangement.method = ArrangementMethod::file;
        for (std::size_t i = 0; i < floes.size(); ++i) {
            if (!kinds.emplace(floes.floes[i].shape, floes.floes[i].material).second) continue;
            alike.floe = floes.shape(i);
            alike.ice = floes.material(i).ice;
            alike.joint = floes.material(i).joint;
            Contradictions of_floe;
            check_sides(alike, of_floe);
            check_floating(alike, of_floe);
            check_proportions(alike, of_floe);
            for (Contradiction& one : of_floe) {
                one.sentence = fmt::format("floe {}: {}", i, one.sentence);
                found.push_back(std::move(one));
            }
        }
        check_element_count(scenario, element_count(floes), found);
    } catch (const InputError& fault) {
        found.push_back({keys, fault.what()});
    }
}

void check_poses(const Scenario& scenario, Contradictions& found) {
    const std::vector<PlanarPose>& poses = scenario.arrangement.poses;
    if (scenario.arrangement.method != ArrangementMethod::file) {
        if (poses.empty()) return;
        refuse(scenario, found, {"arrangement.method", "arrangement.poses", "arrangement.file"},
               "<arrangement.method> does not use arrangement.poses; write arrangement.method = \"file\" or leave the "
               "poses out");
        return;
    }
    if (poses.empty()) {
        refuse(scenario, found, {"arrangement.method", "arrangement.poses", "arrangement.file"},
               "<arrangement.method> needs poses; give arrangement.file or arrangement.poses");
        return;
    }
    if (poses.size() != static_cast<std::size_t>(scenario.field.floes)) {
        refuse(scenario, found, {"field.floes", "arrangement.poses", "arrangement.file"},
               "<field.floes> is not the number of poses given, {}; make them agree", poses.size());
    }
}

}  // namespace floes
