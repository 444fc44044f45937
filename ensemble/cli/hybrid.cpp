// floes hybrid: the load by Lindqvist, by KPR and by the hybrid of both over the elastic modulus (Eqs. (6)-(7), Fig.
// 8), and that of level ice by ISO 19906.

#include <algorithm>
#include <iostream>
#include <utility>

#include "cli/commands.hpp"
#include "findings/closed_formulas.hpp"
#include "run/calibrate.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace {

struct HybridOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> moduli{1, 2, 5, 10, 20, 30, 60, 100, 200, 500, 1000};
    double crossing = 10;  // MPa, Fig. 8
    std::vector<double> coefficients;
    std::optional<double> rubble_height;
    std::optional<double> rubble_angle;
    std::optional<double> ice_friction;
    Rubble rubble;
    double friction_angle = 45;  // degrees
    double cohesion = 0;         // kPa
    double strength = 2.2;       // MPa
    bool strength_given = false;
    std::string format = "table";
};

Scenario scenario_of(const HybridOptions& options, std::string& taken) {
    if (options.config.empty()) return Scenario{};
    Campaign campaign = load_campaign(options.config, options.overrides);
    if (const std::size_t cases = campaign.cases.size(); cases > 1)
        taken = fmt::format("Ice and structure are those of {}, the first of the {} cases of {}.\n",
                            campaign.cases.front().name, cases, options.config);
    campaign.cases.resize(1);
    Progress progress(std::cerr, style_of_standard_error());
    settle_moduli(campaign, 1, progress);
    return campaign.cases.front().scenario;
}

HybridModel model_of(const HybridOptions& options, const Scenario& scenario) {
    const HybridModel model = hybrid_model(scenario);
    const std::vector<double>& k = options.coefficients;
    return k.empty() ? model.crossing_at(options.crossing * unit::megapascal) : model.with({k[0], k[1], k[2]});
}

SlopingRequest sloping_of(const HybridOptions& options, const Scenario& scenario) {
    const Rubble standard = rubble_on(scenario);
    Rubble rubble = options.rubble;  // its porosity
    rubble.height = options.rubble_height.value_or(standard.height);
    rubble.angle = options.rubble_angle ? *options.rubble_angle * unit::degree : standard.angle;
    rubble.ice_friction = options.ice_friction.value_or(standard.ice_friction);
    rubble.friction_angle = options.friction_angle * unit::degree;
    rubble.cohesion = options.cohesion * unit::kilopascal;
    return {rubble, options.strength * unit::megapascal};
}

/// What a region's C_R is not for: ice that is scaled down with its structure.
std::string strength_words(const HybridOptions& options, const Scenario& scenario) {
    constexpr double much = 5;
    const double own = scenario.ice.compressive_strength / unit::megapascal;
    if (options.strength_given || options.strength <= much * own) return {};
    return fmt::format(
        "That C_R is of sea ice at full scale, and {} is not: its crushing load is far less; give its own C_R with "
        "--crushing-MPa.\n",
        given(scenario, "ice.compressive_strength_kPa"));
}

std::string answer(const HybridOptions& options) {
    std::string taken;
    const Scenario scenario = scenario_of(options, taken);
    std::vector<double> moduli;
    for (const double modulus : options.moduli) moduli.push_back(modulus * unit::megapascal);
    const HybridCurve curve = hybrid_curve(scenario, model_of(options, scenario), moduli);
    const SlopingRequest sloping = sloping_of(options, scenario);
    const Units units(std::ranges::max(curve.points, {}, &HybridPoint::load).load);
    Section hybrid = hybrid_section(curve);
    hybrid.before = taken + hybrid.before;
    Section level = sloping_section(scenario, moduli, sloping, units);
    level.after += strength_words(options, scenario);
    return written({std::move(hybrid), std::move(level)}, options.format, units);
}

/// What ISO's formulas need and a configuration does not have.
Option add_rubble(Verb& verb, HybridOptions& options) {
    verb.option("--rubble-m", options.rubble_height,
                "Height of the rubble on the wall above the water, m; default: three thicknesses, as in the example of "
                "OpenFAST's IceFloe, like the next three");
    verb.option("--rubble-porosity", options.rubble.porosity, "Its porosity").shows_default();
    verb.option("--rubble-deg", options.rubble_angle,
                "Angle of its surface from the horizontal; default: 40, or the wall's where that is smaller");
    verb.option("--rubble-friction-deg", options.friction_angle, "Its angle of internal friction").shows_default();
    verb.option("--rubble-cohesion-kPa", options.cohesion, "Its cohesion; 0 is of loose blocks").shows_default();
    verb.option("--rubble-ice-friction", options.ice_friction,
                "Friction of the sheet on it; default: contact.ice_ice_friction");
    return verb
        .option("--crushing-MPa", options.strength,
                "C_R, the strength of a region's ice that crushes on a vertical wall 1 m high and wide; take that of "
                "your site from ISO 19906")
        .within(0.1, 50.0)
        .shows_default();
}

}  // namespace

void add_hybrid(CommandLine& line) {
    auto options = std::make_shared<HybridOptions>();
    Verb verb = line.verb(
        "hybrid", "Load by closed formulas over the elastic modulus: Lindqvist, KPR, their hybrid (Fig. 8), ISO 19906");
    Option config = verb.option("config", options->config,
                                "Use ice and structure of this configuration's first case; default: the paper's");
    add_overrides(verb, options->overrides).needs(config);
    verb.option("--modulus-MPa", options->moduli, "Elastic moduli, MPa, comma-separated")
        .comma_separated()
        .within(1e-3, 1e6);
    Option crossing =
        verb.option("--crossing-MPa", options->crossing,
                    "Choose KPR's static coefficient so that both limits are equal at this modulus; the paper's "
                    "Fig. 8 shows about 10")
            .within(1e-3, 1e6)
            .shows_default();
    verb.option("--kpr", options->coefficients, "KPR's coefficients k1,k2,k3, instead of the crossing")
        .comma_separated()
        .exactly(3)
        .not_negative()
        .excludes(crossing);
    const Option strength = add_rubble(verb, *options);
    add_format(verb, options->format);
    verb.footer(
        "R_LS is the load that breaks the floes (Lindqvist times concentration), R_LM the load that pushes them\n"
        "aside (KPR), R_F the lower of the two. No available source gives KPR's coefficients: k1 is set by the\n"
        "crossing, so the crossing is no test.\n\n"
        "Below them stands the load of level ice without an end by ISO 19906: on a sloping wall by Croasdale and\n"
        "Cammaert (1994) - breaking the sheet H_B, pushing it through rubble H_P, lifting rubble H_L, pushing blocks\n"
        "up the wall H_R, turning them at its top H_T - and by crushing on a vertical wall.\n\n"
        "These are of a sheet that is wide against its thickness and goes on coming, not of floes: no concentration\n"
        "is in them. That of the slope was 1.6 times what was measured at the Confederation Bridge (OTC 27385).\n\n"
        "  floes hybrid                                   the paper's case\n"
        "  floes hybrid full_scale.toml --rubble-m 4 --modulus-MPa 5000\n"
        "  floes hybrid table3.toml --set ice.bending_strength_kPa=50 --format json");
    verb.prints([options, strength] {
        options->strength_given = strength.given();
        return answer(*options);
    });
}

}  // namespace floes
