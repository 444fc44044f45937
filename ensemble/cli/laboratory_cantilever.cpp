// floes laboratory cantilever: the measured strength of a numerical beam compared with its input strength.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "laboratory/beam_stiffness.hpp"
#include "laboratory/calibration.hpp"
#include "laboratory/cantilever.hpp"
#include "scenario/keys.hpp"
#include "tables/number_text.hpp"
#include "theory/beam.hpp"

namespace floes {
namespace {

struct CantileverOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> cfm{1e-10, 0.016, 0.03};
    std::vector<int> elements{1, 2, 3, 4};
    std::vector<std::string> loads{"bending", "shear", "compression"};
    std::vector<double> moduli{60};
    bool floating = false;
    bool stiffness = false;
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

Scenario base_scenario(const CantileverOptions& options) {
    if (options.config.empty()) return paper_scenario();
    return load_campaign(options.config, options.overrides).cases.front().scenario;
}

std::vector<Row> measure(const CantileverOptions& options) {
    Scenario scenario = base_scenario(options);
    if (options.moduli.size() != 1)
        throw InputError("The elastic beam for comparison has one modulus; give a single --modulus-MPa.");
    const double foundation = scenario.water.density * scenario.general.gravity;
    std::vector<Row> rows;
    const bool beams = scenario.joint.model == JointModel::beam;  // which have no Σ
    for (const double cfm : beams ? std::vector<double>{NAN} : options.cfm) {
        if (!beams) scenario.joint.cfm = cfm;
        for (const std::string& word : options.loads) {
            const BeamLoad load = load_of(word);
            // Shear and compression act on one element; a longer beam would only bend or transmit them.
            const std::vector<int> lengths = load == BeamLoad::bending ? options.elements : std::vector<int>{1};
            for (const int elements : lengths) {
                const BeamTest test{
                    .load = load, .elements = elements, .floating = options.floating && load == BeamLoad::bending};
                const double elastic = test.floating
                                           ? floating_cantilever_factor(options.moduli.front() * unit::megapascal,
                                                                        elements * scenario.floe.element,
                                                                        scenario.floe.thickness, foundation)
                                           : 1.0;
                rows.push_back({cfm, measure_beam_strength(scenario, test), elastic});
            }
        }
    }
    return rows;
}

Section section_of(const std::vector<Row>& rows, bool floating) {
    const auto mode_of = [](const Row& row) { return failure_mode_names.at(static_cast<std::size_t>(row.shown.mode)); };
    Table table{{"Σ", "mode", "length, m", "load, N", "strength, kPa", "set, kPa", "shown/set"}};
    if (floating) table.front().emplace_back("elastic beam");
    for (const Row& row : rows) {
        table.push_back({std::isnan(row.cfm) ? "beam" : fmt::format("{:.4g}", row.cfm), mode_of(row),
                         fmt::format("{:.3g}", row.shown.length), fmt::format("{:.4g}", row.shown.load),
                         fixed(row.shown.strength / unit::kilopascal, 2), fixed(row.shown.set / unit::kilopascal, 2),
                         fixed(row.shown.strength / row.shown.set, 3)});
        if (floating) table.back().emplace_back(fixed(row.elastic, 3));
    }
    return {.table = std::move(table),
            .records = {
                make_rows<Row>("rows", rows,
                               {{"mode", mode_of},
                                {"cfm", &Row::cfm},
                                {"length_m", [](const Row& row) { return row.shown.length; }},
                                {"load_N", [](const Row& row) { return row.shown.load; }},
                                {"strength_kPa", [](const Row& row) { return row.shown.strength / unit::kilopascal; }},
                                {"set_kPa", [](const Row& row) { return row.shown.set / unit::kilopascal; }},
                                {"joint", [](const Row& row) { return row.shown.joint; }},
                                {"elastic_foundation_ratio", &Row::elastic}})}};
}

struct StiffnessRow {
    double modulus;  ///< MPa
    int elements;
    BeamStiffness shown;
};

std::vector<StiffnessRow> measure_stiffness(const CantileverOptions& options) {
    const Scenario scenario = base_scenario(options);
    std::vector<StiffnessRow> rows;
    for (const double modulus : options.moduli) {
        const Scenario beam = with_beam_joints(scenario, modulus * unit::megapascal);
        for (const int elements : options.elements) {
            rows.push_back({modulus, elements, measure_beam_stiffness(beam, elements)});
        }
    }
    return rows;
}

Section stiffness_section(const std::vector<StiffnessRow>& rows) {
    Table table{{"E, MPa", "elements", "deflection, mm", "elastic, mm", "shown/elastic", "frequency, 1/s",
                 "elastic, 1/s", "shown/elastic"}};
    for (const auto& [modulus, elements, shown] : rows) {
        table.push_back({fmt::format("{:g}", modulus), fmt::format("{}", elements), fixed(1e3 * shown.deflection, 4),
                         fixed(1e3 * shown.elastic_deflection, 4),
                         fixed(shown.deflection / shown.elastic_deflection, 4), fixed(shown.frequency, 3),
                         fixed(shown.elastic_frequency, 3), fixed(shown.frequency / shown.elastic_frequency, 4)});
    }
    return {.table = std::move(table),
            .records = {make_rows<StiffnessRow>(
                "rows", rows,
                {{"elastic_modulus_MPa", &StiffnessRow::modulus},
                 {"elements", &StiffnessRow::elements},
                 {"deflection_m", [](const StiffnessRow& row) { return row.shown.deflection; }},
                 {"elastic_deflection_m", [](const StiffnessRow& row) { return row.shown.elastic_deflection; }},
                 {"frequency_1_per_s", [](const StiffnessRow& row) { return row.shown.frequency; }},
                 {"elastic_frequency_1_per_s", [](const StiffnessRow& row) { return row.shown.elastic_frequency; }}})}};
}

}  // namespace

void add_cantilever(Verb& laboratory) {
    auto options = std::make_shared<CantileverOptions>();
    Verb verb =
        laboratory.inner("cantilever", "Measured strength of a numerical beam, compared with its input strength");
    Option config = verb.option("config", options->config,
                                "Test the ice of this configuration's first case; default: the paper's ice");
    add_overrides(verb, options->overrides).needs(config);
    verb.option("--cfm", options->cfm, "Values of Σ, comma-separated").comma_separated().shows_default();
    verb.option("--elements", options->elements, "Lengths of the beam in elements, comma-separated")
        .comma_separated()
        .within(1, 100)
        .shows_default();
    verb.option("--load", options->loads, "bending, shear, compression, comma-separated")
        .comma_separated()
        .one_of({"bending", "shear", "compression"});
    Option floating =
        verb.flag("--floating", options->floating, "Bend a floating beam (lifted at its tip) instead of a dry one");
    verb.flag("--stiffness", options->stiffness,
              "Instead: how far a strip with beam joints bends, and how it swings, beside the closed form")
        .excludes(floating);
    verb.option("--modulus-MPa", options->moduli,
                "Modulus of the elastic beam on a foundation used for comparison; with --stiffness moduli of the "
                "beam joints, comma-separated")
        .comma_separated()
        .shows_default();
    add_format(verb, options->format);
    verb.footer(
        "The beam is one element wide and clamped at one end. Bending: strength = 6 P L/(b h²), L from the load to "
        "the\n"
        "failing joint. With --stiffness: dry, the load at the middle of the last element. Shear and compression: P/(b "
        "h), or P/(b h²) with paper.threshold_form = \"as_printed\".");
    verb.runs([options] {
        const Section section = options->stiffness ? stiffness_section(measure_stiffness(*options))
                                                   : section_of(measure(*options), options->floating);
        std::fputs(written({section}, options->format).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
