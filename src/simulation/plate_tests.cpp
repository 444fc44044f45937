#include "simulation/plate_tests.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "ice/ice_field.hpp"
#include "ice/scenario_world.hpp"
#include "theory/plate.hpp"
#include "water/water_model.hpp"

namespace floes {

namespace {

// Only the state at rest matters: damping shortens the settling and has no effect at rest. 0.7 of critical settles
// fastest.
constexpr double settling_damping = 0.7;

int elements_across(const Scenario& scenario, double sheet) {
    const double exact = sheet / scenario.floe.element;
    const double whole = std::round(exact);
    if (whole < 2 || std::abs(exact - whole) > 1e-6 * whole)
        throw InputError(
            fmt::format("A sheet of {} m is {:.6g} elements of {} m; it must be a whole number of them, at least 2. "
                        "Try {:.6g} m or {:.6g} m.",
                        sheet, exact, scenario.floe.element, std::max(2.0, std::floor(exact)) * scenario.floe.element,
                        std::max(2.0, std::ceil(exact)) * scenario.floe.element));
    return static_cast<int>(whole);
}

Scenario sheet_scenario(Scenario scenario, double sheet) {
    scenario.floe.length = sheet;
    scenario.floe.breadth = sheet;
    scenario.water.flow = WaterFlow::still;
    scenario.water.heave_damping = settling_damping;
    return scenario;
}

/// The elements that carry the load, as indices within the sheet, and the corner of each that meets the centre.
struct LoadedElement {
    std::size_t index;
    Vec3 centre_arm;  ///< from the element's centre to the centre of the sheet, element axes, m
};

/// Between beams the middle of four elements lies half as far along their tangents as it is away from their centres.
std::vector<LoadedElement> loaded_elements(int across, const Scenario& scenario) {
    const auto index = [&](int i, int k) { return static_cast<std::size_t>(i + k * across); };
    const int middle = across / 2;
    if (across % 2 == 1) return {{index(middle, middle), Vec3::Zero()}};
    const double half = scenario.floe.element / (scenario.joint.model == JointModel::beam ? 4 : 2);
    return {{index(middle - 1, middle - 1), {half, 0, half}},
            {index(middle, middle - 1), {-half, 0, half}},
            {index(middle - 1, middle), {half, 0, -half}},
            {index(middle, middle), {-half, 0, -half}}};
}

class Sheet {
  public:
    Sheet(const Scenario& scenario, int across)
        : scenario_(scenario),
          world_(scenario_world(scenario)),
          ice_(world_, scenario, floes_at(scenario, std::vector<PlanarPose>(1))),
          water_(scenario.water, scenario.general.gravity, {scenario.floe.element, scenario.floe.thickness},
                 scenario.floe.element_mass(scenario.ice), 0, 0),
          loaded_(loaded_elements(across, scenario)) {}

    /// Depth of the centre of the sheet below its initial height, at rest under a total load, m.
    double settled_depth(double load) {
        const auto depth =
            settle([&] { advance(load); }, [&] { return checked_depth(load); }, 0.0, size_of_ice(scenario_));
        if (!depth)
            throw InputError(fmt::format(
                "The sheet did not settle under {} N in {} steps; a larger Σ, a smaller load or fewer elements may.",
                load, most_looks * steps_between_looks));
        return *depth;
    }

  private:
    void advance(double load) {
        for (const IceElement& element : ice_.elements()) {
            const BodyState body = world_.state(element.body);
            world_.apply(element.body,
                         water_.wrench({body.position, body.rotation, body.velocity, body.angular_velocity, 0}, 0));
        }
        const Wrench share{.force = {0, -load / static_cast<double>(loaded_.size()), 0}};
        for (const LoadedElement& element : loaded_) world_.apply(ice_.elements()[element.index].body, share);
        world_.step();
        if (ice_.break_joints(world_, 0) > 0)
            throw InputError(fmt::format("The load of {} N breaks the sheet; try a smaller one.", load));
    }

    /// Below its freeboard the sheet is no longer a plate on a foundation.
    double checked_depth(double load) const {
        const double depth = start_height_ - centre_height();
        const double freeboard = scenario_.floe.thickness * (1 - scenario_.ice.density / scenario_.water.density);
        if (depth > freeboard)
            throw InputError(fmt::format(
                "The load of {} N sinks the middle of the sheet below its freeboard of {:.3g} m; try a smaller one.",
                load, freeboard));
        return depth;
    }

    double centre_height() const {
        double sum = 0;
        for (const LoadedElement& element : loaded_) {
            const BodyState body = world_.state(ice_.elements()[element.index].body);
            sum += (body.position + body.rotation * element.centre_arm).y();
        }
        return sum / static_cast<double>(loaded_.size());
    }

    Scenario scenario_;
    World world_;
    IceField ice_;
    WaterModel water_;
    std::vector<LoadedElement> loaded_;
    double start_height_ = centre_height();
};

double slope_through_origin(const PlateDeflection& result) {
    double product = 0;
    double square = 0;
    for (std::size_t i = 0; i < result.load.size(); ++i) {
        product += result.load[i] * result.deflection[i];
        square += result.deflection[i] * result.deflection[i];
    }
    return product / square;
}

}  // namespace

PlateTest plate_test_for(const Scenario& scenario) {
    const double size = size_of_ice(scenario);
    PlateTest test;
    test.sheet *= size;
    test.load *= size * size * size;
    return test;
}

PlateTest whole_plate_test(const Scenario& scenario) {
    PlateTest test = plate_test_for(scenario);
    // Slightly enlarged, so that rounding does not lose an element if the elements divide the sheet.
    test.sheet = std::floor(test.sheet / scenario.floe.element * (1 + 1e-9)) * scenario.floe.element;
    return test;
}

PlateDeflection measure_plate_deflection(const Scenario& scenario, const PlateTest& test) {
    if (!(test.load > 0) || test.increments < 1)
        throw InputError(fmt::format("A plate test needs a load above 0 N in at least 1 increment, not {} N in {}.",
                                     test.load, test.increments));
    const int across = elements_across(scenario, test.sheet);
    Sheet sheet(sheet_scenario(scenario, test.sheet), across);
    const double unloaded = sheet.settled_depth(0);
    PlateDeflection result;
    for (int i = 1; i <= test.increments; ++i) {
        result.load.push_back(test.load * i / test.increments);
        result.deflection.push_back(sheet.settled_depth(result.load.back()) - unloaded);
    }
    const FloatingPlate plate{.thickness = scenario.floe.thickness,
                              .water_density = scenario.water.density,
                              .gravity = scenario.general.gravity};
    const double loaded_area = (across % 2 == 1 ? 1 : 4) * scenario.floe.element * scenario.floe.element;
    result.slope = slope_through_origin(result);
    result.elastic_modulus = modulus_from_patch_slope(plate, result.slope, std::sqrt(loaded_area / std::numbers::pi));
    result.elastic_modulus_point = modulus_from_point_slope(plate, result.slope);
    return result;
}

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
