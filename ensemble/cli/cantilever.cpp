// floes cantilever: the measured strength of a numerical beam compared with its input strength.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "core/units.hpp"
#include "laboratory/cantilever.hpp"
#include "theory/beam.hpp"

namespace floes {
namespace {

struct CantileverOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> cfm{1e-10, 0.016, 0.03};
    std::vector<int> elements{1, 2, 3, 4};
    std::vector<std::string> loads{"bending", "shear", "compression"};
    double modulus = 60;
    bool floating = false;
    std::string format = "table";
};

struct Row {
    double cfm;
    BeamStrength shown;
    double elastic;  ///< expected ratio for an elastic beam of the given modulus; 1 when dry
};

BeamLoad load_of(const std::string& word) {
    if (word == "shear") return BeamLoad::shear;
    return word == "compression" ? BeamLoad::compression : BeamLoad::bending;
}

std::vector<Row> measure(const CantileverOptions& options) {
    Scenario scenario =
        options.config.empty() ? Scenario{} : load_campaign(options.config, options.overrides).cases.front().scenario;
    const double foundation = scenario.water.density * scenario.general.gravity;
    std::vector<Row> rows;
    for (const double cfm : options.cfm) {
        scenario.joint.cfm = cfm;
        for (const std::string& word : options.loads) {
            const BeamLoad load = load_of(word);
            // Shear and compression act on one element; a longer beam would only bend or transmit them.
            const std::vector<int> lengths = load == BeamLoad::bending ? options.elements : std::vector<int>{1};
            for (const int elements : lengths) {
                const BeamTest test{
                    .load = load, .elements = elements, .floating = options.floating && load == BeamLoad::bending};
                const double elastic = test.floating ? floating_cantilever_factor(options.modulus * unit::megapascal,
                                                                                  elements * scenario.floe.element,
                                                                                  scenario.ice.thickness, foundation)
                                                     : 1.0;
                rows.push_back({cfm, measure_beam_strength(scenario, test), elastic});
            }
        }
    }
    return rows;
}

std::string to_json(const std::vector<Row>& rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
        list.push_back({{"mode", failure_mode_names.at(static_cast<std::size_t>(row.shown.mode))},
                        {"cfm", row.cfm},
                        {"length_m", row.shown.length},
                        {"load_N", row.shown.load},
                        {"strength_kPa", row.shown.strength / unit::kilopascal},
                        {"set_kPa", row.shown.set / unit::kilopascal},
                        {"joint", row.shown.joint},
                        {"elastic_foundation_ratio", row.elastic}});
    }
    return nlohmann::ordered_json{{"rows", list}}.dump(2) + "\n";
}

std::string to_table(const std::vector<Row>& rows, const CantileverOptions& options) {
    std::string text = "        Σ  mode         length    load  strength      set  shown/set";
    text += options.floating ? "  elastic beam\n" : "\n";
    text += "                             m       N       kPa      kPa\n";
    for (const Row& row : rows) {
        text += fmt::format("{:9.4g}  {:<11} {:7.3g} {:7.4g} {:9.2f} {:8.2f} {:10.3f}", row.cfm,
                            failure_mode_names.at(static_cast<std::size_t>(row.shown.mode)), row.shown.length,
                            row.shown.load, row.shown.strength / unit::kilopascal, row.shown.set / unit::kilopascal,
                            row.shown.strength / row.shown.set);
        text += options.floating ? fmt::format(" {:13.3f}\n", row.elastic) : "\n";
    }
    return text;
}

}  // namespace

void add_cantilever(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<CantileverOptions>();
    CLI::App* verb =
        program.add_subcommand("cantilever", "Measured strength of a numerical beam, compared with its input strength");
    CLI::Option* config = verb->add_option("config", options->config,
                                           "Test the ice of this configuration's first case; default: the paper's ice");
    add_overrides(*verb, options->overrides)->needs(config);
    verb->add_option("--cfm", options->cfm, "Values of Σ, comma-separated")->delimiter(',')->capture_default_str();
    verb->add_option("--elements", options->elements, "Lengths of the beam in elements, comma-separated")
        ->delimiter(',')
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    verb->add_option("--load", options->loads, "bending, shear, compression, comma-separated")
        ->delimiter(',')
        ->check(CLI::IsMember({"bending", "shear", "compression"}));
    CLI::Option* floating = verb->add_flag("--floating", options->floating,
                                           "Bend a floating beam (lifted at its tip) instead of a dry one");
    verb->add_option("--modulus-MPa", options->modulus,
                     "Modulus of the elastic beam on a foundation used for comparison")
        ->needs(floating)
        ->capture_default_str();
    verb->add_option("--format", options->format, "table or json")
        ->check(CLI::IsMember({"table", "json"}))
        ->capture_default_str();
    verb->footer(
        "The beam is one element wide and clamped at one end. Bending: strength = 6 P L/(b h²), L from the load to "
        "the\n"
        "failing joint. Shear and compression: P/(b h), or P/(b h²) with joint.threshold_form = \"as_printed\".");
    verb->callback([options, &exit_status] {
        const std::vector<Row> rows = measure(*options);
        std::fputs((options->format == "json" ? to_json(rows) : to_table(rows, *options)).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
