// Every two kinds of floes, sizes, hull, water, solver, joints, far end, moorings and way together: a tow of 20 steps,
// or a refusal that docs/limits.md lists.

#include <gtest/gtest.h>

#include <fstream>
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
     {"traced floes", "shapes.kind = 'file'\nshapes.file = 'traced.csv'\nshapes.scale = 1\n"}},
    {{"one size", ""},
     {"sizes by a law",
      "sizes.law = 'lognormal'\nsizes.mean_m = 0.6\nsizes.cov = 0.2\nsizes.smallest_m = 0.4\nsizes.largest_m = 0.8\n"}},
    {{"a cone", "structure.profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]\n"},
     {"a barge",
      "hull.shape = 'barge'\nhull.length_m = 1.2\nhull.beam_m = 0.6\nhull.draught_m = 0.2\nhull.freeboard_m = "
      "0.1\nhull.stem_deg = 45\n"},
     {"four legs",
      "hull.shape = 'four_legs'\nhull.diameter_m = 0.3\nhull.spacing_m = 0.9\nhull.draught_m = 0.4\nhull.freeboard_m = "
      "0.15\n"}},
    {{"the flow round the structure", ""},
     {"still water", "water.flow = 'still'\n"},
     {"a current", "water.current_m_s = 0.05\nwater.turning_deg = 20\n"},
     {"water by shares", "water.heave_damping_from = 'share'\nwater.added_mass_from = 'share'\n"}},
    {{"the direct solver", ""},
     {"lanes", "general.solver = 'lanes'\ncontact.preset = 'paper'\n"},
     {"Bullet's solver", "general.solver = 'stock'\ncontact.preset = 'paper'\n"}},
    {{"usual joints", ""},
     {"cracks by stress", "joint.failure = 'stress'\n"},
     {"joints by moment", "joint.failure = 'moment'\n"},
     {"joints by Σ", "joint.model = 'cfm'\n"}},
    {{"an ice sheet at the far end", "field.far_end = 'ice_sheet'\n"},
     {"an open far end", "field.far_end = 'open'\n"},
     {"a field without end", "field.far_end = 'never'\n"},
     {"a line load", "field.far_end = 'ice_sheet'\nfield.confining_N_m = 20\n"}},
    {{"a towed structure", ""},
     {"moorings",
      "moorings.mass_t = 0.5\nmoorings.gyration_m = 0.44\nmoorings.surge_kN_m = 0.8\nmoorings.sway_kN_m = 0.8\n"
      "moorings.yaw_kN_m_rad = 0.3\n"},
     {"a hull that floats",
      "moorings.free = ['surge', 'sway', 'yaw', 'heave', 'pitch', 'roll']\nmoorings.mass_t = 0.5\n"
      "moorings.gyration_m = 0.44\nmoorings.gyration_pitch_m = 0.4\nmoorings.gyration_roll_m = 0.4\n"
      "moorings.centre_m = -0.3\nmoorings.surge_kN_m = 0.8\nmoorings.sway_kN_m = 0.8\nmoorings.yaw_kN_m_rad = 0.3\n"
      "moorings.hanging_lines = [[0.6, -0.2, 0.0, 0.0, 3.0, 1.0, 3.2, 5.0, 10.0, 0.5, 0.0]]\n"}},
    {{"a straight way", ""}, {"a path", "path.legs = [[0.0, 0.1, 10.0, 0.0], [20.0, 0.1, 10.0, 1.0]]\n"}}};

constexpr const char* common =
    "campaign.seed = 1\nfield.floes = 8\nfield.concentration_percent = 60\nfield.begin_m = 1.4\n"
    "field.half_width_m = 1.25\nstructure.start_m = 0.7\nstructure.speed_m_s = 0.1\nanalysis.steady_start_s = 1\n"
    "analysis.window_s = 10\nanalysis.segments = 1\nice.elastic_modulus_MPa = 60\n";

/// Two outlines, one of them bent inwards a little, as images have them.
std::string traced(const std::string&) {
    return "floe,x,y\n1,0,0\n1,0.7,0\n1,0.7,0.5\n1,0.35,0.49\n1,0,0.5\n2,1,0\n2,1.6,0.1\n2,1.3,0.6\n";
}

/// With other solvers than the direct one joints follow Σ and water moves by shares, unless the pair says otherwise.
std::string text_with(const std::vector<std::size_t>& chosen) {
    std::string text = common;
    if (chosen[4] > 0 && chosen[5] == 0) text += "joint.model = 'cfm'\n";
    if (chosen[4] > 0 && chosen[3] != 3)
        text += "water.heave_damping_from = 'share'\nwater.added_mass_from = 'share'\n";
    for (std::size_t k = 0; k < choices.size(); ++k) text += choices[k][chosen[k]].keys;
    return text;
}

/// What refuses them; empty if 20 steps were computed.
std::string refusal(const std::string& text) {
    try {
        const Campaign campaign = read_campaign({text, "pair.toml", {}, true}, traced);
        const Scenario& scenario = campaign.cases.front().scenario;
        LaidField laid = lay_field(scenario, 1, 0);
        Simulation simulation(scenario, laid.laid(), std::move(laid.ahead));
        for (int step = 0; step < 20; ++step) simulation.step();
        for (const BodyState& state : simulation.element_states())
            EXPECT_TRUE(state.position.allFinite() && state.velocity.allFinite()) << text;
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// Of "file:line: keys: reason; what to take".
std::string reason_of(const std::string& sentence) {
    const std::size_t end = sentence.rfind("; ");
    const std::size_t begin = sentence.rfind(": ", end);
    return begin == std::string::npos || end == std::string::npos ? sentence
                                                                  : sentence.substr(begin + 2, end - begin - 2);
}

/// The reasons that the page lists: the first cells of its table.
std::set<std::string> listed_reasons() {
    std::ifstream page(FLOES_SOURCE_DIR "/docs/limits.md");
    std::set<std::string> reasons;
    bool here = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) here = line == "## Together";
        const std::size_t end = line.find(" | ");
        if (here && line.starts_with("| ") && !line.starts_with("| because") && end != std::string::npos)
            reasons.insert(line.substr(2, end - 2));
    }
    return reasons;
}

TEST(Pairs, RunOrAreRefusedAsThePageOfLimitsSays) {
    const std::set<std::string> listed = listed_reasons();
    std::set<std::vector<std::size_t>> tried;
    std::set<std::string> met;
    int ran = 0;
    for (std::size_t one = 0; one < choices.size(); ++one)
        for (std::size_t other = one + 1; other < choices.size(); ++other)
            for (std::size_t i = 0; i < choices[one].size(); ++i)
                for (std::size_t k = 0; k < choices[other].size(); ++k) {
                    std::vector<std::size_t> chosen(choices.size(), 0);
                    chosen[one] = i;
                    chosen[other] = k;
                    if (!tried.insert(chosen).second) continue;
                    const std::string said = refusal(text_with(chosen));
                    ran += said.empty() ? 1 : 0;
                    if (said.empty()) continue;
                    met.insert(reason_of(said));
                    EXPECT_TRUE(listed.contains(reason_of(said)))
                        << choices[one][i].name << " with " << choices[other][k].name
                        << " is refused, and docs/limits.md does not say so: " << said;
                }
    EXPECT_EQ(met, listed) << "docs/limits.md has what is refused no more";
    EXPECT_GT(ran, 150);
}

}  // namespace pairs_test
}  // namespace floes
