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

/// The window of floes that are computed goes straight on with the tow, and what it has left does not come back.
void check_straight(const Scenario& scenario, Contradictions& found) {
    const auto refuse = [&](const std::string& key, const std::string& what, const std::string& instead) {
        found.push_back({{key, far_end},
                         fmt::format("{} does not go together with {}: floes are computed round a structure that is "
                                     "towed straight on, and those behind it are gone; {}, or take a field with an end",
                                     what, given(scenario, far_end), instead)});
    };
    if (scenario.path.any())
        refuse(scenario.path.legs.empty() ? "path.places" : "path.legs", "a [path]", "leave the path out");
    if (scenario.moorings.give_way())
        refuse("moorings.mass_t", given(scenario, "moorings.mass_t"), "take moorings.mass_t = 0");
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
    double diagonal = 0;
    for (const FloeShape& shape : floe_sizes(scenario))
        diagonal = std::max(diagonal, std::hypot(shape.length, shape.breadth));
    const double least = scenario.structure.shape.largest_radius() + diagonal;
    const auto check = [&](const std::string& key, double length, const char* what) {
        if (length > least) return;
        found.push_back({{key, "structure.profile_m", "field.half_width_m"},
                         fmt::format("{} is {:.4g} m, and {} nearer than the structure's radius and a floe's diagonal, "
                                     "{:.4g} m; take more",
                                     given(scenario, key), length, what, least)});
    };
    check("field.ahead_m", scenario.window_ahead(), "the structure would strike floes at rest when they are");
    check("field.behind_m", scenario.window_behind(), "floes would be taken out while they touch it when they are");
    const double towed = scenario.structure.speed * (scenario.analysis.steady_start + scenario.analysis.window);
    if (towed + scenario.window_ahead() > longest_tow) {
        found.push_back({{"analysis.window_s", "structure.speed_m_s", "field.ahead_m"},
                         fmt::format("the tow comes {:.4g} m far and looks {:.4g} m ahead, and the sides of a field "
                                     "without end reach {:.4g} m; tow for a shorter time",
                                     towed, scenario.window_ahead(), longest_tow)});
    }
}

}  // namespace

void check_endless(const Scenario& scenario, Contradictions& found) {
    if (!scenario.field.endless()) return;
    check_rest(scenario, found);
    check_straight(scenario, found);
    check_tiles(scenario, found);
    if (scenario.arrangement.method == ArrangementMethod::scattered) check_window(scenario, found);
}

}  // namespace floes
