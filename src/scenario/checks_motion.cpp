// Contradictions of paths and moorings.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

constexpr double rounding = 1e-9;  // m

void refuse(Contradictions& found, std::vector<std::string> keys, std::string sentence) {
    found.push_back({std::move(keys), std::move(sentence)});
}

void check_legs(const Scenario& scenario, Contradictions& found) {
    const Path& path = scenario.path;
    if (!path.table.empty()) {
        refuse(found, {"path.places", "path.legs"},
               fmt::format("path.legs and path.places are two paths; leave one out"));
        return;
    }
    const double shortest = std::ranges::min(path.legs, {}, &PathLeg::time).time;
    if (path.ramp > shortest) {
        refuse(found, {"path.ramp_s", "path.legs"},
               fmt::format("{} is longer than the shortest leg, {:g} s; take at most that",
                           given(scenario, "path.ramp_s"), shortest));
    }
    if (path.of == PathOf::ice && path.bow == PathBow::ahead) {
        refuse(found, {"path.bow", "path.of"},
               fmt::format(
                   "path.bow = \"ahead\" turns the structure with the heading, and path.of = \"ice\" has it stand; "
                   "take path.bow = \"unturned\""));
    }
}

void check_table(const std::vector<PathPoint>& table, Contradictions& found) {
    const auto wrong = [&](std::size_t row, const std::string& what) {
        refuse(found, {"path.places"}, fmt::format("path.places[{}] {}", row, what));
    };
    const PathPoint& first = table.front();
    if (first.time != 0 || first.x != 0 || first.z != 0)
        wrong(0, "is not at time 0 at the start; begin with [0, 0, 0, yaw], since places are from the start");
    for (std::size_t row = 1; row < table.size(); ++row) {
        if (table[row].time > table[row - 1].time) continue;
        wrong(row, fmt::format("is at {:g} s, not after the row before at {:g} s; times have to rise", table[row].time,
                               table[row - 1].time));
        return;
    }
}

/// Where on its way the structure is not between the banks and the ends of the channel.
void check_way(const Scenario& scenario, const std::vector<PathPlace>& places, Contradictions& found) {
    const std::string key = scenario.path.legs.empty() ? "path.places" : "path.legs";
    const double radius = scenario.structure.shape.largest_radius();
    const double step = scenario.general.time_step;
    const double begin = scenario.structure.start - rounding;
    const bool endless = scenario.field.endless();
    const double end = endless ? std::numeric_limits<double>::infinity() : scenario.field_end() + rounding;
    bool meets = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const PathPlace& place = places[k];
        const double x = scenario.structure.start + place.pose.x;
        const double time = step * static_cast<double>(k);
        const auto stop = [&](const std::string& what) { refuse(found, {key}, what); };
        meets = meets || x + radius >= scenario.field.begin;
        if (std::abs(place.pose.z) + radius > scenario.field.half_width + rounding)
            return stop(
                fmt::format("the path takes the structure, of radius {:.4g} m, to z = {:.4g} m after {:.6g} s, "
                            "into the bank at {}; turn earlier or widen the field",
                            radius, place.pose.z, time, given(scenario, "field.half_width_m")));
        if (x + radius > end || x < begin)
            return stop(
                fmt::format("the path leaves the channel: after {:.6g} s the axis is at x = {:.4g} m, and it "
                            "has to stay {} {}{}",
                            time, x, endless ? "ahead of" : "from", given(scenario, "structure.start_m"),
                            endless ? std::string("; begin with a leg along +x")
                                    : fmt::format(" to {:.4g} m; take a shorter way or more floes", end - radius)));
        const double speed = place.velocity.norm() + radius * std::abs(place.turning);
        if (speed >= scenario.general.runaway_speed)
            return stop(
                fmt::format("the path moves the structure's wall at {:.4g} m/s at {:.6g} s, not below {}; give "
                            "turns time, by path.ramp_s or more rows",
                            speed, time, given(scenario, "general.runaway_speed_m_s")));
    }
    if (!meets)
        refuse(found, {key, "structure.start_m", "field.begin_m"},
               fmt::format("the path never reaches the ice that begins at {}; start nearer or go farther",
                           given(scenario, "field.begin_m")));
}

void check_lines(const Scenario& scenario, Contradictions& found) {
    const Moorings& moorings = scenario.moorings;
    const std::vector<TensionPoint>& curve = moorings.curve;
    if (!curve.empty()) {
        if (moorings.lines.empty())
            refuse(found, {"moorings.line_curve", "moorings.lines"},
                   fmt::format(
                       "moorings.line_curve is of moorings.lines, and there are none; give lines or leave it out"));
        if (curve.size() < 2)
            refuse(found, {"moorings.line_curve"},
                   fmt::format("moorings.line_curve has one row; two or more are a curve"));
        for (std::size_t row = 1; row < curve.size(); ++row) {
            if (curve[row].extension > curve[row - 1].extension && curve[row].tension > curve[row - 1].tension)
                continue;
            refuse(found, {"moorings.line_curve"},
                   fmt::format("moorings.line_curve[{}] does not have more extension and more tension than the row "
                               "before; both have to rise",
                               row));
            break;
        }
    }
    for (std::size_t row = 0; row < moorings.lines.size(); ++row) {
        const MooringLine& line = moorings.lines[row];
        const auto wrong = [&](const std::string& what) {
            refuse(found, {"moorings.lines", "moorings.line_curve"}, fmt::format("moorings.lines[{}] {}", row, what));
        };
        if (!curve.empty() && line.stiffness > 0)
            wrong("has a stiffness beside moorings.line_curve; make it 0 or leave the curve out");
        if (curve.empty() && line.stiffness == 0) wrong("has no stiffness; give it one or moorings.line_curve");
        if (curve.size() > 1 && line.pretension < curve.front().tension)
            wrong(fmt::format("has a pretension of {:g} kN, below the {:g} kN where moorings.line_curve begins",
                              line.pretension / 1e3, curve.front().tension / 1e3));
        if (curve.size() > 1 && line.pretension > curve.back().tension)
            wrong(fmt::format("has a pretension of {:g} kN, above the {:g} kN where moorings.line_curve ends",
                              line.pretension / 1e3, curve.back().tension / 1e3));
        if (line.break_load > 0 && line.pretension > line.break_load)
            wrong(fmt::format("breaks at {:g} kN, below its pretension of {:g} kN", line.break_load / 1e3,
                              line.pretension / 1e3));
    }
}

void check_turret(const Moorings& moorings, Contradictions& found) {
    const std::vector<TensionPoint>& curve = moorings.turret_curve;
    if (curve.empty()) return;
    const auto wrong = [&](std::size_t row, const char* what) {
        refuse(found, {"moorings.turret_curve"}, fmt::format("moorings.turret_curve[{}] {}", row, what));
    };
    if (curve.size() < 2) return wrong(0, "is the only row; two or more are a curve");
    if (curve.front() != TensionPoint{})
        return wrong(0, "is not [0, 0], where the mooring is at rest; begin with that");
    for (std::size_t row = 1; row < curve.size(); ++row) {
        if (curve[row].extension > curve[row - 1].extension && curve[row].tension > curve[row - 1].tension) continue;
        return wrong(row, "does not have more offset and more force than the row before; both have to rise");
    }
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
        refuse(found, {limit, gain},
               fmt::format("{} limits thrusters that {} = 0 leaves out; give both or neither", given(scenario, limit),
                           gain));
    }
}

/// The load of a step moves the structure in the next: right while the ice that it strikes is light beside it.
void check_mass(const Scenario& scenario, Contradictions& found) {
    constexpr double least = 10;
    const double ratio = structure_over_floe(scenario);
    if (ratio >= least) return;
    refuse(found, {"moorings.mass_t", "floe.length_m"},
           fmt::format("{} and the water that moves with it are {:.4g} times the heaviest floe, and {:g} times is the "
                       "least: a floe that strikes the structure would push it {:.2g} % too hard, since the structure "
                       "moves after each step only; take smaller floes or moorings.mass_t = 0",
                       given(scenario, "moorings.mass_t"), ratio, least, 100 / ratio));
}

void check_periods(const Scenario& scenario, Contradictions& found) {
    constexpr double fewest_steps = 50;
    constexpr std::array words{"surge", "sway", "yaw"};
    const Moorings& moorings = scenario.moorings;
    const Vec3 periods = moorings.periods();
    for (int k = 0; k < moorings.directions(); ++k) {
        const char* const word = words.at(static_cast<std::size_t>(k));
        if (!std::isfinite(periods[k])) {
            refuse(
                found, {"moorings.free", "moorings.lines"},
                fmt::format("nothing holds the structure in {}; give a stiffness, lines or thrusters that hold it, or "
                            "take a moorings.free without {}",
                            word, word));
        } else if (periods[k] < fewest_steps * scenario.general.time_step) {
            refuse(found, {"moorings.mass_t", "general.time_step_s"},
                   fmt::format("the moored structure's natural period in {} is {:.4g} s, fewer than {:g} steps "
                               "of {}; take softer moorings, a shorter step or moorings.mass_t = 0",
                               word, periods[k], fewest_steps, given(scenario, "general.time_step_s")));
        }
    }
}

}  // namespace

double structure_over_floe(const Scenario& scenario) {
    const FloeSet floes = floes_of(scenario);
    double heaviest = 0;
    for (std::size_t i = 0; i < floes.size(); ++i)
        heaviest = std::max(heaviest, floes.shape(i).elements() * floes.shape(i).element_mass(floes.material(i).ice));
    const Vec3 inertia = scenario.moorings.inertia();
    return std::min(inertia.x(), inertia.y()) / heaviest;
}

void check_path(const Scenario& scenario, Contradictions& found) {
    const Path& path = scenario.path;
    if (!path.any()) return;
    const std::size_t before = found.size();
    if (!path.legs.empty()) check_legs(scenario, found);
    if (!path.table.empty()) check_table(path.table, found);
    if (found.size() == before) check_way(scenario, scenario.places(), found);
}

void check_moorings(const Scenario& scenario, Contradictions& found) {
    const Moorings& moorings = scenario.moorings;
    if (!moorings.give_way()) return;
    const std::size_t before = found.size();
    check_lines(scenario, found);
    check_turret(moorings, found);
    check_thrusters(scenario, found);
    if (moorings.free == FreeMotion::all && moorings.inertia()[2] == 0) {
        refuse(found, {"moorings.gyration_m", "moorings.free"},
               fmt::format("moorings.gyration_m = 0 leaves nothing to turn; give the radius of gyration, or take "
                           "moorings.free = \"surge_sway\""));
    }
    if (scenario.path.any() && scenario.path.bow == PathBow::ahead && !scenario.path.legs.empty()) {
        refuse(found, {"path.bow", "moorings.mass_t"},
               fmt::format("path.bow = \"ahead\" would turn the moorings with the heading; take \"unturned\""));
    }
    if (std::ranges::any_of(scenario.path.table, [](const PathPoint& at) { return at.yaw != 0; })) {
        refuse(
            found, {"path.places", "moorings.mass_t"},
            fmt::format("path.places has yaw, which would turn the moorings; make it 0, the structure yaws by itself"));
    }
    if (found.size() > before) return;
    check_mass(scenario, found);
    check_periods(scenario, found);
}

}  // namespace floes
