#include "laboratory/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace floes {
namespace {

constexpr double largest_cfm = 0.9;  // above it the sweeps hardly converge
constexpr double tolerance = 0.005;  // of E, relative
constexpr int most_tests = 24;

/// Runs the plate test for values of Σ and stores the points of the curve.
class Curve {
  public:
    Curve(const Scenario& scenario, const PlateTest& test) : scenario_(scenario), test_(test) {}

    /// ln E, Pa.
    double log_modulus(double cfm) {
        scenario_.joint.cfm = cfm;
        points_.push_back(measure_curve_point(scenario_, test_));
        return std::log(points_.back().elastic_modulus);
    }

    std::vector<CurvePoint> sorted() const {
        std::vector<CurvePoint> points = points_;
        std::ranges::sort(points, {}, &CurvePoint::cfm);
        return points;
    }

  private:
    Scenario scenario_;
    PlateTest test_;
    std::vector<CurvePoint> points_;
};

[[noreturn]] void refuse_above_ceiling(const Scenario& scenario, double wanted, double ceiling) {
    throw InputError(
        fmt::format("An elastic modulus of {:.6g} MPa is above {:.4g} MPa, the largest that elements of {} m reach "
                    "with {} iterations and a time step of {} s: sweeps that have not converged leave the ice soft "
                    "however small Σ is. Allowed is less; try more iterations or larger elements, or joints without "
                    "such a limit: joint.model = \"beam\" with general.solver = \"direct\".",
                    wanted / unit::megapascal, ceiling / unit::megapascal, scenario.floe.element,
                    scenario.general.iterations, scenario.general.time_step));
}

}  // namespace

Scenario plate_scenario(const Scenario& scenario) {
    Scenario plate;
    plate.general = scenario.general;
    plate.ice = scenario.ice;
    plate.floe.thickness = scenario.floe.thickness;
    plate.floe.element = scenario.floe.element;
    plate.joint = scenario.joint;
    plate.joint.cfm = Scenario{}.joint.cfm;
    plate.water.density = scenario.water.density;
    return plate;
}

std::vector<PointPlan> curve_plans(const Scenario& scenario) {
    constexpr double tested_cfm[]{vanishing_cfm, 0.003, 0.008, 0.016, 0.03, 0.06};
    constexpr int sheet_elements = 13;
    PlateTest test = plate_test_for(scenario);
    test.sheet = sheet_elements * scenario.floe.element;
    std::vector<PointPlan> plans;
    for (const double cfm : tested_cfm) {
        plans.push_back({scenario, test});
        plans.back().scenario.joint.cfm = cfm;
    }
    return plans;
}

Scenario with_beam_joints(Scenario scenario, double elastic_modulus) {
    scenario.general.solver = SolverKind::direct;
    scenario.joint.model = JointModel::beam;
    scenario.ice.elastic_modulus = elastic_modulus;
    scenario.contact = with_preset(scenario.contact, ContactPreset::physical);  // nothing touches; the solver has it
    return scenario;
}

CurvePoint measure_curve_point(const Scenario& scenario, const PlateTest& test) {
    const PlateDeflection result = measure_plate_deflection(scenario, test);
    return {.sheet = test.sheet,
            .element = scenario.floe.element,
            .thickness = scenario.floe.thickness,
            .time_step = scenario.general.time_step,
            .erp = scenario.joint.erp,
            .iterations = scenario.general.iterations,
            .cfm = scenario.joint.cfm,
            .slope = result.slope,
            .elastic_modulus = result.elastic_modulus,
            .elastic_modulus_point = result.elastic_modulus_point,
            .model = scenario.joint.model,
            .set_modulus = scenario.ice.elastic_modulus};
}

Calibration calibrate_cfm(const Scenario& scenario, const PlateTest& test, double elastic_modulus) {
    if (!(elastic_modulus > 0 && std::isfinite(elastic_modulus)))
        throw InputError(fmt::format("The requested elastic modulus is {} Pa; it must be above 0.", elastic_modulus));
    if (scenario.joint.model != JointModel::cfm)
        throw InputError(
            "Joints of the model beam have the elastic modulus that they are given; there is no Σ to find.");
    Curve curve(scenario, test);
    const double wanted = std::log(elastic_modulus);
    const double ceiling = curve.log_modulus(vanishing_cfm);
    if (wanted > ceiling) refuse_above_ceiling(scenario, elastic_modulus, std::exp(ceiling));

    // In ln Σ and ln E the curve is flat, then falls with slope -1. Walk down to a bracket, then regula falsi
    // (Illinois) inside it: E falls with Σ, so the bracket always holds the answer.
    double low = std::log(vanishing_cfm);
    double low_excess = ceiling - wanted;
    double high = std::log(1e-3);
    double high_excess = curve.log_modulus(std::exp(high)) - wanted;
    while (high_excess > 0) {
        if (high >= std::log(largest_cfm))
            throw InputError(
                fmt::format("An elastic modulus of {:.6g} MPa needs Σ above {}, where the sweeps do not converge; try "
                            "a larger modulus, smaller elements or a larger time step.",
                            elastic_modulus / unit::megapascal, largest_cfm));
        low = high;
        low_excess = high_excess;
        high = std::min(std::log(largest_cfm), high + std::max(0.7, high_excess));
        high_excess = curve.log_modulus(std::exp(high)) - wanted;
    }
    for (int tests = 0; tests < most_tests; ++tests) {
        const double middle = (low * high_excess - high * low_excess) / (high_excess - low_excess);
        const double excess = curve.log_modulus(std::exp(middle)) - wanted;
        if (std::abs(excess) <= tolerance) return {std::exp(middle), std::exp(ceiling), curve.sorted()};
        if (excess > 0) {
            low = middle;
            low_excess = excess;
            high_excess /= 2;
        } else {
            high = middle;
            high_excess = excess;
            low_excess /= 2;
        }
    }
    throw InputError(fmt::format("No Σ was found that gives {:.6g} MPa; the curve is not smooth with these iterations.",
                                 elastic_modulus / unit::megapascal));
}

}  // namespace floes
