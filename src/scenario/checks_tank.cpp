// Contradictions between structure, field, floes and the length of the tow.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/sizes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

constexpr double rounding = 1e-9;  // m

void check_added_volume(const Structure& structure, Contradictions& found) {
    const double own = structure.hull_file.volume;
    if (structure.shape.kind() != HullKind::file || own == 0) return;
    const double added = structure.shape.volume() / own - 1;
    if (added <= structure.hull_file.most_added) return;
    found.push_back(
        {{"hull.most_added_percent", "hull.file"},
         fmt::format("the convex pieces of the hull fill {:.3g} % more than it, over hull.most_added_percent = {:g}; "
                     "cut the hull into bodies that are convex yourself, or allow more",
                     100 * added, 100 * structure.hull_file.most_added)});
}

}  // namespace

void check_shape(const Scenario& scenario, Contradictions& found) {
    const Structure& structure = scenario.structure;
    const bool by_profile = structure.shape.kind() == HullKind::profile;
    const std::string key = by_profile ? "structure.profile_m" : "hull.shape";
    if (const auto fault = structure.shape.fault()) {
        found.push_back({{key}, fmt::format("{} {}", given(scenario, key), *fault)});
        return;
    }
    check_added_volume(structure, found);
    const double breadth = 2 * structure.shape.waterline_radius();
    if (by_profile || breadth >= 0.5 * scenario.floe.element) return;
    found.push_back({{key, "floe.element_m"},
                     fmt::format("the structure is {:.4g} m wide at the waterline, less than half of {}; take smaller "
                                 "elements, or look at hull.unit",
                                 breadth, given(scenario, "floe.element_m"))});
}

void check_tow(const Scenario& scenario, Contradictions& found) {
    const Structure& structure = scenario.structure;
    const double radius = structure.shape.waterline_radius();
    const double ahead = structure.shape.waterline_ahead();
    const double duration = scenario.analysis.steady_start + scenario.analysis.window;
    // Ice that nothing holds drifts with the current while the structure comes.
    const double drift = scenario.field.far_end == FarEnd::open ? scenario.water.current_velocity().x() : 0;
    const double end = structure.start + (structure.speed - drift) * duration;
    const auto course = [&] {
        return fmt::format("{} and {}", given(scenario, "structure.start_m"), given(scenario, "structure.speed_m_s"));
    };
    if (structure.speed >= scenario.general.runaway_speed) {
        found.push_back(
            {{"structure.speed_m_s", "general.runaway_speed_m_s"},
             fmt::format("{} is not below {}, so ice pushed by the structure would count as run away; raise the limit",
                         given(scenario, "structure.speed_m_s"), given(scenario, "general.runaway_speed_m_s"))});
    }
    if (radius >= scenario.field.half_width) {
        found.push_back(
            {{"structure.profile_m", "field.half_width_m"},
             fmt::format(
                 "the structure's waterline radius of {:.4g} m does not fit between the ice sheets at {}; widen "
                 "the field or make the structure slimmer",
                 radius, given(scenario, "field.half_width_m"))});
    }
    if (structure.start + ahead > scenario.field.begin + rounding) {
        found.push_back(
            {{"structure.start_m", "field.begin_m"},
             fmt::format("{} puts the structure's waterline to x = {:.4g} m, inside the ice that begins at {}; start "
                         "before {:.4g}",
                         given(scenario, "structure.start_m"), structure.start + ahead,
                         given(scenario, "field.begin_m"), scenario.field.begin - ahead)});
    } else if (end + ahead < scenario.field.begin && !scenario.path.any()) {
        found.push_back(
            {{"field.begin_m", "structure.start_m", "structure.speed_m_s", "analysis.window_s",
              "analysis.steady_start_s"},
             fmt::format(
                 "the tow never reaches the ice: with {} the structure's waterline ends at x = {:.4g} m after {:.6g} "
                 "s, before {}; start nearer, tow faster or longer",
                 course(), end + ahead, duration, given(scenario, "field.begin_m"))});
    }
    if (!scenario.field.endless() && end + ahead > scenario.field_end() + rounding && !scenario.path.any()) {
        const bool closed = scenario.field.far_end == FarEnd::ice_sheet;
        found.push_back(
            {{"analysis.window_s", "analysis.steady_start_s", "structure.speed_m_s", "structure.start_m",
              "field.floes"},
             fmt::format(
                 "the tow runs {}: with {} the structure's waterline ends at x = {:.4g} m after {:.6g} s, past the "
                 "field's end at {:.4g} m; tow for a shorter time or take more floes",
                 closed ? "into the ice sheet at the far end" : "out of the ice", course(), end + ahead, duration,
                 scenario.field_end())});
    }
}

void check_boundaries(const Scenario& scenario, Contradictions& found) {
    const Field& field = scenario.field;
    if (field.confining > 0 && field.sides == FieldSides::open && field.far_end == FarEnd::open) {
        found.push_back({{"field.confining_N_m", "field.sides", "field.far_end"},
                         fmt::format("{} needs an ice sheet that presses; close the sides or the far end, or take 0",
                                     given(scenario, "field.confining_N_m"))});
    }
    for (const std::string key : {"water.current_m_s", "wind.speed_m_s"}) {
        const double speed = key.starts_with("wind") ? scenario.wind.speed : scenario.water.current;
        if (speed == 0 || field.wake_radius == 0) continue;
        found.push_back({{"field.wake_radius_m", key},
                         fmt::format("{} lets no floe rest, so {} cannot stand; take 0 for none at rest",
                                     given(scenario, key), given(scenario, "field.wake_radius_m"))});
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
        found.push_back(
            {{"field.wake_radius_m", "structure.profile_m", "floe.length_m", "floe.breadth_m"},
             fmt::format(
                 "{} lets the structure strike a floe at rest, whose middle may be {:.4g} m from its axis then; "
                 "take more than that, or 0 for none at rest",
                 given(scenario, "field.wake_radius_m"), least)});
    }
}

void check_lattice(const Scenario& scenario, Contradictions& found) {
    if (scenario.arrangement.given()) return;
    const double clearance = scenario.arrangement.clearance;
    const auto fitting = [&](double room, double side) {
        return std::max(0.0, std::floor((room - clearance) / (side + clearance) + rounding));
    };
    FloeShape cell = scenario.floe;
    if (sizes_may_differ(scenario)) {
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
    found.push_back(
        {{"field.concentration_percent", "arrangement.clearance_m", "field.half_width_m", "field.floes",
          "floe.length_m", "floe.breadth_m"},
         fmt::format(
             "{} cannot hold {} with {}: the field of {:.4g} m x {:.4g} m has room for {} rows of {}; lower the "
             "concentration or the clearance, or change the width so that whole rows fit",
             given(scenario, "field.concentration_percent"), given(scenario, "field.floes"),
             given(scenario, "arrangement.clearance_m"), scenario.field_length(), 2 * scenario.field.half_width, rows,
             columns)});
}

void check_given_floes(const Scenario& scenario, Contradictions& found) {
    const ArrangementRule& rule = scenario.arrangement;
    const std::vector<std::string> keys{"arrangement.columns", "arrangement.poses", "arrangement.file"};
    if (rule.columns.empty()) {
        const auto longer = std::ranges::find_if(rule.values, [](const auto& values) { return !values.empty(); });
        if (longer == rule.values.end()) return;
        found.push_back(
            {keys, fmt::format("arrangement.poses[{}] has more than x_m, z_m and yaw_deg; name what follows "
                               "them in arrangement.columns",
                               longer - rule.values.begin())});
        return;
    }
    if (rule.method != ArrangementMethod::file || rule.poses.empty()) {
        found.push_back({keys, fmt::format("{} needs arrangement.method = \"file\" and poses with these columns",
                                           given(scenario, "arrangement.columns"))});
        return;
    }
    try {
        const FloeSet floes = floes_of(scenario);
        std::set<std::pair<std::size_t, std::size_t>> kinds;
        Scenario alike = scenario;
        alike.arrangement = {};  // a copy of the poses for each kind of floe would take too long
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
        found.push_back(
            {{"arrangement.method", "arrangement.poses", "arrangement.file"},
             fmt::format(
                 "{} does not use arrangement.poses; write arrangement.method = \"file\" or leave the poses out",
                 given(scenario, "arrangement.method"))});
        return;
    }
    if (poses.empty()) {
        found.push_back({{"arrangement.method", "arrangement.poses", "arrangement.file"},
                         fmt::format("{} needs poses; give arrangement.file or arrangement.poses",
                                     given(scenario, "arrangement.method"))});
        return;
    }
    if (poses.size() != static_cast<std::size_t>(scenario.field.floes)) {
        found.push_back({{"field.floes", "arrangement.poses", "arrangement.file"},
                         fmt::format("{} is not the number of poses given, {}; make them agree",
                                     given(scenario, "field.floes"), poses.size())});
    }
}

}  // namespace floes
