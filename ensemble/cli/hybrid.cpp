// floes hybrid: the load by Lindqvist, by KPR and by the hybrid of both over the elastic modulus (Eqs. (6)-(7), Fig.
// 8).

#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/terminal.hpp"
#include "core/units.hpp"
#include "driver/plate_moduli.hpp"
#include "findings/hybrid.hpp"

namespace floes {
namespace {

struct HybridOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> moduli{1, 2, 5, 10, 20, 30, 60, 100, 200, 500, 1000};
    double crossing = 10;  // MPa, Fig. 8
    std::vector<double> coefficients;
    std::string format = "table";
};

Scenario scenario_of(const HybridOptions& options) {
    if (options.config.empty()) return Scenario{};
    Campaign campaign = load_campaign(options.config, options.overrides);
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

std::string answer(const HybridOptions& options) {
    const Scenario scenario = scenario_of(options);
    std::vector<double> moduli;
    for (const double modulus : options.moduli) moduli.push_back(modulus * unit::megapascal);
    const HybridCurve curve = hybrid_curve(scenario, model_of(options, scenario), moduli);
    return written({hybrid_section(curve)}, options.format);
}

}  // namespace

void add_hybrid(CommandLine& line) {
    auto options = std::make_shared<HybridOptions>();
    Verb verb = line.verb("hybrid",
                          "Load by closed formulas over the elastic modulus: Lindqvist, KPR and their hybrid (Fig. 8)");
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
    add_format(verb, options->format);
    verb.footer(
        "R_LS is the load that breaks the floes (Lindqvist times concentration), R_LM the load that pushes them\n"
        "aside (KPR), R_F the lower of the two. No available source gives KPR's coefficients: k1 is set by the\n"
        "crossing, so the crossing is no test.\n\n"
        "  floes hybrid                                   the paper's case\n"
        "  floes hybrid table3.toml --set ice.bending_strength_kPa=50 --format json");
    verb.runs([options] {
        std::fputs(answer(*options).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
