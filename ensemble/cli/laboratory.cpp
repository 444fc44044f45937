// floes laboratory: plates that bend and cantilevers that break, on numerical ice.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include <tbb/info.h>

#include "cli/commands.hpp"
#include "run/calibrate.hpp"
#include "scenario/keys.hpp"
#include "simulation/laboratory.hpp"
#include "theory/plate.hpp"

namespace floes {

namespace {

std::vector<double> cfm_of_paper() {
    return {1e-10, 0.016, 0.03};
}

/// The configuration's first case, with what it leaves open of E and Σ as floes run finds it, as far as that is asked.
Scenario first_case(const std::string& config, const std::vector<std::string>& overrides, bool cfm, bool modulus) {
    Campaign campaign = load_campaign(config, overrides);
    campaign.cases.resize(1);
    const Pairing pairing = campaign.cases.front().pairing;
    const int threads = tbb::info::default_concurrency();
    Progress progress(std::cerr, style_of_standard_error());
    if (cfm && pairing == Pairing::find_cfm) calibrate_campaign(campaign, {}, threads, progress);
    if (modulus && pairing == Pairing::find_modulus) settle_moduli(campaign, threads, progress);
    return campaign.cases.front().scenario;
}

/// Empty lists of Σ and moduli stand for the ice's own.
struct CantileverOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> cfm;
    std::vector<int> elements{1, 2, 3, 4};
    std::vector<std::string> loads{"bending", "shear", "compression"};
    std::vector<double> moduli;
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
    return first_case(options.config, options.overrides, !options.stiffness && options.cfm.empty(),
                      options.moduli.empty() && (options.stiffness || options.floating));
}

/// Pa, of the elastic beam for comparison. Beam joints bend as a strip of plate.
double compared_modulus(const Scenario& scenario, const CantileverOptions& options) {
    const double modulus =
        options.moduli.empty() ? scenario.ice.elastic_modulus : options.moduli.front() * unit::megapascal;
    const double ratio = scenario.joint.model == JointModel::beam ? scenario.ice.poisson_ratio : 0;
    return modulus / (1 - ratio * ratio);
}

std::vector<Row> measure(Scenario scenario, const std::vector<double>& cfms, const CantileverOptions& options) {
    if (options.moduli.size() > 1)
        throw InputError("The elastic beam for comparison has one modulus; give a single --modulus-MPa.");
    const double foundation = scenario.water.density * scenario.general.gravity;
    std::vector<Row> rows;
    const bool beams = scenario.joint.model == JointModel::beam;  // which have no Σ
    for (const double cfm : beams ? std::vector<double>{NAN} : cfms) {
        if (!beams) scenario.joint.cfm = cfm;
        for (const std::string& word : options.loads) {
            const BeamLoad load = load_of(word);
            // Shear and compression act on one element; a longer beam would only bend or transmit them.
            const std::vector<int> lengths = load == BeamLoad::bending ? options.elements : std::vector<int>{1};
            for (const int elements : lengths) {
                const BeamTest test{
                    .load = load, .elements = elements, .floating = options.floating && load == BeamLoad::bending};
                const double elastic = test.floating ? floating_cantilever_factor(compared_modulus(scenario, options),
                                                                                  elements * scenario.floe.element,
                                                                                  scenario.floe.thickness, foundation)
                                                     : 1.0;
                rows.push_back({cfm, measure_beam_strength(scenario, test), elastic});
            }
        }
    }
    return rows;
}

/// Of the given ice, or of the default ice with its beam joints and the paper's with each Σ.
std::vector<Row> measure_all(const CantileverOptions& options) {
    const Scenario scenario = base_scenario(options);
    if (!options.config.empty())
        return measure(scenario, options.cfm.empty() ? std::vector{scenario.joint.cfm} : options.cfm, options);
    std::vector<Row> rows = measure(Scenario{}, {}, options);
    for (const Row& row : measure(scenario, options.cfm.empty() ? cfm_of_paper() : options.cfm, options))
        rows.push_back(row);
    return rows;
}

Section section_of(const std::vector<Row>& rows, bool floating) {
    Results results{
        .place = "rows",
        .columns = {{"", "Σ"},
                    {"mode", "mode"},
                    {"cfm"},
                    {.key = "length_m", .words = "length", .unit = "m", .digits = 3},
                    {.key = "load_N", .words = "load", .unit = "N", .digits = 4},
                    {.key = "strength_kPa", .words = "strength, kPa", .decimals = 2},
                    {.key = "set_kPa", .words = "set, kPa", .decimals = 2},
                    {"joint"},
                    {.words = "shown/set", .decimals = 3},
                    {.key = "elastic_foundation_ratio", .words = floating ? "elastic beam" : "", .decimals = 3}}};
    for (const Row& row : rows)
        results.add({std::isnan(row.cfm) ? "beam" : fmt::format("{:.4g}", row.cfm),
                     failure_mode_names.at(static_cast<std::size_t>(row.shown.mode)), row.cfm, row.shown.length,
                     row.shown.load, row.shown.strength / unit::kilopascal, row.shown.set / unit::kilopascal,
                     row.shown.joint, row.shown.strength / row.shown.set, row.elastic});
    return {.results = {std::move(results)}};
}

Section stiffness_section(const CantileverOptions& options) {
    const Scenario scenario = base_scenario(options);
    Results results{.place = "rows",
                    .columns = {{.key = "elastic_modulus_MPa", .words = "E, MPa", .digits = 6},
                                {"elements", "elements"},
                                {.key = "deflection_m", .words = "deflection", .unit = "m", .digits = 4},
                                {.key = "elastic_deflection_m", .words = "elastic", .unit = "m", .digits = 4},
                                {.words = "shown/elastic", .decimals = 4},
                                {.key = "frequency_1_per_s", .words = "frequency", .unit = "1/s", .decimals = 3},
                                {.key = "elastic_frequency_1_per_s", .words = "elastic", .unit = "1/s", .decimals = 3},
                                {.words = "shown/elastic", .decimals = 4}}};
    const std::vector own{scenario.ice.elastic_modulus / unit::megapascal};
    for (const double modulus : options.moduli.empty() ? own : options.moduli) {
        const Scenario beam = with_beam_joints(scenario, modulus * unit::megapascal);
        for (const int elements : options.elements) {
            const BeamStiffness shown = measure_beam_stiffness(beam, elements);
            results.add({modulus, elements, shown.deflection, shown.elastic_deflection,
                         shown.deflection / shown.elastic_deflection, shown.frequency, shown.elastic_frequency,
                         shown.frequency / shown.elastic_frequency});
        }
    }
    return {.results = {std::move(results)}};
}

void add_cantilever(Verb& laboratory) {
    auto options = std::make_shared<CantileverOptions>();
    Verb verb =
        laboratory.inner("cantilever", "Measured strength of a numerical beam, compared with its input strength");
    Option config =
        verb.option("config", options->config,
                    "Test the ice of this configuration's first case; default: the default ice, with beam joints, "
                    "and the paper's with each Σ");
    add_overrides(verb, options->overrides).needs(config);
    verb.option(
            "--cfm", options->cfm,
            "Values of Σ, comma-separated; of joints that have it. Default: the configuration's own, or the paper's "
            "1e-10,0.016,0.03")
        .comma_separated();
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
                "beam joints, comma-separated. Default: that of the ice")
        .comma_separated();
    add_format(verb, options->format);
    verb.footer(
        "The beam is one element wide and clamped at one end. Bending: strength = 6 P L/(b h²), L from the load to "
        "the\n"
        "failing joint. With --stiffness: dry, the load at the middle of the last element. Shear and compression: P/(b "
        "h), or P/(b h²) with paper.threshold_form = \"as_printed\". Beam joints are compared with a strip of plate, "
        "1/(1 - ν²)\nstiffer than a beam.");
    verb.prints([options] {
        return written(
            {options->stiffness ? stiffness_section(*options) : section_of(measure_all(*options), options->floating)},
            options->format);
    });
}

// floes laboratory plate: the plate-deflection test. Σ to E as in Fig. 2, and back.

/// An empty list stands for the configuration's value, of sheets for the one that calibrates its ice; every combination
/// of given values is measured.
struct PlateOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> sheets;
    std::vector<double> cfm;
    std::vector<double> moduli;
    std::vector<double> elements;
    std::vector<double> thicknesses;
    std::vector<double> time_steps;
    std::vector<double> erps;
    std::vector<int> iterations;
    std::optional<double> load;
    std::optional<double> modulus;
    std::string format = "table";

    bool own_joints() const { return cfm.empty() && moduli.empty() && !modulus; }
};

/// Without a configuration: the paper's ice as a plate of 0.030 m, as tested in its Fig. 2.
Scenario base_scenario(const PlateOptions& options) {
    if (!options.config.empty()) return first_case(options.config, options.overrides, options.own_joints(), false);
    Scenario scenario = paper_scenario();
    scenario.floe.thickness = 0.030;
    return scenario;
}

/// One plan for each existing plan and each value of the list.
template <class Value, class Set>
void vary(std::vector<PointPlan>& plans, const std::vector<Value>& values, Set set) {
    if (values.empty()) return;
    std::vector<PointPlan> varied;
    for (const PointPlan& plan : plans) {
        for (const Value& value : values) {
            varied.push_back(plan);
            set(varied.back(), value);
        }
    }
    plans = std::move(varied);
}

/// Sheets with both kinds of joints: stiffness by Σ, and beams of a given modulus.
std::vector<PointPlan> make_plans(const PlateOptions& options) {
    std::vector<PointPlan> plans{{base_scenario(options), {}}};
    vary(plans, options.elements, [](PointPlan& plan, double value) { plan.scenario.floe.element = value; });
    vary(plans, options.thicknesses, [](PointPlan& plan, double value) { plan.scenario.floe.thickness = value; });
    vary(plans, options.time_steps, [](PointPlan& plan, double value) { plan.scenario.general.time_step = value; });
    vary(plans, options.erps, [](PointPlan& plan, double value) { plan.scenario.joint.erp = value; });
    vary(plans, options.iterations, [](PointPlan& plan, int value) { plan.scenario.general.iterations = value; });
    for (PointPlan& plan : plans) {
        if (!options.config.empty()) plan.test = whole_plate_test(plan.scenario);
        plan.test.load = options.load.value_or(plan.test.load);
    }
    vary(plans, options.sheets, [](PointPlan& plan, double value) { plan.test.sheet = value; });
    if (options.own_joints()) return plans;
    std::vector<PointPlan> beams = options.moduli.empty() ? std::vector<PointPlan>{} : plans;
    vary(beams, options.moduli, [](PointPlan& plan, double value) {
        plan.scenario = with_beam_joints(plan.scenario, value * unit::megapascal);
    });
    for (PointPlan& plan : plans) plan.scenario.joint.model = JointModel::cfm;
    if (options.cfm.empty() && !options.moduli.empty()) plans.clear();
    vary(plans, options.cfm, [](PointPlan& plan, double value) { plan.scenario.joint.cfm = value; });
    plans.insert(plans.end(), beams.begin(), beams.end());
    return plans;
}

Section curve_section(const std::vector<CurvePoint>& curve) {
    const auto four = [](std::string key, std::string words, std::string unit = "1") {
        return ResultColumn{.key = std::move(key), .words = std::move(words), .unit = std::move(unit), .digits = 4};
    };
    Results results{.place = "curve",
                    .columns = {{"joint_model", "joints"},
                                four("sheet_m", "sheet", "m"),
                                four("element_m", "element", "m"),
                                four("thickness_m", "thickness", "m"),
                                four("time_step_s", "Δt", "s"),
                                four("erp", "Γ"),
                                {"iterations", "iterations"},
                                four("cfm", "Σ"),
                                four("set_modulus_MPa", "E set, MPa"),
                                {.key = "slope_N_per_m", .words = "dP/dw", .unit = "N m-1", .decimals = 0},
                                {.key = "elastic_modulus_MPa", .words = "E (patch), MPa", .decimals = 1},
                                {.key = "elastic_modulus_point_MPa", .words = "E (point), MPa", .decimals = 1}}};
    for (const CurvePoint& p : curve) {
        const bool beam = p.model == JointModel::beam;
        results.add({beam ? "beam" : "cfm", p.sheet, p.element, p.thickness, p.time_step, if_known(!beam, p.erp),
                     if_known(!beam, p.iterations), if_known(!beam, p.cfm),
                     if_known(beam, p.set_modulus / unit::megapascal), p.slope, p.elastic_modulus / unit::megapascal,
                     p.elastic_modulus_point / unit::megapascal});
    }
    return {.results = {std::move(results)}};
}

/// The ice for which Σ is sought. Throws InputError if the lists describe several.
PointPlan plan_of_inverse(PlateOptions options) {
    options.sheets.resize(std::min<std::size_t>(1, options.sheets.size()));
    const std::vector<PointPlan> plans = make_plans(options);
    if (plans.size() == 1) return plans.front();
    throw InputError(
        fmt::format("--modulus-MPa finds the Σ of one ice, but the given lists make {}; give one element size, "
                    "thickness, time step, Γ and number of iterations each.",
                    plans.size()));
}

Section inverse_section(const PlateOptions& options) {
    const PointPlan plan = plan_of_inverse(options);
    const Calibration found = calibrate_cfm(plan.scenario, plan.test, *options.modulus * unit::megapascal);
    Section section = curve_section(found.curve);
    section.results.insert(section.results.begin(), object("", {{"elastic_modulus_MPa", *options.modulus},
                                                                {"cfm", found.cfm},
                                                                {"ceiling_MPa", found.ceiling / unit::megapascal}}));
    section.after = fmt::format("\nΣ = {:.4g} shows {:g} MPa (the ceiling of these iterations is {:.4g} MPa)\n",
                                found.cfm, *options.modulus, found.ceiling / unit::megapascal);
    return section;
}

void add_plate(Verb& laboratory) {
    auto options = std::make_shared<PlateOptions>();
    Verb verb = laboratory.inner(
        "plate",
        "Elastic modulus of the numerical ice over Σ, Γ, Δt, iterations and element size (plate deflection, Fig. 2), "
        "and of ice with beam joints");
    const auto list = [&](const char* name, auto& values, const char* help) {
        return verb.option(name, values, help).comma_separated();
    };
    Option config = verb.option("config", options->config,
                                "Test the ice of this configuration's first case; default: the paper's plate");
    add_overrides(verb, options->overrides).needs(config);
    list("--sheet-m", options->sheets, "Sides of the square sheet, m").positive();
    const Option cfm =
        verb.option("--cfm", options->cfm, "Values of Σ, joint.model = \"cfm\"").comma_separated().not_negative();
    const Option beams =
        verb.option("--beam-MPa", options->moduli, "Moduli of beam joints, joint.model = \"beam\", solved exactly")
            .comma_separated()
            .positive();
    list("--element-m", options->elements, "Element sizes L_e, m").positive();
    list("--thickness-m", options->thicknesses, "Thicknesses, m").positive();
    list("--time-step-s", options->time_steps, "Time steps Δt, s").positive();
    list("--erp", options->erps, "Values of Γ").not_negative();
    list("--iterations", options->iterations, "Numbers of Gauss-Seidel sweeps").within(1, 1000000);
    verb.option("--load-N", options->load,
                "Largest load on the centre, N; default: 3, and of a configuration as much as its ice is larger");
    verb.option("--modulus-MPa", options->modulus,
                "Inverse calibration: find the Σ that shows this modulus on the first sheet")
        .excludes(cfm)
        .excludes(beams);
    add_format(verb, options->format);
    verb.footer(
        "Lists are comma-separated and every combination is measured. Without arguments: the paper's Σ on sheets of\n"
        "5.4, 2.8 and 2.6 m, and beam joints of 200, 60 and 30 MPa. Of a configuration what is not given is its own, "
        "on\n"
        "the sheet of 5.4 m at its scale; a Σ that it leaves open is found as floes run finds it. E (patch) assumes "
        "that\n"
        "the load is spread over the loaded elements, which is right for joints that follow Σ; E (point) a point "
        "load,\n"
        "which is right for beams from centre to centre (docs/fracture.md).\n\n"
        "  floes laboratory plate --sheet-m 2.6 --cfm 1e-10 --iterations 10,50,100   the ceiling set by the "
        "iterations\n"
        "  floes laboratory plate --sheet-m 5.1 --element-m 0.3,0.1 --beam-MPa 60    beam joints, whatever the "
        "element\n"
        "  floes laboratory plate table3.toml --modulus-MPa 60                       Σ for an ice of 60 MPa");
    verb.prints([options] {
        if (options->config.empty()) {
            if (options->sheets.empty()) options->sheets = {5.4, 2.8, 2.6};
            if (options->own_joints()) {
                options->cfm = cfm_of_paper();
                options->moduli = {200, 60, 30};
            }
        }
        return written(
            {options->modulus ? inverse_section(*options) : curve_section(measure_curve(make_plans(*options)))},
            options->format);
    });
}

}  // namespace

void add_laboratory(CommandLine& line) {
    Verb verb = line.verb("laboratory", "Test the numerical ice by itself: its elastic modulus, its strength");
    add_plate(verb);
    add_cantilever(verb);
    verb.footer(
        "Both tests take the ice of a configuration's first case, or the paper's.\n\n"
        "  floes laboratory plate --modulus-MPa 60     the Σ with which a sheet shows 60 MPa\n"
        "  floes laboratory cantilever                 the strength of a beam\n"
        "  floes laboratory plate --help               options of a test");
    line.moved("calibrate", "laboratory plate");
    line.moved("cantilever", "laboratory cantilever");
}

}  // namespace floes
