// floes calibrate: the plate-deflection test. Σ to E as in Fig. 2, and back.

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/config_file.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "laboratory/calibration.hpp"

namespace floes {
namespace {

/// An empty list means the configuration's value; given values are combined with each other.
struct CalibrateOptions {
    std::string config;
    std::vector<std::string> overrides;
    std::vector<double> sheets{5.4, 2.8, 2.6};
    std::vector<double> cfm{1e-10, 0.016, 0.03};
    std::vector<double> elements;
    std::vector<double> thicknesses;
    std::vector<double> time_steps;
    std::vector<double> erps;
    std::vector<int> iterations;
    double load = PlateTest{}.load;
    double modulus = 0;
    std::string format = "table";
};

struct PointPlan {
    Scenario scenario;
    PlateTest test;
};

/// Without a configuration: the paper's ice as a plate of 0.030 m, as tested in its Fig. 2.
Scenario base_scenario(const CalibrateOptions& options) {
    if (!options.config.empty()) return load_campaign(options.config, options.overrides).cases.front().scenario;
    Scenario scenario;
    scenario.ice.thickness = 0.030;
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

std::vector<PointPlan> make_plans(const CalibrateOptions& options) {
    std::vector<PointPlan> plans{{base_scenario(options), {.load = options.load}}};
    vary(plans, options.elements, [](PointPlan& plan, double value) { plan.scenario.floe.element = value; });
    vary(plans, options.thicknesses, [](PointPlan& plan, double value) { plan.scenario.ice.thickness = value; });
    vary(plans, options.time_steps, [](PointPlan& plan, double value) { plan.scenario.general.time_step = value; });
    vary(plans, options.erps, [](PointPlan& plan, double value) { plan.scenario.joint.erp = value; });
    vary(plans, options.iterations, [](PointPlan& plan, int value) { plan.scenario.general.iterations = value; });
    vary(plans, options.sheets, [](PointPlan& plan, double value) { plan.test.sheet = value; });
    vary(plans, options.cfm, [](PointPlan& plan, double value) { plan.scenario.joint.cfm = value; });
    return plans;
}

std::vector<CurvePoint> measure(const std::vector<PointPlan>& plans) {
    std::vector<CurvePoint> curve(plans.size());
    tbb::parallel_for(std::size_t{0}, plans.size(),
                      [&](std::size_t i) { curve[i] = measure_curve_point(plans[i].scenario, plans[i].test); });
    return curve;
}

nlohmann::ordered_json to_json(const std::vector<CurvePoint>& curve) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const CurvePoint& point : curve) {
        rows.push_back({{"sheet_m", point.sheet},
                        {"element_m", point.element},
                        {"thickness_m", point.thickness},
                        {"time_step_s", point.time_step},
                        {"erp", point.erp},
                        {"iterations", point.iterations},
                        {"cfm", point.cfm},
                        {"slope_N_per_m", point.slope},
                        {"elastic_modulus_MPa", point.elastic_modulus / unit::megapascal},
                        {"elastic_modulus_point_MPa", point.elastic_modulus_point / unit::megapascal}});
    }
    return rows;
}

std::string to_table(const std::vector<CurvePoint>& curve) {
    std::string text =
        " sheet  element  thickness     Δt    Γ  iterations         Σ     dP/dw    E (patch)  E (point)\n"
        "     m        m          m      s                                N/m          MPa        MPa\n";
    for (const CurvePoint& p : curve) {
        text += fmt::format("{:6.4g} {:8.4g} {:10.4g} {:6.4g} {:4.2g} {:11} {:9.4g} {:9.0f} {:12.1f} {:10.1f}\n",
                            p.sheet, p.element, p.thickness, p.time_step, p.erp, p.iterations, p.cfm, p.slope,
                            p.elastic_modulus / unit::megapascal, p.elastic_modulus_point / unit::megapascal);
    }
    return text;
}

std::string curve_text(const CalibrateOptions& options) {
    const std::vector<CurvePoint> curve = measure(make_plans(options));
    if (options.format == "json") return nlohmann::ordered_json{{"curve", to_json(curve)}}.dump(2) + "\n";
    return to_table(curve);
}

/// The one ice whose Σ is to be found.
PointPlan plan_of_inverse(CalibrateOptions options) {
    options.sheets.resize(1);
    options.cfm.clear();
    const std::vector<PointPlan> plans = make_plans(options);
    if (plans.size() == 1) return plans.front();
    throw InputError(
        fmt::format("--modulus-MPa finds the Σ of one ice, but the given lists make {}; give one element size, "
                    "thickness, time step, Γ and number of iterations each.",
                    plans.size()));
}

std::string inverse_text(const CalibrateOptions& options) {
    const PointPlan plan = plan_of_inverse(options);
    const Calibration found = calibrate_cfm(plan.scenario, plan.test, options.modulus * unit::megapascal);
    if (options.format == "json") {
        return nlohmann::ordered_json{{"elastic_modulus_MPa", options.modulus},
                                      {"cfm", found.cfm},
                                      {"ceiling_MPa", found.ceiling / unit::megapascal},
                                      {"curve", to_json(found.curve)}}
                   .dump(2) +
               "\n";
    }
    return to_table(found.curve) +
           fmt::format("\nΣ = {:.4g} shows {:g} MPa (the ceiling of these iterations is {:.4g} MPa)\n", found.cfm,
                       options.modulus, found.ceiling / unit::megapascal);
}

}  // namespace

void add_calibrate(CLI::App& program, int& exit_status) {
    auto options = std::make_shared<CalibrateOptions>();
    CLI::App* verb = program.add_subcommand(
        "calibrate",
        "Elastic modulus of the numerical ice over Σ, Γ, Δt, iterations and element size (plate deflection, Fig. 2)");
    const auto list = [&](const char* name, auto& values, const char* help) {
        verb->add_option(name, values, help)->delimiter(',');
    };
    CLI::Option* config = verb->add_option(
        "config", options->config, "Test the ice of this configuration's first case; default: the paper's plate");
    add_overrides(*verb, options->overrides)->needs(config);
    list("--sheet-m", options->sheets, "Sides of the square sheet, m");
    CLI::Option* cfm = verb->add_option("--cfm", options->cfm, "Values of Σ")->delimiter(',');
    list("--element-m", options->elements, "Element sizes L_e, m");
    list("--thickness-m", options->thicknesses, "Thicknesses, m");
    list("--time-step-s", options->time_steps, "Time steps Δt, s");
    list("--erp", options->erps, "Values of Γ");
    list("--iterations", options->iterations, "Numbers of Gauss-Seidel sweeps");
    verb->add_option("--load-N", options->load, "Largest load on the centre, N")->capture_default_str();
    verb->add_option("--modulus-MPa", options->modulus,
                     "Inverse calibration: find the Σ that shows this modulus on the first sheet")
        ->excludes(cfm);
    verb->add_option("--format", options->format, "table or json")
        ->check(CLI::IsMember({"table", "json"}))
        ->capture_default_str();
    verb->footer(
        "Lists are comma-separated and every combination is measured. Without arguments: the paper's Σ on sheets of\n"
        "5.4, 2.8 and 2.6 m. E (patch) assumes that the load is spread over the loaded elements, E (point) a point\n"
        "load.\n\n"
        "  floes calibrate --sheet-m 2.6 --cfm 1e-10 --iterations 10,50,100     the ceiling set by the iterations\n"
        "  floes calibrate table3.toml --modulus-MPa 60                         Σ for an ice of 60 MPa");
    verb->callback([options, verb, &exit_status] {
        const bool inverse = verb->count("--modulus-MPa") > 0;
        std::fputs((inverse ? inverse_text(*options) : curve_text(*options)).c_str(), stdout);
        exit_status = 0;
    });
}

}  // namespace floes
