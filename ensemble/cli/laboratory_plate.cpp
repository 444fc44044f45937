// floes laboratory plate: the plate-deflection test. Σ to E as in Fig. 2, and back.

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
#include "driver/measure_curve.hpp"
#include "laboratory/calibration.hpp"
#include "scenario/keys.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// An empty list stands for the configuration's value; every combination of given values is measured.
struct PlateOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> sheets{5.4, 2.8, 2.6};
    std::vector<double> cfm{1e-10, 0.016, 0.03};
    std::vector<double> moduli{200, 60, 30};
    std::vector<double> elements;
    std::vector<double> thicknesses;
    std::vector<double> time_steps;
    std::vector<double> erps;
    std::vector<int> iterations;
    double load = PlateTest{}.load;
    double modulus = 0;
    std::string format = "table";
};

/// Without a configuration: the paper's ice as a plate of 0.030 m, as tested in its Fig. 2.
Scenario base_scenario(const PlateOptions& options) {
    if (!options.config.empty()) return load_campaign(options.config, options.overrides).cases.front().scenario;
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
    std::vector<PointPlan> plans{{base_scenario(options), {.load = options.load}}};
    vary(plans, options.elements, [](PointPlan& plan, double value) { plan.scenario.floe.element = value; });
    vary(plans, options.thicknesses, [](PointPlan& plan, double value) { plan.scenario.floe.thickness = value; });
    vary(plans, options.time_steps, [](PointPlan& plan, double value) { plan.scenario.general.time_step = value; });
    vary(plans, options.erps, [](PointPlan& plan, double value) { plan.scenario.joint.erp = value; });
    vary(plans, options.iterations, [](PointPlan& plan, int value) { plan.scenario.general.iterations = value; });
    vary(plans, options.sheets, [](PointPlan& plan, double value) { plan.test.sheet = value; });
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

std::string model_word(const CurvePoint& point) {
    return point.model == JointModel::beam ? "beam" : "cfm";
}

Section curve_section(const std::vector<CurvePoint>& curve) {
    Table table{{"joints", "sheet, m", "element, m", "thickness, m", "Δt, s", "Γ", "iterations", "Σ", "E set, MPa",
                 "dP/dw, N/m", "E (patch), MPa", "E (point), MPa"}};
    const auto number = [](double value) { return fmt::format("{:.4g}", value); };
    for (const CurvePoint& p : curve) {
        const bool beam = p.model == JointModel::beam;
        table.push_back({model_word(p), number(p.sheet), number(p.element), number(p.thickness), number(p.time_step),
                         beam ? "" : number(p.erp), beam ? "" : fmt::format("{}", p.iterations),
                         beam ? "" : number(p.cfm), beam ? number(p.set_modulus / unit::megapascal) : "",
                         fixed(p.slope, 0), fixed(p.elastic_modulus / unit::megapascal, 1),
                         fixed(p.elastic_modulus_point / unit::megapascal, 1)});
    }
    using Row = const CurvePoint&;
    return {
        .table = std::move(table),
        .records = {make_rows<CurvePoint>(
            "curve", curve,
            {{"joint_model", [](Row row) { return model_word(row); }},
             {"sheet_m", &CurvePoint::sheet},
             {"element_m", &CurvePoint::element},
             {"thickness_m", &CurvePoint::thickness},
             {"time_step_s", &CurvePoint::time_step},
             {"erp", &CurvePoint::erp},
             {"iterations", &CurvePoint::iterations},
             {"cfm", &CurvePoint::cfm},
             {"set_modulus_MPa",
              [](Row row) { return row.model == JointModel::beam ? row.set_modulus / unit::megapascal : NAN; }},
             {"slope_N_per_m", &CurvePoint::slope},
             {"elastic_modulus_MPa", [](Row row) { return row.elastic_modulus / unit::megapascal; }},
             {"elastic_modulus_point_MPa", [](Row row) { return row.elastic_modulus_point / unit::megapascal; }}})}};
}

/// The ice for which Σ is sought. Throws InputError if the lists describe several.
PointPlan plan_of_inverse(PlateOptions options) {
    options.sheets.resize(1);
    options.cfm.clear();
    options.moduli.clear();
    const std::vector<PointPlan> plans = make_plans(options);
    if (plans.size() == 1) return plans.front();
    throw InputError(
        fmt::format("--modulus-MPa finds the Σ of one ice, but the given lists make {}; give one element size, "
                    "thickness, time step, Γ and number of iterations each.",
                    plans.size()));
}

std::string inverse_text(const PlateOptions& options) {
    const PointPlan plan = plan_of_inverse(options);
    const Calibration found = calibrate_cfm(plan.scenario, plan.test, options.modulus * unit::megapascal);
    Section section = curve_section(found.curve);
    section.records.insert(
        section.records.begin(),
        make_object<Calibration>(
            "", found,
            {{Names{"", "elastic_modulus_MPa"}, [&](const Calibration&) { return options.modulus; }},
             {Names{"", "cfm"}, &Calibration::cfm},
             {Names{"", "ceiling_MPa"}, [](const Calibration& one) { return one.ceiling / unit::megapascal; }}}));
    section.after = fmt::format("\nΣ = {:.4g} shows {:g} MPa (the ceiling of these iterations is {:.4g} MPa)\n",
                                found.cfm, options.modulus, found.ceiling / unit::megapascal);
    return written({section}, options.format);
}

std::string curve_text(const PlateOptions& options) {
    return written({curve_section(measure_curve(make_plans(options)))}, options.format);
}

}  // namespace

void add_plate(Verb& laboratory) {
    auto options = std::make_shared<PlateOptions>();
    Verb verb = laboratory.inner(
        "plate",
        "Elastic modulus of the numerical ice over Σ, Γ, Δt, iterations and element size (plate deflection, Fig. 2), "
        "and of ice with beam joints");
    const auto list = [&](const char* name, auto& values, const char* help) {
        verb.option(name, values, help).comma_separated();
    };
    Option config = verb.option("config", options->config,
                                "Test the ice of this configuration's first case; default: the paper's plate");
    add_overrides(verb, options->overrides).needs(config);
    list("--sheet-m", options->sheets, "Sides of the square sheet, m");
    const Option cfm = verb.option("--cfm", options->cfm, "Values of Σ, joint.model = \"cfm\"").comma_separated();
    const Option beams =
        verb.option("--beam-MPa", options->moduli, "Moduli of beam joints, joint.model = \"beam\", solved exactly")
            .comma_separated();
    list("--element-m", options->elements, "Element sizes L_e, m");
    list("--thickness-m", options->thicknesses, "Thicknesses, m");
    list("--time-step-s", options->time_steps, "Time steps Δt, s");
    list("--erp", options->erps, "Values of Γ");
    list("--iterations", options->iterations, "Numbers of Gauss-Seidel sweeps");
    verb.option("--load-N", options->load, "Largest load on the centre, N").shows_default();
    const Option modulus = verb.option("--modulus-MPa", options->modulus,
                                       "Inverse calibration: find the Σ that shows this modulus on the first sheet")
                               .excludes(cfm)
                               .excludes(beams);
    add_format(verb, options->format);
    verb.footer(
        "Lists are comma-separated and every combination is measured. Without arguments: the paper's Σ on sheets of\n"
        "5.4, 2.8 and 2.6 m, and beam joints of 200, 60 and 30 MPa. E (patch) assumes that the load is spread over "
        "the\n"
        "loaded elements, which is right for joints that follow Σ; E (point) a point load, which is right for beams "
        "from\n"
        "centre to centre (docs/ice.md).\n\n"
        "  floes laboratory plate --sheet-m 2.6 --cfm 1e-10 --iterations 10,50,100   the ceiling set by the "
        "iterations\n"
        "  floes laboratory plate --sheet-m 5.1 --element-m 0.3,0.1 --beam-MPa 60    beam joints, whatever the "
        "element\n"
        "  floes laboratory plate table3.toml --modulus-MPa 60                       Σ for an ice of 60 MPa");
    verb.runs([options, cfm, beams, modulus] {
        // If only one of the two is given, only sheets with these joints are measured.
        if (cfm.given() && !beams.given()) options->moduli.clear();
        if (beams.given() && !cfm.given()) options->cfm.clear();
        const bool inverse = modulus.given();
        std::fputs((inverse ? inverse_text(*options) : curve_text(*options)).c_str(), stdout);
        return 0;
    });
}

}  // namespace floes
