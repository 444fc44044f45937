// Contradictions of a field without end.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/sizes.hpp"
#include "scenario/validate.hpp"

namespace floes {
namespace {

constexpr double longest_tow = 1e5;  // m: as far as the sides of the field reach
constexpr double rounding = 1e-9;    // m

const std::string far_end = "field.far_end";

/// What moves or holds ice that is to rest until the structure comes.
void check_rest(const Scenario& scenario, Contradictions& found) {
    struct Mover {
        std::string key;
        double value;
        const char* why;
    };
    for (const Mover& one :
         {Mover{"water.current_m_s", scenario.water.current, "ice ahead of the computed part rests and cannot drift"},
          Mover{"wind.speed_m_s", scenario.wind.speed, "ice ahead of the computed part rests and cannot drift"},
          Mover{"field.confining_N_m", scenario.field.confining, "no rigid sheet is as long as the field"},
          Mover{"field.wake_radius_m", scenario.field.wake_radius, "field.ahead_m already says which floes rest"}}) {
        if (one.value == 0) continue;
        found.push_back({{one.key, far_end},
                         fmt::format("{} does not go together with {}: {}; take 0, or a field with an end",
                                     given(scenario, one.key), given(scenario, far_end), one.why)});
    }
    if (scenario.general.solver == SolverKind::stock) {
        found.push_back({{"general.solver", far_end},
                         fmt::format("{} cannot let floes rest, as {} asks; take \"direct\" or \"lanes\"",
                                     given(scenario, "general.solver"), given(scenario, far_end))});
    }
}

/// The window of floes that are computed goes on with the structure and never back, and what it has left is gone.
void check_way_back(const Scenario& scenario, Contradictions& found) {
    const double room = scenario.window_behind() - window_least(scenario);
    double farthest = 0;
    double time = 0;
    for (const PathPlace& place : scenario.places()) {
        const double x = place.pose.x;
        farthest = std::max(farthest, x);
        if (farthest - x > room - rounding) {
            found.push_back(
                {{scenario.path.legs.empty() ? "path.places" : "path.legs", far_end, "field.behind_m"},
                 fmt::format("the path takes the structure back by {:.4g} m to x = {:.4g} m after {:.6g} s, "
                             "and with {} floes more than {:.4g} m behind the farthest place that it has "
                             "been to are gone, so {:.4g} m is the most; go on along +x, take a larger "
                             "field.behind_m or a field with an end",
                             farthest - x, scenario.structure.start + x, time, given(scenario, far_end),
                             scenario.window_behind(), room)});
            return;
        }
        time += scenario.general.time_step;
    }
}

void check_tiles(const Scenario& scenario, Contradictions& found) {
    const ArrangementRule& rule = scenario.arrangement;
    if (rule.method != ArrangementMethod::scattered) {
        found.push_back(
            {{"arrangement.method", far_end},
             fmt::format("{} does not go together with {}, whose parts are laid beside one another without a seam; "
                         "take \"scattered\", or a field with an end",
                         given(scenario, "arrangement.method"), given(scenario, far_end))});
    } else if (rule.ordering_sweeps > 0) {
        found.push_back({{"arrangement.ordering_sweeps", far_end},
                         fmt::format("{} would move floes that lie already, which {} does not allow; take 0, or a "
                                     "field with an end",
                                     given(scenario, "arrangement.ordering_sweeps"), given(scenario, far_end))});
    }
}

void check_window(const Scenario& scenario, Contradictions& found) {
    const double least = window_least(scenario);
    const auto check = [&](const std::string& key, double length, const char* what) {
        if (length > least) return;
        found.push_back({{key, "structure.profile_m", "field.half_width_m"},
                         fmt::format("{} is {:.4g} m, and {} nearer than the structure's radius and a floe's diagonal, "
                                     "{:.4g} m; take more",
                                     given(scenario, key), length, what, least)});
    };
    check("field.ahead_m", scenario.window_ahead(), "the structure would strike floes at rest when they are");
    check("field.behind_m", scenario.window_behind(), "floes would be taken out while they touch it when they are");
    const double towed = scenario.reach();
    if (towed + scenario.window_ahead() > longest_tow) {
        found.push_back({{"analysis.window_s", "structure.speed_m_s", "field.ahead_m"},
                         fmt::format("the tow comes {:.4g} m far and looks {:.4g} m ahead, and the sides of a field "
                                     "without end reach {:.4g} m; tow for a shorter time",
                                     towed, scenario.window_ahead(), longest_tow)});
    }
}

}  // namespace

double window_least(const Scenario& scenario) {
    double diagonal = 0;
    for (const FloeShape& shape : floe_sizes(scenario))
        diagonal = std::max(diagonal, std::hypot(shape.length, shape.breadth));
    return scenario.structure.shape.largest_radius() + diagonal;
}

void check_endless(const Scenario& scenario, Contradictions& found) {
    if (!scenario.field.endless()) return;
    check_rest(scenario, found);
    check_tiles(scenario, found);
    if (scenario.arrangement.method != ArrangementMethod::scattered) return;
    const std::size_t before = found.size();
    check_window(scenario, found);
    if (found.size() == before) check_way_back(scenario, found);
}

}  // namespace floes
