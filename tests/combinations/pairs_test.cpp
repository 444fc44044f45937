// Every two kinds of floes, sizes, hull, water, solver, joints, far end, moorings and way together: a tow of 20 steps, or
// a refusal that docs/limits.md lists.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "campaign/read.hpp"
#include "core/error.hpp"
#include "simulation/simulation.hpp"

namespace floes {
namespace pairs_test {

struct Option {
    std::string name;
    std::string keys;
};

/// The first of each is what goes with the others' options.
const std::vector<std::vector<Option>> choices{
    {{"rectangles", ""},
     {"polygons", "shapes.kind = 'polygon'\nshapes.corners = 6\n"},
     {"cells", "shapes.kind = 'voronoi'\n"},
     {"traced floes", "shapes.kind = 'file'\nshapes.file = 'traced.csv'\n"}},
    {{"one size", ""}, {"sizes by a law", "sizes.law = 'lognormal'\nsizes.mean_m = 0.6\nsizes.cv_percent = 20\n"}},
    {{"a cone", "structure.profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]\n"},
     {"a barge", "hull.shape = 'barge'\nhull.length_m = 1.2\nhull.breadth_m = 0.6\nhull.draught_m = 0.2\n"},
     {"four legs", "hull.shape = 'four_legs'\nhull.diameter_m = 0.3\nhull.spacing_m = 0.9\nhull.draught_m = 0.4\n"}},
    {{"the flow round the structure", ""},
     {"still water", "water.flow = 'still'\n"},
     {"a current", "water.current_m_s = 0.05\nwater.turning_deg = 20\n"},
     {"water by shares", "water.heave_damping_from = 'share'\nwater.added_mass_from = 'share'\n"}},
    {{"the direct solver", ""},
     {"lanes", "general.solver = 'lanes'\ngeneral.iterations = 50\n"},
     {"Bullet's solver", "general.solver = 'stock'\ngeneral.iterations = 50\n"}},
    {{"cracks by stress", ""},
     {"joints by moment", "joint.failure = 'moment'\n"},
     {"joints by Σ", "joint.model = 'cfm'\n"}},
    {{"an ice sheet at the far end", "field.far_end = 'ice_sheet'\n"},
     {"an open far end", "field.far_end = 'open'\n"},
     {"a field without end", "field.far_end = 'never'\n"},
     {"a line load", "field.far_end = 'ice_sheet'\nfield.confining_N_m = 20\n"}},
    {{"a towed structure", ""},
     {"moorings",
      "moorings.mass_t = 0.2\nmoorings.gyration_m = 0.44\nmoorings.surge_kN_m = 0.8\nmoorings.sway_kN_m = 0.8\n"
      "moorings.yaw_kN_m_rad = 0.3\n"}},
    {{"a straight way", ""}, {"a path", "path.legs = [[0.0, 0.1, 10.0, 0.0], [20.0, 0.1, 10.0, 1.0]]\n"}}};

constexpr const char* common =
    "campaign.seed = 1\nfield.floes = 8\nfield.concentration_percent = 60\nfield.begin_m = 1.4\n"
    "field.half_width_m = 1.25\nstructure.start_m = 1.2\nstructure.speed_m_s = 0.1\nanalysis.steady_start_s = 1\n"
    "analysis.window_s = 10\nanalysis.segments = 1\nice.elastic_modulus_MPa = 60\n";

/// Two outlines, one of them bent inwards a little, as images have them.
std::string traced(const std::string&) {
    return "floe,x,z\n1,0,0\n1,0.7,0\n1,0.7,0.5\n1,0.35,0.49\n1,0,0.5\n2,0,0\n2,0.6,0.1\n2,0.3,0.6\n";
}

std::string text_with(const std::vector<std::size_t>& chosen) {
    std::string text = common;
    for (std::size_t k = 0; k < choices.size(); ++k) text += choices[k][chosen[k]].keys;
    return text;
}

/// What refuses them; empty if 20 steps were computed.
std::string refusal(const std::string& text) {
    try {
        const Campaign campaign = read_campaign({text, "pair.toml", {}, true}, traced);
        const Scenario& scenario = campaign.cases.front().scenario;
        auto [floes, ahead] = lay_field(scenario, 1, 0);
        Simulation simulation(scenario, floes, std::move(ahead));
        for (int step = 0; step < 20; ++step) simulation.step();
        for (const BodyState& state : simulation.element_states())
            EXPECT_TRUE(state.position.allFinite() && state.velocity.allFinite()) << text;
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string limits() {
    std::ifstream page(FLOES_SOURCE_DIR "/docs/limits.md");
    return {std::istreambuf_iterator<char>(page), {}};
}

TEST(Pairs, RunOrAreRefusedAsThePageOfLimitsSays) {
    const std::string page = limits();
    std::set<std::vector<std::size_t>> seen;
    int ran = 0;
    for (std::size_t one = 0; one < choices.size(); ++one)
        for (std::size_t other = one + 1; other < choices.size(); ++other)
            for (std::size_t i = 0; i < choices[one].size(); ++i)
                for (std::size_t k = 0; k < choices[other].size(); ++k) {
                    std::vector<std::size_t> chosen(choices.size(), 0);
                    chosen[one] = i;
                    chosen[other] = k;
                    if (!seen.insert(chosen).second) continue;
                    const std::string pair = choices[one][i].name + " with " + choices[other][k].name;
                    const std::string said = refusal(text_with(chosen));
                    const bool listed = page.find("| " + pair + " |") != std::string::npos;
                    if (said.empty()) {
                        ++ran;
                        EXPECT_FALSE(listed) << pair << " runs, and docs/limits.md says that it is refused";
                    } else {
                        EXPECT_TRUE(listed) << pair << " is refused, and docs/limits.md does not say so: " << said;
                    }
                }
    EXPECT_GT(ran, 150);
}

}  // namespace pairs_test
}  // namespace floes
